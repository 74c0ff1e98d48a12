#include "results/run_lock.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "results/plain_files.h"
#include "results/store.h"

namespace dob {

RunLock::RunLock(const std::filesystem::path& dir) {
  const std::filesystem::path file = dir / kLockFile;
  require_plain_file(file);
  fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (fd_ < 0) throw StoreError(fmt::format("{}: {}", file.string(), std::generic_category().message(errno)));
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  if (::fcntl(fd_, F_SETLK, &lock) == 0) return;
  const int error = errno;
  ::fcntl(fd_, F_GETLK, &lock);
  ::close(fd_);
  if (error != EAGAIN && error != EACCES) {
    throw StoreError(fmt::format("{}: cannot lock: {}", file.string(), std::generic_category().message(error)));
  }
  throw StoreError(fmt::format("{}: another batch (process {}) is writing it", dir.string(), lock.l_pid));
}

RunLock::~RunLock() {
  ::close(fd_);
}

}  // namespace dob
