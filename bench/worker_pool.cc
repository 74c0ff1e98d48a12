#include "bench/worker_pool.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <poll.h>
#include <sys/signalfd.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include "bench/file_descriptor.h"
#include "bench/worker_process.h"

namespace dob {
namespace {

// SIGINT, SIGTERM and SIGCHLD as a readable file for as long as this lives.
class Signals {
 public:
  Signals() : old_child_(std::signal(SIGCHLD, SIG_DFL)), fd_(open(&old_mask_)) {}
  ~Signals() {
    ::sigprocmask(SIG_SETMASK, &old_mask_, nullptr);
    std::signal(SIGCHLD, old_child_);
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  int fd() const noexcept { return fd_.get(); }
  const sigset_t& old_mask() const noexcept { return old_mask_; }

  // SIGINT or SIGTERM, if one has come since the last call; 0 otherwise.
  int stop() const noexcept {
    int number = 0;
    signalfd_siginfo info{};
    while (::read(fd_.get(), &info, sizeof info) == sizeof info) {
      if (info.ssi_signo != SIGCHLD) number = static_cast<int>(info.ssi_signo);
    }
    return number;
  }

 private:
  static int open(sigset_t* old_mask) {
    sigset_t mask;
    sigemptyset(&mask);
    for (const int number : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&mask, number);
    ::sigprocmask(SIG_BLOCK, &mask, old_mask);
    return ::signalfd(-1, &mask, SFD_CLOEXEC | SFD_NONBLOCK);
  }

  void (*old_child_)(int);  // whoever started this may have had it ignored, and nothing could be waited for
  sigset_t old_mask_{};
  FileDescriptor fd_;
};

struct Worker {
  std::size_t task;
  WorkerProcess process;
};

// Those that are at work.
class Workers {
 public:
  Workers() = default;
  ~Workers() {
    for (Worker& worker : workers_) worker.process.end();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t size() const noexcept { return workers_.size(); }
  void add(std::size_t task, WorkerProcess process) { workers_.push_back({task, std::move(process)}); }

  // Until a signal comes, a worker says something, or it is time to look at the time limits.
  void wait(const Signals& signals) const {
    constexpr int kInterval = 100;  // [ms]
    std::vector<pollfd> files{{signals.fd(), POLLIN, 0}};
    for (const Worker& worker : workers_) files.push_back({worker.process.pipe(), POLLIN, 0});
    if (::poll(files.data(), files.size(), kInterval) < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "poll");
    }
  }

  // Takes out those that have ended.
  std::vector<Worker> attend() {
    std::vector<Worker> ended;
    for (std::size_t i = workers_.size(); i-- > 0;) {
      workers_[i].process.attend();
      if (!workers_[i].process.has_ended()) continue;
      ended.push_back(std::move(workers_[i]));
      workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return ended;
  }

 private:
  std::vector<Worker> workers_;
};

}  // namespace

int run_in_processes(std::size_t count, const WorkerOptions& options,
                     const std::function<std::string(std::size_t)>& task,
                     const std::function<void(std::size_t, const TaskOutcome&)>& done) {
  const auto jobs = static_cast<std::size_t>(std::max(1, options.jobs));
  const Signals signals;
  Workers workers;
  std::size_t next = 0;
  const auto start = [&] {
    for (; next < count && workers.size() < jobs; ++next) {
      workers.add(next, WorkerProcess([&] { return task(next); }, options, signals.old_mask()));
    }
  };
  for (start(); workers.size() > 0;) {
    workers.wait(signals);
    if (const int number = signals.stop(); number != 0) return number;
    std::vector<Worker> ended = workers.attend();
    start();  // first, so that nobody waits while a result is put on the disk
    for (Worker& worker : ended) done(worker.task, worker.process.outcome());
  }
  return 0;
}

}  // namespace dob
