#include "bench/worker_process.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "bench/worker_child.h"
#include "bench/worker_message.h"

namespace dob {
namespace {

using Clock = std::chrono::steady_clock;

std::pair<FileDescriptor, FileDescriptor> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);  // of this end only
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

}  // namespace

WorkerProcess::WorkerProcess(const std::function<std::string()>& task, const WorkerOptions& options,
                             const sigset_t& signals)
    : options_(options), started_(Clock::now()) {
  auto [read_end, write_end] = make_pipe();
  std::fflush(nullptr);  // or a worker that calls exit() prints it again
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid_ == 0) run_child({write_end.get(), parent, options.memory_limit_MB, signals}, task);
  ::setpgid(pid_, pid_);  // the child does so too: whoever comes first
  pipe_ = std::move(read_end);
}

void WorkerProcess::attend() {
  receive();
  if (!ended_because_.empty()) return;
  if (received_.size() > kLongestMessage) {
    ended_because_ = fmt::format("sent home more than {} MB", kLongestMessage >> 20U);
  } else if (const std::chrono::duration<double> elapsed = Clock::now() - started_;
             options_.timeout_s > 0.0 && elapsed.count() > options_.timeout_s) {
    ended_because_ = fmt::format("timeout after {} s", options_.timeout_s);
  } else {
    return;
  }
  kill_all();
}

// As much as is there, but not for ever: a worker that writes as fast as this reads must not keep it from the others.
void WorkerProcess::receive() {
  constexpr int kMost = 64;
  std::array<char, 65536> buffer{};
  for (int i = 0; i < kMost && pipe_.get() >= 0 && received_.size() <= kLongestMessage; ++i) {
    const ssize_t n = ::read(pipe_.get(), buffer.data(), buffer.size());
    if (n > 0) {
      received_.append(buffer.data(), static_cast<std::size_t>(n));
    } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
      pipe_ = FileDescriptor();
    } else if (errno == EAGAIN) {
      return;
    }
  }
  if (received_.size() > kLongestMessage) pipe_ = FileDescriptor();
}

bool WorkerProcess::has_ended() const noexcept {
  siginfo_t info{};
  const int answer = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
  return answer != 0 ? errno != EINTR : info.si_pid == pid_;
}

TaskOutcome WorkerProcess::outcome() {
  kill_all();  // before the process is forgotten, and its number given to another
  receive();
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  if (!ended_because_.empty()) return {false, {}, ended_because_};
  if (WIFSIGNALED(status)) return {false, {}, fmt::format("crashed: {}", ::strsignal(WTERMSIG(status)))};
  if (received_.empty() || WEXITSTATUS(status) != 0) {
    return {false, {}, fmt::format("ended without a result, exit code {}", WEXITSTATUS(status))};
  }
  std::optional<WorkerMessage> message = unframed(received_);
  if (!message) return {false, {}, fmt::format("sent home {} bytes that are no result", received_.size())};
  if (!message->ok) return {false, {}, std::move(message->text)};
  return {true, std::move(message->text), {}};
}

void WorkerProcess::end() noexcept {
  kill_all();
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void WorkerProcess::kill_all() const noexcept {
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);  // it may have left its group
}

}  // namespace dob
