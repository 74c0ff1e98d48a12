#include "bench/worker_child.h"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <fcntl.h>
#include <new>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>

#include "bench/worker_message.h"

namespace dob {
namespace {

#if defined(DOB_SANITIZED)
constexpr bool kLimitsMemory = false;  // a sanitizer reserves terabytes of addresses for itself
#else
constexpr bool kLimitsMemory = true;
#endif

// For handlers, which get no arguments. Set in the worker, never in the batch.
int home = -1;
std::string no_memory_message;  // made while there is memory

[[noreturn]] void send_and_leave(std::string_view message) {
  while (!message.empty()) {
    const ssize_t n = ::write(home, message.data(), message.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    message.remove_prefix(static_cast<std::size_t>(n));
  }
  ::_exit(0);
}

void report_no_memory() {
  send_and_leave(no_memory_message);
}

void report_termination() {
  std::string reason = "std::terminate() was called";
  if (const std::exception_ptr thrown = std::current_exception()) {
    try {
      std::rethrow_exception(thrown);
    } catch (const std::exception& error) {
      reason = fmt::format("threw where nothing may be thrown: {}", error.what());
    } catch (...) {
      reason = "threw where nothing may be thrown, and no std::exception";
    }
  }
  send_and_leave(framed(false, reason));
}

void limit(decltype(RLIMIT_AS) resource, rlim_t most) {
  rlimit value{};
  ::getrlimit(resource, &value);
  value.rlim_cur = value.rlim_max = std::min(most, value.rlim_max);
  ::setrlimit(resource, &value);
}

void limit_memory(long limit_MB) {
  no_memory_message =
      framed(false, limit_MB > 0 ? fmt::format("out of memory: the limit is {} MB (--memory-limit)", limit_MB)
                                 : std::string("out of memory"));
  std::set_new_handler(report_no_memory);
  if (limit_MB > 0 && kLimitsMemory) limit(RLIMIT_AS, static_cast<rlim_t>(limit_MB) * 1'000'000);
}

// Nothing to read, and nothing that it prints comes between the batch's own output.
void redirect_standard_streams() {
  const int empty = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (empty >= 0) ::dup2(empty, STDIN_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

}  // namespace

void run_child(const ChildOptions& options, const std::function<std::string()>& task) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // no orphans when the batch itself is killed
  if (::getppid() != options.parent) ::_exit(1);
  ::setpgid(0, 0);  // Ctrl-C goes to the batch, which ends its children, and theirs
  home = options.pipe;
  std::set_terminate(report_termination);
  redirect_standard_streams();
  limit(RLIMIT_CORE, 0);
  limit_memory(options.memory_limit_MB);
  ::sigprocmask(SIG_SETMASK, &options.signals, nullptr);
  std::string message;
  try {
    message = framed(true, task());
  } catch (const std::exception& error) {
    message = framed(false, error.what());
  } catch (...) {
    message = framed(false, "unknown exception");
  }
  send_and_leave(message);
}

}  // namespace dob
