// The inside of a worker process. Private to the worker pool.
#pragma once

#include <csignal>
#include <functional>
#include <string>
#include <sys/types.h>

namespace dob {

struct ChildOptions {
  int pipe;              // to send the answer home through
  pid_t parent;          // the worker ends with it
  long memory_limit_MB;  // address space [MB]; 0: none
  sigset_t signals;      // mask of the task
};

// Called right after the fork. Sends what the task returns, or why it does not: the text of an exception, also of one
// that leaves a noexcept function, or that the memory is used up.
[[noreturn]] void run_child(const ChildOptions& options, const std::function<std::string()>& task);

}  // namespace dob
