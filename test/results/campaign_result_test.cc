#include "results/campaign_result.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/campaign_run_samples.h"

namespace dob::campaign_result_test {
namespace {

using test::add_trials;
using test::SampleCampaign;
using ::testing::HasSubstr;

const CampaignAxis kAmplitude{"amplitude", "N", {30.0, 60.0, 90.0, 120.0, 150.0}};

SampleCampaign limit() {
  return test::empty_campaign(CampaignKind::kLimit, {kAmplitude});
}

std::string error_of(const SampleCampaign& sample) {
  try {
    sample.result();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CampaignResultTest, CountsWhatHasBecomeOfTheCellsOfALevel) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "knee", "momentum", "paper", 0), {0});
  add_trials(sample, curve, {1, 0}, "ssfe.");
  const CampaignResult result = sample.result();
  EXPECT_EQ(result.planned, 5U);
  ASSERT_EQ(result.curves.size(), 1U);
  ASSERT_EQ(result.curves[0].levels.size(), 1U);  // no cells are planned at the others
  const LevelResult& level = result.curves[0].levels[0];
  EXPECT_EQ(level.level[0], 1);
  EXPECT_EQ(level.planned, 5);
  EXPECT_EQ(level.trials, 3);
  EXPECT_EQ(level.falls, 1);
  EXPECT_EQ(level.errors, 1);
  EXPECT_FALSE(level.falls_ci);
  EXPECT_EQ(result.curves[0].trials, 3);
  EXPECT_EQ(result.curves[0].falls, 1);
  EXPECT_EQ(result.curves[0].errors, 1);
  EXPECT_EQ(result.curves[0].seeds, 3);  // the fourth could not be run, the fifth has not been
}

TEST(CampaignResultTest, ErrorsAreMediansOfTheSurvivors) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {0, 0}, "sfsss", 0.01);  // 0.01, 0.03, 0.04, 0.05; the fall has 0.5
  add_trials(sample, curve, {4, 0}, "ff");
  sample.run.cells[0].metrics.foot_error_max_m = 0.002;
  const CampaignResult result = sample.result();
  const std::vector<LevelResult>& levels = result.curves[0].levels;
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_DOUBLE_EQ(levels[0].com_error_m.value(), 0.035);
  EXPECT_EQ(levels[0].foot_error_m, 0.002);
  EXPECT_FALSE(levels[0].com_error_ci);
  EXPECT_FALSE(levels[1].com_error_m || levels[1].foot_error_m);
}

TEST(CampaignResultTest, EightTrialsHaveIntervals) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {0, 0}, "ssssssss");
  const CampaignResult result = sample.result();
  const LevelResult& level = result.curves[0].levels[0];
  ASSERT_TRUE(level.falls_ci && level.com_error_ci);
  EXPECT_EQ(level.falls_ci->low, 0.0);
  EXPECT_NEAR(level.falls_ci->high, 3.841458820694124 / (8.0 + 3.841458820694124), 1e-12);
  EXPECT_LT(level.com_error_ci->low, 0.045);
  EXPECT_GT(level.com_error_ci->high, 0.045);
}

TEST(CampaignResultTest, ThresholdsAreThoseOfTheWholeLadder) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {3, 0}, "sff");  // the plan need not be in the order of the levels
  add_trials(sample, curve, {1, 0}, "sse");
  const CampaignResult result = sample.result();
  const FallThreshold expected =
      fall_threshold({{30.0, 0, 0}, {60.0, 2, 0}, {90.0, 0, 0}, {120.0, 3, 2}, {150.0, 0, 0}}, false, 0.5);
  ASSERT_TRUE(result.curves[0].half && result.curves[0].twentieth);
  EXPECT_EQ(result.curves[0].half->estimate, expected.estimate);
  EXPECT_EQ(result.curves[0].half->interval.low, expected.interval.low);
  EXPECT_LT(result.curves[0].twentieth->estimate, expected.estimate);
  EXPECT_EQ(result.curves[0].levels[0].level[0], 1);
}

TEST(CampaignResultTest, WithoutATrialThereIsNoThreshold) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {3, 0}, "e.");
  const CampaignResult result = sample.result();
  EXPECT_FALSE(result.curves[0].half || result.curves[0].twentieth);
  EXPECT_EQ(result.curves[0].seeds, 0);
  EXPECT_EQ(result.curves[0].errors, 1);
}

TEST(CampaignResultTest, SeedsThatFellAndSurvivedHarderLevelsAreNamed) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {0, 0}, "ssfs");
  add_trials(sample, curve, {1, 0}, "ffff");
  add_trials(sample, curve, {2, 0}, "fffs");
  add_trials(sample, curve, {3, 0}, "fsf.");
  add_trials(sample, curve, {4, 0}, "fffe");
  const CampaignResult result = sample.result();
  const std::vector<NonMonotoneSeed>& seeds = result.curves[0].non_monotone;
  ASSERT_EQ(seeds.size(), 2U);
  EXPECT_EQ(seeds[0].seed, 2);
  EXPECT_EQ(seeds[0].fell_at, 60.0);
  EXPECT_EQ(seeds[0].survived_at, 120.0);
  EXPECT_EQ(seeds[1].seed, 4);
  EXPECT_EQ(seeds[1].survived_at, 90.0);
}

TEST(CampaignResultTest, HarderIsFurtherAlongALadderThatDescends) {
  SampleCampaign sample = test::empty_campaign(CampaignKind::kLimit, {{"friction", "", {0.8, 0.4, 0.2}}});
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {0, 0}, "fs");
  add_trials(sample, curve, {2, 0}, "sf");
  const CampaignResult result = sample.result();
  ASSERT_EQ(result.curves[0].non_monotone.size(), 1U);
  EXPECT_EQ(result.curves[0].non_monotone[0].seed, 1);
  EXPECT_EQ(result.curves[0].non_monotone[0].fell_at, 0.8);
  EXPECT_EQ(result.curves[0].non_monotone[0].survived_at, 0.2);
}

TEST(CampaignResultTest, MapHasALevelForEachPairAndNoThreshold) {
  SampleCampaign sample = test::empty_campaign(CampaignKind::kMap, {kAmplitude, {"delay", "s", {0.0, 0.005}}});
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0, 1});
  add_trials(sample, curve, {1, 1}, "ff");
  add_trials(sample, curve, {1, 0}, "sf");
  add_trials(sample, curve, {0, 1}, "ss");
  const CampaignResult result = sample.result();
  const std::vector<LevelResult>& levels = result.curves[0].levels;
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].level, (std::array{0, 1}));
  EXPECT_EQ(levels[1].level, (std::array{1, 0}));
  EXPECT_EQ(levels[1].falls, 1);
  EXPECT_EQ(levels[2].falls, 2);
  EXPECT_FALSE(result.curves[0].half);
  EXPECT_TRUE(result.curves[0].non_monotone.empty());
}

TEST(CampaignResultTest, EachCurveOfABreakdownHasTheLadderOfItsAxis) {
  SampleCampaign sample =
      test::empty_campaign(CampaignKind::kBreakdown, {kAmplitude, {"delay", "s", {0.001, 0.01, 0.1}, true}});
  const CellKey key = test::key("case1", "", "o", "-", 0);
  const std::size_t force = sample.add_curve(key, {0}), delay = sample.add_curve(key, {1});
  for (int level = 0; level < 5; ++level) add_trials(sample, force, {level, 0}, level < 3 ? "sssss" : "fffff");
  sample.campaign.curves[delay].key.observer = "p";
  for (int level = 0; level < 3; ++level) add_trials(sample, delay, {level, 0}, level < 2 ? "sssss" : "fffff");
  const CampaignResult result = sample.result();
  EXPECT_GT(result.curves[0].half->estimate, 90.0);
  EXPECT_LT(result.curves[0].half->estimate, 120.0);
  EXPECT_GT(result.curves[1].half->estimate, 0.01);
  EXPECT_LT(result.curves[1].half->estimate, 0.1);
}

TEST(CampaignResultTest, RefusesWhatDoesNotBelongTogether) {
  SampleCampaign sample = limit();
  const std::size_t curve = sample.add_curve(test::key("case1", "", "o", "-", 0), {0});
  add_trials(sample, curve, {3, 0}, "s");
  EXPECT_EQ(error_of(sample), "");
  SampleCampaign other = sample;
  other.run.info.cells.clear();
  EXPECT_THAT(error_of(other), HasSubstr("1 cells, but its run has 0"));
  other = sample;
  other.campaign.cells[0].curve = 1;
  EXPECT_THAT(error_of(other), HasSubstr("a cell of curve 1 of 1"));
  other = sample;
  other.campaign.cells[0].level[0] = 5;
  EXPECT_THAT(error_of(other), HasSubstr("at level 5 of 5"));
  other = sample;
  other.campaign.cells[0].level[1] = 1;
  EXPECT_THAT(error_of(other), HasSubstr("at level 1 of 1"));
  other = sample;
  other.campaign.curves[0].axes = {1};
  EXPECT_THAT(error_of(other), HasSubstr("over axis 1 of 1"));
}

}  // namespace
}  // namespace dob::campaign_result_test
