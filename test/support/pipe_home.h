// For code that runs in a worker and means it ill.
#pragma once

#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace dob::test {

// The pipe through which the worker that calls this sends its result home: the one that may be written and that the
// batch, its parent, does not have under the same number. The batch closes its own writing end after the fork, which
// may be after this looks: hence several looks. -1 if there is none.
inline int pipe_home() {
  const auto what_is = [](pid_t process, int fd) {
    std::error_code nothing;
    return std::filesystem::read_symlink("/proc/" + std::to_string(process) + "/fd/" + std::to_string(fd), nothing)
        .string();
  };
  for (int look = 0; look < 5000; ++look) {
    for (int fd = 3; fd < 256; ++fd) {
      const std::string here = what_is(::getpid(), fd);
      const bool writable = (::fcntl(fd, F_GETFL) & O_ACCMODE) == O_WRONLY;
      if (writable && here.starts_with("pipe:") && here != what_is(::getppid(), fd)) return fd;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return -1;
}

[[noreturn]] inline void sleep_for_ever() {
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace dob::test
