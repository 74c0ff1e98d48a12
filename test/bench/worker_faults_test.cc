// Workers that do their worst: every one is an outcome with its reason, and the pool goes on. No test here says how
// long anything takes; a pool that waits for what never comes fails by never ending.
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/worker_message.h"
#include "bench/worker_pool.h"
#include "test/support/pipe_home.h"

namespace dob::worker_faults_test {
namespace {

using ::testing::HasSubstr;

void write_home(const std::string& bytes) {
  if (::write(test::pipe_home(), bytes.data(), bytes.size()) < 0) ::_exit(9);
}

template <typename Thrown>
void throw_it(const Thrown& thrown) {
  throw thrown;
}

// A process of the worker's that ends itself after a minute, should nobody else do so. Its number.
pid_t leave_behind(const std::function<void()>& at_first = [] {}) {
  const pid_t pid = ::fork();
  if (pid != 0) return pid;
  at_first();
  ::alarm(60);
  test::sleep_for_ever();
}

// Of `bad` between two good tasks, which must not notice.
TaskOutcome outcome_of(const std::function<std::string()>& bad, WorkerOptions options = {}) {
  std::vector<TaskOutcome> outcomes(3);
  options.jobs = 2;
  const int stop = run_in_processes(
      3, options, [&](std::size_t i) { return i == 1 ? bad() : std::string("fine"); },
      [&](std::size_t i, const TaskOutcome& outcome) { outcomes[i] = outcome; });
  EXPECT_EQ(stop, 0);
  for (const std::size_t good : {0, 2}) EXPECT_EQ(outcomes[good].output, "fine") << outcomes[good].reason;
  EXPECT_EQ(outcomes[1].ok, outcomes[1].reason.empty());
  return outcomes[1];
}

// Gone, or dead and waiting for its new parent to notice.
bool is_gone(pid_t pid) {
  std::array<char, 256> line{};
  FILE* file = std::fopen(("/proc/" + std::to_string(pid) + "/stat").c_str(), "r");
  if (file == nullptr) return true;
  const bool read = std::fgets(line.data(), line.size(), file) != nullptr;
  std::fclose(file);
  const std::string text = line.data();
  return !read || text.find(") Z") != std::string::npos || text.find(") X") != std::string::npos;
}

TEST(WorkerFaults, AChildThatOutlivesItsWorkerIsEndedAndKeepsNobodyWaiting) {
  const TaskOutcome outcome = outcome_of([] { return std::to_string(leave_behind()); });
  ASSERT_TRUE(outcome.ok) << outcome.reason;  // the worker has done its work
  const pid_t child = std::stoi(outcome.output);
  for (int i = 0; i < 1000 && !is_gone(child); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(is_gone(child));
}

TEST(WorkerFaults, AChildInASessionOfItsOwnKeepsNobodyWaiting) {
  const TaskOutcome outcome = outcome_of([] { return std::to_string(leave_behind([] { ::setsid(); })); });
  ASSERT_TRUE(outcome.ok) << outcome.reason;
  ::kill(std::stoi(outcome.output), SIGKILL);
}

TEST(WorkerFaults, AWorkerThatEndsWhileItsChildHoldsThePipeHasEnded) {
  const auto crash = [] {
    leave_behind();
    std::raise(SIGKILL);
    return std::string();
  };
  EXPECT_EQ(outcome_of(crash).reason, "crashed: Killed");
}

TEST(WorkerFaults, WhatIsNoWholeMessageIsAReason) {
  const auto send = [](const std::string& bytes) {
    return [bytes]() -> std::string {
      write_home(bytes);
      ::_exit(0);
    };
  };
  const std::string whole = framed(true, "a result");
  EXPECT_EQ(outcome_of(send(whole)).output, "a result");
  EXPECT_EQ(outcome_of(send("garbage")).reason, "sent home 7 bytes that are no result");
  EXPECT_THAT(outcome_of(send(whole.substr(0, whole.size() - 1))).reason, HasSubstr("no result"));
  EXPECT_THAT(outcome_of(send(whole.substr(0, 5))).reason, HasSubstr("no result"));
  EXPECT_THAT(outcome_of(send(whole + whole)).reason, HasSubstr("no result"));
  std::string changed = whole;
  changed.back() = 'T';
  EXPECT_THAT(outcome_of(send(changed)).reason, HasSubstr("no result"));
  // Its own result behind somebody else's bytes.
  EXPECT_THAT(outcome_of([] {
                write_home("+");
                return std::string("a result");
              }).reason,
              HasSubstr("no result"));
}

TEST(WorkerFaults, AWorkerThatNeverStopsWritingIsEnded) {
  const auto flood = []() -> std::string {
    for (const int pipe = test::pipe_home(); ::write(pipe, std::string(4096, '+').data(), 4096) > 0;) continue;
    ::_exit(9);
  };
  EXPECT_EQ(outcome_of(flood).reason, "sent home more than 64 MB");
}

TEST(WorkerFaults, AWorkerThatClosesItsPipeIsStillWatched) {
  const auto close_and_stay = []() -> std::string {
    ::close(test::pipe_home());
    test::sleep_for_ever();
  };
  EXPECT_EQ(outcome_of(close_and_stay, {.timeout_s = 0.3}).reason, "timeout after 0.3 s");
  const auto close_and_leave = []() -> std::string {
    ::close(test::pipe_home());
    ::_exit(0);
  };
  EXPECT_EQ(outcome_of(close_and_leave).reason, "ended without a result, exit code 0");
}

TEST(WorkerFaults, AWorkerThatIsStoppedOrLeavesItsGroupIsEndedAtItsTimeout) {
  const auto stop = []() -> std::string {
    std::raise(SIGSTOP);
    return "went on";
  };
  EXPECT_EQ(outcome_of(stop, {.timeout_s = 0.3}).reason, "timeout after 0.3 s");
  const auto leave = []() -> std::string {
    if (::setpgid(0, ::getpgid(::getppid())) != 0) return "could not leave";
    test::sleep_for_ever();
  };
  EXPECT_EQ(outcome_of(leave, {.timeout_s = 0.3}).reason, "timeout after 0.3 s");
}

TEST(WorkerFaults, AnExceptionOutOfANoexceptFunctionIsItsText) {
  const auto throws = []() -> std::string {
    []() noexcept { throw_it(std::runtime_error("out of ideas")); }();
    return "never";
  };
  EXPECT_EQ(outcome_of(throws).reason, "threw where nothing may be thrown: out of ideas");
  const auto throws_number = []() -> std::string {
    []() noexcept { throw_it(42); }();
    return "never";
  };
  EXPECT_THAT(outcome_of(throws_number).reason, HasSubstr("no std::exception"));
  EXPECT_EQ(outcome_of([]() -> std::string { std::terminate(); }).reason, "std::terminate() was called");
}

#if !defined(DOB_SANITIZED)
TEST(WorkerFaults, MoreMemoryThanTheLimitIsAReason) {
  const auto allocate = []() -> std::string {
    const std::vector<char> block(std::size_t{2} << 30U, 'x');
    return std::string(1, block[12345]);
  };
  EXPECT_EQ(outcome_of(allocate, {.memory_limit_MB = 1000}).reason,
            "out of memory: the limit is 1000 MB (--memory-limit)");
  const auto bit_by_bit = []() -> std::string {  // with no room left for anything when it has come to its end
    std::vector<char*> blocks;
    while (true) blocks.push_back(new char[1000]);
  };
  EXPECT_EQ(outcome_of(bit_by_bit, {.memory_limit_MB = 200}).reason,
            "out of memory: the limit is 200 MB (--memory-limit)");
}
#endif

TEST(WorkerFaults, ACallOfExitPrintsNothingAgainAndIsNoResult) {
  ::testing::internal::CaptureStdout();
  std::printf("once");  // is in the buffer when the worker is forked
  const auto leave = []() -> std::string { std::exit(0); };
  const TaskOutcome outcome = outcome_of(leave);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "once");
  EXPECT_EQ(outcome.reason, "ended without a result, exit code 0");
}

TEST(WorkerFaults, WhatAWorkerPrintsIsNotInTheOutputAndWhatItReadsIsEmpty) {
  ::testing::internal::CaptureStdout();
  const TaskOutcome outcome = outcome_of([] {
    std::printf("x");
    std::fflush(stdout);
    return std::to_string(::read(STDIN_FILENO, std::array<char, 1>{}.data(), 1));
  });
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(outcome.output, "0");  // the end of an empty file
}

TEST(WorkerFaults, AParentToWhomTheEndOfChildrenWasOfNoInterestStillSeesIt) {
  std::signal(SIGCHLD, SIG_IGN);
  EXPECT_EQ(outcome_of([] { return std::string("fine"); }).output, "fine");
  EXPECT_EQ(std::signal(SIGCHLD, SIG_DFL), SIG_IGN);
}

// SIGTERM while a worker and its child are at work: both are gone when the pool returns.
TEST(WorkerFaults, ASignalEndsWhatTheWorkersHaveStarted) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const int stop = run_in_processes(
      1, {.jobs = 1},
      [&](std::size_t) -> std::string {
        const pid_t child = leave_behind();
        if (::write(ends[1], &child, sizeof child) != sizeof child) ::_exit(1);
        ::kill(::getppid(), SIGTERM);
        test::sleep_for_ever();
      },
      [](std::size_t, const TaskOutcome&) {});
  EXPECT_EQ(stop, SIGTERM);
  pid_t child = 0;
  ASSERT_EQ(::read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
  for (int i = 0; i < 1000 && !is_gone(child); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(is_gone(child));
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace
}  // namespace dob::worker_faults_test
