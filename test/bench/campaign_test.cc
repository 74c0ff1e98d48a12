// Campaigns as a user runs them: the same table in any number of jobs, after a kill, and from shards.
#include "results/campaign.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <thread>

#include "results/store.h"
#include "test/bench/command_line_children.h"

namespace dob::campaign_test {
namespace {

using test::Answer;

constexpr const char* kCampaign = R"(kind = "limit"
summary = "a push while it trots"
scenarios = ["case3/left_10"]
observers = ["none", "momentum_com"]
profiles = ["tuned"]
set = ["duration_s=2", "disturbance.0.not_before_s=0.5"]
seeds = 3

[budget]
trials_per_curve = 20

[axis.amplitude]
set = "disturbance.0.amplitude_N={}"
unit = "N"
from = 50
to = 1600
levels = 6
spacing = "log"
)";

class CampaignCommand : public test::CommandLineChildren {
 protected:
  void SetUp() override {
    CommandLineChildren::SetUp();
    std::ofstream(dir / "push.toml") << kCampaign;
  }

  std::string table(const std::string& run) const { return dobbench("table " + run + " --format json").out; }
};

TEST_F(CampaignCommand, ChoosesTheSameTrialsInAnyNumberOfJobs) {
  const Answer one = dobbench("campaign push.toml --jobs 1 --out one");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  ASSERT_EQ(dobbench("campaign push.toml --jobs 3 --out three").exit_code, 0);
  EXPECT_EQ(table("one"), table("three"));
  EXPECT_EQ(hashes("one"), hashes("three"));
  const dob::Run run = read_run(dir / "one");
  EXPECT_EQ(run.info.cells.size(), 2U * 6U * 3U);
  EXPECT_LE(run.cells.size(), 40U);
  const auto falls = std::count_if(run.cells.begin(), run.cells.end(),
                                   [](const CellResult& cell) { return cell.outcome == Outcome::kFell; });
  EXPECT_GT(falls, 0);
  EXPECT_LT(falls, std::ssize(run.cells));
  EXPECT_NE(one.out.find("momentum_com"), std::string::npos);
}

TEST_F(CampaignCommand, IsKilledAndEndsInTheSameTable) {
  ASSERT_EQ(dobbench("campaign push.toml --jobs 2 --out whole").exit_code, 0);
  for (int i = 1; i <= 3; ++i) {
    const pid_t child = start("campaign push.toml --jobs 2 --out killed --resume");
    std::this_thread::sleep_for(std::chrono::milliseconds(600 * i));
    ::kill(child, SIGKILL);
    wait_for(child);
  }
  const Answer rest = dobbench("campaign push.toml --jobs 1 --out killed --resume");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(table("whole"), table("killed"));
  EXPECT_EQ(hashes("whole"), hashes("killed"));
}

TEST_F(CampaignCommand, CellsThatCouldNotBeRunAndThenCanLeaveNoOtherTable) {
  ASSERT_EQ(dobbench("campaign push.toml --out whole").exit_code, 0);
  ASSERT_EQ(dobbench("campaign push.toml --timeout 0.02 --out late").exit_code, 3);
  const Answer retried = dobbench("campaign push.toml --resume --retry-errors --out late");
  EXPECT_EQ(retried.exit_code, 0) << retried.err;
  EXPECT_EQ(table("whole"), table("late"));
}

TEST_F(CampaignCommand, AnotherBudgetDoesNotGoOn) {
  ASSERT_EQ(dobbench("campaign push.toml --budget 24 --out small").exit_code, 0);
  expect_refused("campaign push.toml --budget 40 --resume --out small", {"cannot be resumed", "budget"});
}

TEST_F(CampaignCommand, ShardsMergeIntoTheSameTable) {
  ASSERT_EQ(dobbench("campaign push.toml --out whole").exit_code, 0);
  ASSERT_EQ(dobbench("campaign push.toml --shard 2/2 --out two").exit_code, 0);
  const Answer half = dobbench("merge two --out merged");
  EXPECT_EQ(half.exit_code, 3);
  EXPECT_NE(half.out.find("1 of 2 shards are missing: 1"), std::string::npos) << half.out;
  ASSERT_EQ(dobbench("campaign push.toml --shard 1/2 --out one").exit_code, 0);
  const Answer merged = dobbench("merge one two --out merged");
  EXPECT_EQ(merged.exit_code, 0) << merged.out << merged.err;
  EXPECT_EQ(table("whole"), table("merged"));
  EXPECT_EQ(hashes("whole"), hashes("merged"));
  expect_refused("campaign push.toml --shard 1/2 --out two --resume", {"it is shard 2/2, not shard 1/2"});
  ASSERT_EQ(dobbench("campaign push.toml --set duration_s=1.5 --shard 1/2 --out other").exit_code, 0);
  expect_refused("merge other two --out mixed", {"belongs to another plan"});
  EXPECT_EQ(dobbench("verify merged --sample 3").exit_code, 0);
}

TEST_F(CampaignCommand, ShardsOfARunMergeIntoTheSameTable) {
  const std::string what =
      "run undisturbed --observer none --observer momentum --profile tuned --seeds 3 "
      "--set duration_s=0.4 ";
  ASSERT_EQ(dobbench(what + "--out whole").exit_code, 0);
  for (const char* shard : {"1", "2", "3"}) {
    ASSERT_EQ(dobbench(what + "--shard " + shard + "/3 --out shard" + shard).exit_code, 0);
  }
  ASSERT_EQ(dobbench("merge shard3 shard1 shard2 --out merged").exit_code, 0);
  EXPECT_EQ(table("whole"), table("merged"));
  EXPECT_EQ(dobbench("table whole").out, dobbench("table merged").out);
  EXPECT_EQ(hashes("whole"), hashes("merged"));
  std::size_t traces = 0;
  for (const auto& file : std::filesystem::directory_iterator(dir / "whole" / "traces")) {
    EXPECT_TRUE(std::filesystem::exists(dir / "merged" / "traces" / file.path().filename())) << file.path();
    ++traces;
  }
  EXPECT_EQ(traces, 2U);
}

TEST_F(CampaignCommand, BadInputIsRefusedWithItsPlace) {
  expect_refused("campaign nowhere.toml", {"nowhere.toml"});
  expect_refused("campaign nonsense", {"nonsense.toml"});
  expect_refused("campaign push.toml --budget 3", {"--budget", "at least 12"});
  expect_refused("campaign push.toml --budget 0", {"--budget"});
  expect_refused("campaign push.toml --shard 3/2", {"--shard 3/2", "I/N"});
  expect_refused("run undisturbed --shard 0/2", {"--shard 0/2", "I/N"});
  expect_refused("campaign push.toml --set nonsense=1", {"nonsense"});
  expect_refused("merge nowhere --out merged", {"nowhere"});
}

}  // namespace
}  // namespace dob::campaign_test
