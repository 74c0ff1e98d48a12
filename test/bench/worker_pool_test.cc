#include "bench/worker_pool.h"

#include <csignal>
#include <map>
#include <stdexcept>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

namespace dob::worker_pool_test {
namespace {

std::map<std::size_t, TaskOutcome> run_all(std::size_t count, const WorkerOptions& options,
                                           const std::function<std::string(std::size_t)>& task) {
  std::map<std::size_t, TaskOutcome> outcomes;
  EXPECT_EQ(
      run_in_processes(count, options, task, [&](std::size_t i, const TaskOutcome& outcome) { outcomes[i] = outcome; }),
      0);
  return outcomes;
}

TEST(WorkerPool, EveryTaskAnswersWhateverTheNumberOfJobs) {
  for (const int jobs : {1, 2, 5}) {
    const auto outcomes = run_all(7, {.jobs = jobs}, [](std::size_t i) { return std::string(20000 * i, 'x'); });
    ASSERT_EQ(outcomes.size(), 7U);
    for (const auto& [i, outcome] : outcomes) {
      EXPECT_TRUE(outcome.ok) << outcome.reason;
      EXPECT_EQ(outcome.output.size(), 20000 * i);
    }
  }
}

TEST(WorkerPool, CrashesExceptionsAndExitsAreOutcomesWithAReason) {
  const auto outcomes = run_all(4, {.jobs = 2}, [](std::size_t i) -> std::string {
    if (i == 0) std::raise(SIGKILL);
    if (i == 1) throw std::runtime_error("no such gain");
    if (i == 2) ::_exit(7);
    return "fine";
  });
  EXPECT_EQ(outcomes.at(0).reason, "crashed: Killed");
  EXPECT_EQ(outcomes.at(1).reason, "no such gain");
  EXPECT_EQ(outcomes.at(2).reason, "ended without a result, exit code 7");
  EXPECT_TRUE(outcomes.at(3).ok);
  EXPECT_EQ(outcomes.at(3).output, "fine");
}

TEST(WorkerPool, ATaskThatHangsIsEndedAtItsTimeout) {
  const auto outcomes = run_all(2, {.jobs = 2, .timeout_s = 0.3}, [](std::size_t i) -> std::string {
    if (i == 0) {
      while (true) std::this_thread::sleep_for(std::chrono::hours(1));
    }
    return "fine";
  });
  EXPECT_EQ(outcomes.at(0).reason, "timeout after 0.3 s");
  EXPECT_TRUE(outcomes.at(1).ok);
}

TEST(WorkerPool, ASignalEndsTheBatchAndIsReported) {
  std::size_t ended = 0;
  const int signal = run_in_processes(
      50, {.jobs = 1},
      [](std::size_t i) {
        if (i == 2) ::kill(::getppid(), SIGTERM);
        std::this_thread::sleep_for(std::chrono::milliseconds(i == 2 ? 10000 : 1));
        return std::string("x");
      },
      [&](std::size_t, const TaskOutcome&) { ++ended; });
  EXPECT_EQ(signal, SIGTERM);
  EXPECT_EQ(ended, 2U);
}

}  // namespace
}  // namespace dob::worker_pool_test
