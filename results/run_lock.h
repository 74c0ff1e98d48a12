// The lock of a run directory: at most one process writes a run. Private to results/.
#pragma once

#include <filesystem>

namespace dob {

// A POSIX record lock on DIR/run.lock: it ends with the process, however that ends, and the worker processes that the
// batch forks do not hold it on. Within one process it excludes nobody.
class RunLock {
 public:
  // Throws StoreError, with the other's process id, if another process holds it.
  explicit RunLock(const std::filesystem::path& dir);
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  ~RunLock();

 private:
  int fd_;
};

inline constexpr const char* kLockFile = "run.lock";

}  // namespace dob
