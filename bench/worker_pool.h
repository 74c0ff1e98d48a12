// Runs tasks in processes of their own, several at a time, so that one that crashes, hangs, exhausts the memory or
// talks nonsense is a result like any other. ODE's process-wide state makes processes, not threads, the unit of a trial
// anyway.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace dob {

struct TaskOutcome {
  bool ok = false;
  std::string output;  // what the task returned, if ok
  std::string reason;  // why there is none, if not: the exception's text, a signal's name, an exit code, a timeout
};

struct WorkerOptions {
  int jobs = 1;              // processes at a time
  double timeout_s = 0.0;    // [s] of wall time for one task; 0: none
  long memory_limit_MB = 0;  // of addresses for one task; 0: none
};

// Calls `task(i)` for i = 0 ... count - 1 in child processes and `done(i, outcome)` in this one, in the order in which
// the tasks end. A task ends when its process does: what that has started, and has not left its process group, is ended
// with it. On SIGINT or SIGTERM the children are ended, and the number of the signal is returned; 0 otherwise.
int run_in_processes(std::size_t count, const WorkerOptions& options,
                     const std::function<std::string(std::size_t)>& task,
                     const std::function<void(std::size_t, const TaskOutcome&)>& done);

}  // namespace dob
