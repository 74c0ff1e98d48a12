#include "bench/campaign_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/fall_threshold.h"

namespace dob::campaign_search_test {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::Le;

CampaignAxis ladder(int levels) {
  CampaignAxis axis{"amplitude", "N", {}, true};
  for (int i = 0; i < levels; ++i) axis.levels.push_back(10.0 * std::pow(1.12, i));
  return axis;
}

// Runs a search to its end; `falls(level, seed)` is what a trial would come to.
std::vector<LevelState> search(const CampaignAxis& axis, int seeds, long budget,
                               const std::function<bool(int, int)>& falls) {
  std::vector<LevelState> levels(axis.levels.size(), LevelState{.cells = seeds});
  long left = budget;
  while (true) {
    const std::vector<int> wanted = next_of_limit(axis, levels, left);
    if (wanted.empty()) return levels;
    for (const int level : wanted) {
      LevelState& state = levels.at(static_cast<std::size_t>(level));
      EXPECT_LT(state.used(), state.cells);
      state.falls += falls(level, state.used()) ? 1 : 0;
      ++state.trials;
      --left;
    }
    EXPECT_GE(left, 0);
  }
}

FallThreshold half_of(const CampaignAxis& axis, const std::vector<LevelState>& levels) {
  std::vector<LevelCount> counts;
  for (std::size_t i = 0; i < levels.size(); ++i) counts.push_back({axis.levels[i], levels[i].trials, levels[i].falls});
  return fall_threshold(counts, axis.logarithmic, 0.5);
}

int trials_of(const std::vector<LevelState>& levels) {
  int trials = 0;
  for (const LevelState& level : levels) trials += level.trials;
  return trials;
}

TEST(CampaignSearch, FindsASharpStepWithFewTrialsNearIt) {
  const CampaignAxis axis = ladder(30);
  const auto levels = search(axis, 20, 200, [](int level, int) { return level >= 17; });
  const FallThreshold half = half_of(axis, levels);
  EXPECT_GT(half.estimate, axis.levels[15]);
  EXPECT_LT(half.estimate, axis.levels[18]);
  EXPECT_LT(trials_of(levels), 100) << "a step needs no search to the end of the budget";
}

TEST(CampaignSearch, SpendsMostTrialsWhereTheOutcomeIsOpen) {
  const CampaignAxis axis = ladder(30);
  std::mt19937_64 random(7);
  const auto falls = [&](int level, int) {
    const double p = 1.0 / (1.0 + std::exp(-(level - 14.0) / 1.5));
    return std::uniform_real_distribution<double>(0.0, 1.0)(random) < p;
  };
  const auto levels = search(axis, 40, 120, falls);
  int near = 0;
  for (std::size_t i = 6; i <= 19; ++i) near += levels[i].trials;
  EXPECT_GT(near, trials_of(levels) / 2);
  const FallThreshold half = half_of(axis, levels);
  EXPECT_GT(half.estimate, axis.levels[12]);
  EXPECT_LT(half.estimate, axis.levels[16]);
}

TEST(CampaignSearch, LooksForFallsBelowAndSurvivorsAbove) {
  const CampaignAxis axis = ladder(30);
  const auto levels = search(axis, 20, 200, [](int level, int) { return level >= 17; });
  int below = 0, above = 0;
  for (std::size_t i = 0; i < 12; ++i) below += levels[i].trials;
  for (std::size_t i = 22; i < 30; ++i) above += levels[i].trials;
  EXPECT_GT(below, 4);
  EXPECT_GT(above, 4);
}

TEST(CampaignSearch, GivesUpWhereNothingFallsOrEverythingDoes) {
  const CampaignAxis axis = ladder(24);
  EXPECT_LT(trials_of(search(axis, 20, 400, [](int, int) { return false; })), 200);
  EXPECT_LT(trials_of(search(axis, 20, 400, [](int, int) { return true; })), 200);
}

TEST(CampaignSearch, KeepsToItsBudgetAndItsSeeds) {
  const CampaignAxis axis = ladder(24);
  std::mt19937_64 random(3);
  const auto coin = [&](int, int) { return (random() & 1U) != 0; };
  EXPECT_EQ(trials_of(search(axis, 20, 33, coin)), 33);
  EXPECT_EQ(trials_of(search(axis, 2, 1000, coin)), 48);
}

TEST(CampaignSearch, StartsAtBothEndsAndBetween) {
  const CampaignAxis axis = ladder(24);
  const std::vector<int> first = next_of_limit(axis, std::vector<LevelState>(24, LevelState{.cells = 5}), 60);
  const std::set<int> levels(first.begin(), first.end());
  EXPECT_EQ(first.size(), 12U);
  EXPECT_EQ(levels.size(), 6U);
  EXPECT_EQ(*levels.begin(), 0);
  EXPECT_EQ(*levels.rbegin(), 23);
  EXPECT_EQ(next_of_limit(axis, std::vector<LevelState>(24, LevelState{.cells = 5}), 5).size(), 5U);
}

TEST(CampaignSearch, TrialsThatCannotBeRunEndIt) {
  std::vector<LevelState> levels(24, LevelState{.cells = 5});
  for (const std::size_t i : {0U, 5U, 9U, 14U, 18U, 23U}) levels[i].errors = 2;
  EXPECT_THAT(next_of_limit(ladder(24), levels, 40), IsEmpty());
}

TEST(CampaignSearch, ABreakdownGoesLevelByLevelUntilTwoHaveBroken) {
  std::vector<LevelState> levels(5, LevelState{.cells = 3});
  EXPECT_THAT(next_of_breakdown(levels, 100), ElementsAre(0, 0, 0));
  levels[0].trials = 3;
  EXPECT_THAT(next_of_breakdown(levels, 100), ElementsAre(1, 1, 1));
  EXPECT_THAT(next_of_breakdown(levels, 2), ElementsAre(1, 1));
  levels[1] = {.cells = 3, .trials = 3, .falls = 3};
  EXPECT_THAT(next_of_breakdown(levels, 100), ElementsAre(2, 2, 2));
  levels[2] = {.cells = 3, .trials = 3, .falls = 2};  // not monotone: goes on
  levels[3] = {.cells = 3, .trials = 2, .falls = 2, .errors = 1};
  EXPECT_THAT(next_of_breakdown(levels, 100), ElementsAre(4, 4, 4));
  levels[2].falls = 3;
  EXPECT_THAT(next_of_breakdown(levels, 100), IsEmpty());
}

}  // namespace
}  // namespace dob::campaign_search_test
