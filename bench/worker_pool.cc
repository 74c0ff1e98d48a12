#include "bench/worker_pool.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace dob {
namespace {

using Clock = std::chrono::steady_clock;

constexpr char kOk = '+';     // first byte of what a child sends: a result follows,
constexpr char kError = '-';  // or the text of an exception

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const noexcept { return fd_; }

 private:
  int fd_;
};

// SIGINT and SIGTERM as a readable file for as long as this lives.
class StopSignals {
 public:
  StopSignals() : fd_(open(&old_mask_)) {}
  ~StopSignals() { ::sigprocmask(SIG_SETMASK, &old_mask_, nullptr); }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  int fd() const noexcept { return fd_.get(); }
  void restore_in_child() const noexcept { ::sigprocmask(SIG_SETMASK, &old_mask_, nullptr); }
  int number() const noexcept {
    signalfd_siginfo info{};
    return ::read(fd_.get(), &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : SIGTERM;
  }

 private:
  static int open(sigset_t* old_mask) {
    sigset_t mask;
    sigemptyset(&mask);
    sigaddset(&mask, SIGINT);
    sigaddset(&mask, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &mask, old_mask);
    return ::signalfd(-1, &mask, SFD_CLOEXEC);
  }

  sigset_t old_mask_{};
  FileDescriptor fd_;
};

struct Worker {
  std::size_t task;
  pid_t pid;
  FileDescriptor pipe;
  Clock::time_point started;
  std::string received;
  bool timed_out = false;
};

void write_all(int fd, const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t n = ::write(fd, text.data() + sent, text.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    sent += static_cast<std::size_t>(n);
  }
}

Worker start(std::size_t index, const std::function<std::string(std::size_t)>& task, const StopSignals& signals) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  FileDescriptor read_end(ends[0]);
  const FileDescriptor write_end(ends[1]);
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // no orphans when the batch itself is killed
    if (::getppid() != parent) ::_exit(1);
    ::setpgid(0, 0);  // Ctrl-C goes to the batch, which ends its children
    signals.restore_in_child();
    std::string answer;
    try {
      answer = kOk + task(index);
    } catch (const std::exception& error) {
      answer = kError + std::string(error.what());
    } catch (...) {
      answer = kError + std::string("unknown exception");
    }
    write_all(write_end.get(), answer);
    ::_exit(0);
  }
  return {index, pid, std::move(read_end), Clock::now(), {}, false};
}

TaskOutcome finish(Worker& worker, double timeout_s) {
  int status = 0;
  while (::waitpid(worker.pid, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string& text = worker.received;
  if (worker.timed_out) return {false, {}, fmt::format("timeout after {} s", timeout_s)};
  if (WIFSIGNALED(status)) return {false, {}, fmt::format("crashed: {}", ::strsignal(WTERMSIG(status)))};
  if (text.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return {false, {}, fmt::format("ended without a result, exit code {}", WEXITSTATUS(status))};
  }
  if (text.front() != kOk) return {false, {}, text.substr(1)};
  return {true, text.substr(1), {}};
}

void end_all(std::vector<Worker>& workers) {
  for (const Worker& worker : workers) ::kill(worker.pid, SIGKILL);
  for (const Worker& worker : workers) ::waitpid(worker.pid, nullptr, 0);
  workers.clear();
}

// True when the pipe has reached its end.
bool receive(Worker& worker) {
  std::array<char, 4096> buffer{};
  const ssize_t n = ::read(worker.pipe.get(), buffer.data(), buffer.size());
  if (n > 0) worker.received.append(buffer.data(), static_cast<std::size_t>(n));
  return n == 0 || (n < 0 && errno != EINTR);
}

}  // namespace

int run_in_processes(std::size_t count, const WorkerOptions& options,
                     const std::function<std::string(std::size_t)>& task,
                     const std::function<void(std::size_t, const TaskOutcome&)>& done) {
  constexpr int kPollInterval = 100;  // [ms] how often time limits are looked at
  const StopSignals signals;
  std::vector<Worker> workers;
  std::size_t next = 0;
  try {
    while (next < count || !workers.empty()) {
      while (next < count && workers.size() < static_cast<std::size_t>(std::max(1, options.jobs))) {
        workers.push_back(start(next, task, signals));
        ++next;
      }
      std::vector<pollfd> files{{signals.fd(), POLLIN, 0}};
      for (const Worker& worker : workers) files.push_back({worker.pipe.get(), POLLIN, 0});
      if (::poll(files.data(), files.size(), options.timeout_s > 0.0 ? kPollInterval : -1) < 0 && errno != EINTR) {
        throw std::system_error(errno, std::generic_category(), "poll");
      }
      if (files[0].revents != 0) {
        end_all(workers);
        return signals.number();
      }
      for (std::size_t i = workers.size(); i-- > 0;) {
        Worker& worker = workers[i];
        const double elapsed = std::chrono::duration<double>(Clock::now() - worker.started).count();
        if (options.timeout_s > 0.0 && elapsed > options.timeout_s && !worker.timed_out) {
          worker.timed_out = true;
          ::kill(worker.pid, SIGKILL);
        }
        if (files[i + 1].revents == 0 || !receive(worker)) continue;
        Worker ended = std::move(worker);
        workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(i));
        done(ended.task, finish(ended, options.timeout_s));
      }
    }
  } catch (...) {
    end_all(workers);
    throw;
  }
  return 0;
}

}  // namespace dob
