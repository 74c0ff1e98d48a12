#include "results/fall_threshold.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::fall_threshold_test {
namespace {

using ::testing::HasSubstr;

// 10, 20, ... 100 with so many trials at each, falls counted by `falls_at(level)`.
template <typename FallsAt>
std::vector<LevelCount> ladder(int trials, FallsAt falls_at) {
  std::vector<LevelCount> counts;
  for (int i = 1; i <= 10; ++i) counts.push_back({10.0 * i, trials, falls_at(10.0 * i)});
  return counts;
}

// All fall above `edge`, none below.
std::vector<LevelCount> step(int trials, double edge) {
  return ladder(trials, [=](double level) { return level > edge ? trials : 0; });
}

std::string error_of(const std::vector<LevelCount>& counts, bool logarithmic, double share) {
  try {
    fall_threshold(counts, logarithmic, share);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FallThresholdTest, WhereAllSurviveItIsHarderThanTheHardestLevel) {
  const FallThreshold half = fall_threshold(step(4, 1000.0), false, 0.5);
  EXPECT_TRUE(half.above);
  EXPECT_FALSE(half.below);
  EXPECT_EQ(half.estimate, 100.0);
  EXPECT_EQ(half.interval.high, 100.0);
  EXPECT_GT(half.interval.low, 80.0);
}

TEST(FallThresholdTest, WhereAllFallItIsMilderThanTheMildestLevel) {
  const FallThreshold half = fall_threshold(step(4, 0.0), false, 0.5);
  EXPECT_TRUE(half.below);
  EXPECT_FALSE(half.above);
  EXPECT_EQ(half.estimate, 10.0);
  EXPECT_EQ(half.interval.low, 10.0);
  EXPECT_LT(half.interval.high, 30.0);
}

TEST(FallThresholdTest, SharpStepIsFoundBetweenItsTwoLevels) {
  const FallThreshold half = fall_threshold(step(40, 55.0), false, 0.5);
  EXPECT_FALSE(half.below || half.above);
  EXPECT_GT(half.interval.low, 50.0);
  EXPECT_LT(half.interval.high, 60.0);
  EXPECT_NEAR(half.estimate, 55.0, 0.1);  // by the symmetry of the ladder about 55
  const FallThreshold twentieth = fall_threshold(step(40, 55.0), false, 0.05);
  EXPECT_GT(twentieth.interval.low, 40.0);
  EXPECT_LT(twentieth.interval.low, half.interval.low);
  EXPECT_LT(twentieth.estimate, half.estimate);
}

TEST(FallThresholdTest, WithoutTrialsItIsThePrior) {
  const FallThreshold half = fall_threshold(step(0, 55.0), false, 0.5);
  EXPECT_NEAR(half.estimate, 55.0, 1e-9);
  EXPECT_TRUE(half.below && half.above);
  EXPECT_EQ(half.interval.low, 10.0);
  EXPECT_EQ(half.interval.high, 100.0);
}

TEST(FallThresholdTest, MoreTrialsNarrowTheInterval) {
  double last = std::numeric_limits<double>::infinity();
  for (const int trials : {1, 4, 16, 64}) {
    const FallThreshold half = fall_threshold(
        ladder(trials, [=](double level) { return level < 50.0   ? 0
                                                  : level > 50.0 ? trials
                                                                 : trials / 2; }), false,
        0.5);
    EXPECT_LT(half.interval.high - half.interval.low, last);
    last = half.interval.high - half.interval.low;
  }
}

TEST(FallThresholdTest, MirroredTrialsHaveMirroredThresholds) {
  const auto counts = ladder(6, [](double level) { return level < 35.0 ? 0 : level < 75.0 ? 2 : 6; });
  std::vector<LevelCount> mirrored;
  mirrored.reserve(counts.size());
  for (const LevelCount& count : counts) {
    mirrored.push_back({110.0 - count.level, count.trials, count.trials - count.falls});
  }
  std::reverse(mirrored.begin(), mirrored.end());
  const FallThreshold a = fall_threshold(counts, false, 0.3), b = fall_threshold(mirrored, false, 0.7);
  EXPECT_NEAR(a.estimate, 110.0 - b.estimate, 1e-6);
  EXPECT_NEAR(a.interval.low, 110.0 - b.interval.high, 1e-6);
  EXPECT_NEAR(a.interval.high, 110.0 - b.interval.low, 1e-6);
}

// A friction that falls from 1.0 to 0.1 is a ladder like a force that grows.
TEST(FallThresholdTest, DescendingLevelsAreTheSameLadder) {
  const auto counts = ladder(6, [](double level) { return level < 45.0 ? 0 : level < 75.0 ? 3 : 6; });
  std::vector<LevelCount> descending = counts;
  for (LevelCount& count : descending) count.level = 110.0 - count.level;
  const FallThreshold a = fall_threshold(counts, false, 0.2), b = fall_threshold(descending, false, 0.2);
  EXPECT_NEAR(b.estimate, 110.0 - a.estimate, 1e-6);
  EXPECT_NEAR(b.interval.low, 110.0 - a.interval.high, 1e-6);
  EXPECT_NEAR(b.interval.high, 110.0 - a.interval.low, 1e-6);
  EXPECT_LE(b.interval.low, b.estimate);
  EXPECT_LE(b.estimate, b.interval.high);
}

TEST(FallThresholdTest, EndsOfADescendingLadderAreTheOtherWayRound) {
  std::vector<LevelCount> all_survive = {{0.9, 9, 0}, {0.5, 9, 0}, {0.1, 9, 0}};
  const FallThreshold half = fall_threshold(all_survive, false, 0.5);
  EXPECT_TRUE(half.above);
  EXPECT_FALSE(half.below);
  EXPECT_EQ(half.estimate, 0.1);
  EXPECT_EQ(half.interval.low, 0.1);
}

TEST(FallThresholdTest, LogarithmicLadderIsTheLinearOneOfItsLogarithms) {
  const auto counts = ladder(5, [](double level) { return level < 45.0 ? 0 : level < 65.0 ? 2 : 5; });
  std::vector<LevelCount> logarithmic = counts;
  for (LevelCount& count : logarithmic) count.level = std::exp(0.05 * count.level);
  for (const double share : {0.05, 0.5}) {
    const FallThreshold a = fall_threshold(counts, false, share), b = fall_threshold(logarithmic, true, share);
    EXPECT_NEAR(std::log(b.estimate) / 0.05, a.estimate, 1e-6);
    EXPECT_NEAR(std::log(b.interval.low) / 0.05, a.interval.low, 1e-6);
    EXPECT_NEAR(std::log(b.interval.high) / 0.05, a.interval.high, 1e-6);
  }
}

TEST(FallThresholdTest, UnitOfTheLevelsDoesNotMatter) {
  const auto newtons = ladder(5, [](double level) { return level < 45.0 ? 0 : level < 65.0 ? 2 : 5; });
  for (const bool logarithmic : {false, true}) {
    std::vector<LevelCount> kilonewtons = newtons;
    for (LevelCount& count : kilonewtons) count.level *= 1e-3;
    const FallThreshold a = fall_threshold(newtons, logarithmic, 0.5);
    const FallThreshold b = fall_threshold(kilonewtons, logarithmic, 0.5);
    EXPECT_NEAR(b.estimate, 1e-3 * a.estimate, 1e-10);
    EXPECT_NEAR(b.interval.low, 1e-3 * a.interval.low, 1e-10);
    EXPECT_NEAR(b.interval.high, 1e-3 * a.interval.high, 1e-10);
  }
}

TEST(FallThresholdTest, OneFallFarBelowTheStepIsALapse) {
  auto counts = step(10, 75.0);
  counts[1].falls = 1;
  const FallThreshold half = fall_threshold(counts, false, 0.5);
  EXPECT_GT(half.interval.low, 60.0);
  EXPECT_LT(half.interval.high, 85.0);
}

TEST(FallThresholdTest, GivesTheSameBitsAgain) {
  const auto counts = ladder(3, [](double level) { return level < 45.0 ? 0 : 2; });
  const FallThreshold a = fall_threshold(counts, false, 0.05), b = fall_threshold(counts, false, 0.05);
  EXPECT_EQ(a.estimate, b.estimate);
  EXPECT_EQ(a.interval.low, b.interval.low);
  EXPECT_EQ(a.interval.high, b.interval.high);
}

// How often the 95 % interval holds the truth, for trials of a known logistic.
struct Coverage {
  int half = 0, twentieth = 0;
};

Coverage coverage(int data_sets, int trials, double m, double s) {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  const double twentieth = m + s * std::log(0.05 / 0.95);
  Coverage covered;
  for (int i = 0; i < data_sets; ++i) {
    const auto counts = ladder(trials, [&](double level) {
      int falls = 0;
      for (int k = 0; k < trials; ++k) falls += uniform() < 1.0 / (1.0 + std::exp(-(level - m) / s)) ? 1 : 0;
      return falls;
    });
    const auto holds = [&](double share, double truth) {
      const Interval interval = fall_threshold(counts, false, share).interval;
      return interval.low <= truth && truth <= interval.high;
    };
    covered.half += holds(0.5, m) ? 1 : 0;
    covered.twentieth += holds(0.05, twentieth) ? 1 : 0;
  }
  return covered;
}

TEST(FallThresholdTest, IntervalHoldsTheTruthAsOftenAsItSays) {
  const Coverage covered = coverage(200, 8, 62.0, 6.0);
  EXPECT_GE(covered.half, 180);
  EXPECT_GE(covered.twentieth, 180);
}

TEST(FallThresholdTest, RefusesWhatIsNoLadder) {
  EXPECT_THAT(error_of({{10.0, 1, 0}}, false, 0.5), HasSubstr("1 levels, at least two"));
  EXPECT_THAT(error_of({{10.0, 1, 0}, {20.0, 1, 0}, {15.0, 1, 0}}, false, 0.5), HasSubstr("level 15 after 20"));
  EXPECT_THAT(error_of({{10.0, 1, 0}, {10.0, 1, 0}}, false, 0.5), HasSubstr("level 10 after 10"));
  EXPECT_THAT(error_of({{0.0, 1, 0}, {10.0, 1, 0}}, true, 0.5), HasSubstr("level 0 of a logarithmic ladder"));
  EXPECT_THAT(error_of({{std::nan(""), 1, 0}, {10.0, 1, 0}}, false, 0.5), HasSubstr("not finite"));
}

TEST(FallThresholdTest, RefusesCountsAndSharesThatCannotBe) {
  EXPECT_THAT(error_of({{10.0, 1, 2}, {20.0, 1, 0}}, false, 0.5), HasSubstr("2 falls in 1 trials at level 10"));
  EXPECT_THAT(error_of({{10.0, 1, -1}, {20.0, 1, 0}}, false, 0.5), HasSubstr("-1 falls"));
  for (const double share : {0.0, 1.0, -0.1, std::nan("")}) {
    EXPECT_THAT(error_of({{10.0, 1, 0}, {20.0, 1, 0}}, false, share), HasSubstr("between 0 and 1"));
  }
}

}  // namespace
}  // namespace dob::fall_threshold_test
