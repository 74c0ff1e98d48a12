// One task in a process of its own: started, listened to, ended with all that it has started. Private to the worker
// pool.
#pragma once

#include <chrono>
#include <csignal>
#include <cstddef>
#include <functional>
#include <string>
#include <sys/types.h>

#include "bench/file_descriptor.h"
#include "bench/worker_pool.h"

namespace dob {

// Nothing here ever waits for the worker, nor for what it may have started: a stranger that holds the pipe open, a
// worker that closes it and goes on, or one that never stops writing costs no more than its own result.
class WorkerProcess {
 public:
  // Forks; the child runs `task` under `signals` as its mask, sends home what that returns or throws, and ends. Its
  // standard input is empty, its standard output is standard error. Throws std::system_error.
  WorkerProcess(const std::function<std::string()>& task, const WorkerOptions& options, const sigset_t& signals);

  int pipe() const noexcept { return pipe_.get(); }  // to be polled; -1 once nothing more can come

  // Takes what there is, and ends the worker once it has had its time or said too much.
  void attend();

  // The process itself; others that it has started may still be there.
  bool has_ended() const noexcept;

  // Of a worker that has ended. Ends what is left of its process group, and forgets the process.
  TaskOutcome outcome();

  // Ends the worker and its process group, whatever it is at.
  void end() noexcept;

 private:
  void receive();
  void kill_all() const noexcept;

  WorkerOptions options_;
  pid_t pid_ = -1;
  FileDescriptor pipe_;
  std::chrono::steady_clock::time_point started_;
  std::string received_;
  std::string ended_because_;  // by us; empty: it was left alone
};

}  // namespace dob
