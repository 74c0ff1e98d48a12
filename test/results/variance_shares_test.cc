#include "results/variance_shares.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::variance_shares_test {
namespace {

using ::testing::ElementsAre;
using Levels = std::vector<int>;

const VarianceShare& of(const std::vector<VarianceShare>& shares, const std::string& factor) {
  const auto share = std::find_if(shares.begin(), shares.end(), [&](const auto& s) { return s.factor == factor; });
  if (share == shares.end()) throw std::out_of_range("no share of " + factor);
  return *share;
}

double sum(const std::vector<VarianceShare>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0,
                         [](double x, const auto& share) { return x + share.share; });
}

// Calls value(levels of the factors and the seed) for every place of a design.
FactorialDesign design_of(std::vector<std::string> factors, Levels sizes,
                          const std::function<double(const Levels&)>& value) {
  FactorialDesign design{std::move(factors), sizes, {}};
  const int places = std::accumulate(sizes.begin(), sizes.end(), 1, std::multiplies<>());
  for (int place = 0; place < places; ++place) {
    Levels levels(sizes.size());
    for (std::size_t d = sizes.size(), rest = static_cast<std::size_t>(place); d-- > 0;) {
      levels[d] = static_cast<int>(rest % static_cast<std::size_t>(sizes[d]));
      rest /= static_cast<std::size_t>(sizes[d]);
    }
    design.values.push_back(value(levels));
  }
  return design;
}

// Two factors of two levels, two seeds (blocks), by hand:
//            seed 1  seed 2
//   a1 b1      1       3      mean 2
//   a1 b2      5       7      mean 6        means a: 4, 10;  b: 4, 10;  seeds: 6.5, 7.5;  all: 7
//   a2 b1      6       6      mean 6        SS a = 4 (9 + 9) = 72, b the same, seed = 4 (0.25 + 0.25) = 2
//   a2 b2     14      14      mean 14       SS ab = 2 (1 + 1 + 1 + 1) = 8, for mean - a - b + all = 1, -1, -1, 1
//   total: 36 + 16 + 4 + 0 + 1 + 1 + 49 + 49 = 156;  rest: 156 - 72 - 72 - 8 - 2 = 2
TEST(VarianceSharesTest, AgreeWithATwoWayAnalysisByHand) {
  const FactorialDesign design{{"a", "b"}, {2, 2, 2}, {1.0, 3.0, 5.0, 7.0, 6.0, 6.0, 14.0, 14.0}};
  const std::vector<VarianceShare> shares = variance_shares(design);
  ASSERT_EQ(shares.size(), 5U);
  EXPECT_NEAR(of(shares, "a").share, 72.0 / 156.0, 1e-14);
  EXPECT_NEAR(of(shares, "b").share, 72.0 / 156.0, 1e-14);
  EXPECT_NEAR(of(shares, "a x b").share, 8.0 / 156.0, 1e-14);
  EXPECT_NEAR(of(shares, "seed").share, 2.0 / 156.0, 1e-14);
  EXPECT_NEAR(of(shares, "residual").share, 2.0 / 156.0, 1e-14);
  EXPECT_EQ(of(shares, "a").levels, 2);
  EXPECT_EQ(of(shares, "a x b").levels, 4);
  EXPECT_EQ(of(shares, "seed").levels, 2);
  EXPECT_EQ(of(shares, "residual").levels, 0);
}

TEST(VarianceSharesTest, AreSortedWithTheResidualLast) {
  const FactorialDesign design = design_of({"little", "much"}, {2, 3, 2}, [](const Levels& at) {
    return 1.0 * at[0] + 3.0 * at[1] + 100.0 * (at[0] == at[2] && at[1] == 1 ? 1.0 : 0.0);
  });
  const std::vector<VarianceShare> shares = variance_shares(design);
  EXPECT_EQ(shares.back().factor, "residual");
  EXPECT_TRUE(
      std::is_sorted(shares.begin(), shares.end() - 1, [](const auto& a, const auto& b) { return a.share > b.share; }));
}

TEST(VarianceSharesTest, FactorsThatAddUpLeaveNothingToPairsAndResidual) {
  // Evenly spaced effects e at n levels: variance e^2 (n^2 - 1) / 12; here 4 * 2/3, 9 * 5/4 and, for the seeds, 2/3.
  const FactorialDesign design =
      design_of({"a", "b"}, {3, 4, 3}, [](const Levels& at) { return 1000.0 + 2.0 * at[0] - 3.0 * at[1] + at[2]; });
  const std::vector<VarianceShare> shares = variance_shares(design);
  const double total = 8.0 / 3.0 + 45.0 / 4.0 + 2.0 / 3.0;
  EXPECT_NEAR(of(shares, "a").share, 8.0 / 3.0 / total, 1e-12);
  EXPECT_NEAR(of(shares, "b").share, 45.0 / 4.0 / total, 1e-12);
  EXPECT_NEAR(of(shares, "seed").share, 2.0 / 3.0 / total, 1e-12);
  EXPECT_NEAR(of(shares, "a x b").share, 0.0, 1e-12);
  EXPECT_NEAR(of(shares, "residual").share, 0.0, 1e-12);
}

TEST(VarianceSharesTest, PairThatActsOnlyTogetherIsItsInteraction) {
  const FactorialDesign design = design_of({"a", "b", "c"}, {2, 2, 3, 2}, [](const Levels& at) {
    return (at[0] == 1) == (at[1] == 1) ? 1.0 : -1.0;  // exclusive or
  });
  const std::vector<VarianceShare> shares = variance_shares(design);
  EXPECT_NEAR(of(shares, "a x b").share, 1.0, 1e-12);
  EXPECT_EQ(shares.front().factor, "a x b");
  EXPECT_EQ(shares.size(), 8U);  // three factors, three pairs, seed, residual
}

TEST(VarianceSharesTest, SumToOneAndAFactorThatDoesNothingHasNearlyNone) {
  std::mt19937_64 random(11);
  const auto noise = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5; };
  const FactorialDesign design = design_of({"works", "idle", "also works"}, {3, 2, 4, 10}, [&](const Levels& at) {
    return 2.0 * at[0] + at[2] + 0.3 * at[0] * at[2] + 0.5 * noise();
  });
  const std::vector<VarianceShare> shares = variance_shares(design);
  EXPECT_NEAR(sum(shares), 1.0, 1e-12);
  EXPECT_LT(of(shares, "idle").share, 0.001);
  EXPECT_LT(of(shares, "works x idle").share, 0.001);
  EXPECT_GT(of(shares, "works").share, 0.5);
}

TEST(VarianceSharesTest, IntervalsHoldTheirSharesAndAreTheSameAgain) {
  std::mt19937_64 random(5);
  const auto noise = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5; };
  const FactorialDesign design =
      design_of({"a", "b"}, {2, 3, 12}, [&](const Levels& at) { return at[0] + 0.2 * at[1] + noise(); });
  const std::vector<VarianceShare> shares = variance_shares(design), again = variance_shares(design);
  for (const char* factor : {"a", "b"}) {
    const std::optional<Interval> interval = of(shares, factor).interval;
    ASSERT_TRUE(interval) << factor;
    EXPECT_LE(interval->low, of(shares, factor).share);
    EXPECT_GE(interval->high, of(shares, factor).share);
    EXPECT_LT(interval->low, interval->high);
    EXPECT_EQ(interval->low, of(again, factor).interval->low);
    EXPECT_EQ(interval->high, of(again, factor).interval->high);
  }
  ASSERT_TRUE(shares.back().interval);
}

TEST(VarianceSharesTest, IntervalOfSeedsThatAgreeIsAPoint) {
  const FactorialDesign design = design_of({"a", "b"}, {2, 2, 8}, [](const Levels& at) { return 3.0 * at[0] + at[1]; });
  const std::optional<Interval> interval = of(variance_shares(design), "a").interval;
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, 0.9, 1e-12);
  EXPECT_NEAR(interval->high, 0.9, 1e-12);
}

TEST(VarianceSharesTest, SevenSeedsHaveNoInterval) {
  const FactorialDesign design = design_of({"a"}, {2, 7}, [](const Levels& at) { return 1.0 * at[0] * at[1]; });
  for (const VarianceShare& share : variance_shares(design)) EXPECT_FALSE(share.interval) << share.factor;
}

TEST(VarianceSharesTest, WhatHasOneLevelHasNoShare) {
  const FactorialDesign design = design_of({"one", "two"}, {1, 2, 1}, [](const Levels& at) { return 1.0 * at[1]; });
  const std::vector<VarianceShare> shares = variance_shares(design);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0].factor, "two");
  EXPECT_EQ(shares[0].share, 1.0);
  EXPECT_EQ(shares[1].factor, "residual");
}

TEST(VarianceSharesTest, WithoutVarianceThereIsNothingToShare) {
  EXPECT_TRUE(variance_shares(design_of({"a"}, {2, 9}, [](const Levels&) { return 0.1; })).empty());
  EXPECT_TRUE(variance_shares(FactorialDesign{{"a"}, {0, 0}, {}}).empty());
}

TEST(VarianceSharesTest, RefusesADesignThatIsNotFull) {
  EXPECT_THROW(variance_shares({{"a"}, {2, 2}, {1.0, 2.0, 3.0}}), std::invalid_argument);
  EXPECT_THROW(variance_shares({{"a"}, {2}, {1.0, 2.0}}), std::invalid_argument);
}

// A design of places 0, 1, 2 ... without those in `missing`.
PartialDesign without(const std::vector<int>& missing, const Levels& sizes) {
  const FactorialDesign full =
      design_of(std::vector<std::string>(sizes.size() - 1, "f"), sizes, [](const Levels&) { return 0.0; });
  PartialDesign design{full.factors, full.levels, {}};
  for (int place = 0; static_cast<std::size_t>(place) < full.values.size(); ++place) {
    const bool is_missing = std::find(missing.begin(), missing.end(), place) != missing.end();
    design.values.push_back(is_missing ? std::nullopt : std::optional<double>(place));
  }
  return design;
}

TEST(CompleteDesignTest, LeavesACompleteOneAsItIs) {
  const FactorialDesign complete = complete_part(without({}, {2, 3}));
  EXPECT_THAT(complete.levels, ElementsAre(2, 3));
  EXPECT_THAT(complete.values, ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0, 5.0));
}

TEST(CompleteDesignTest, LoneErrorTakesItsSeedAlong) {
  // Three levels of three seeds: the level and the seed lack a third alike, and the seed goes.
  const FactorialDesign complete = complete_part(without({4}, {3, 3}));
  EXPECT_THAT(complete.levels, ElementsAre(3, 2));
  EXPECT_THAT(complete.values, ElementsAre(0.0, 2.0, 3.0, 5.0, 6.0, 8.0));
}

TEST(CompleteDesignTest, LevelThatCouldNeverBeRunGoesAndNoSeedWithIt) {
  const FactorialDesign complete = complete_part(without({3, 4, 5}, {3, 3}));
  EXPECT_THAT(complete.levels, ElementsAre(2, 3));
  EXPECT_THAT(complete.values, ElementsAre(0.0, 1.0, 2.0, 6.0, 7.0, 8.0));
}

TEST(CompleteDesignTest, NothingIsLeftOfNothing) {
  const FactorialDesign complete = complete_part(without({0, 1, 2, 3}, {2, 2}));
  EXPECT_TRUE(complete.values.empty());
  EXPECT_TRUE(variance_shares(complete).empty());
}

}  // namespace
}  // namespace dob::variance_shares_test
