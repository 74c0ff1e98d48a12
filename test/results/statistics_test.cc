#include "results/statistics.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::statistics_test {
namespace {

std::vector<double> zero_to(int last) {
  std::vector<double> samples(static_cast<std::size_t>(last) + 1);
  std::iota(samples.begin(), samples.end(), 0.0);
  return samples;
}

TEST(QuantileTest, MedianIsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
  EXPECT_EQ(median({7.0}), 7.0);
}

TEST(QuantileTest, InterpolatesBetweenOrderStatistics) {
  // n = 5: h = 4 p.
  const std::vector<double> samples{50.0, 10.0, 40.0, 20.0, 30.0};
  EXPECT_EQ(quantile(samples, 0.0), 10.0);
  EXPECT_EQ(quantile(samples, 0.25), 20.0);
  EXPECT_DOUBLE_EQ(quantile(samples, 0.3), 22.0);  // h = 1.2
  EXPECT_EQ(quantile(samples, 1.0), 50.0);
  EXPECT_DOUBLE_EQ(quantile(zero_to(200), 0.99), 198.0);
}

TEST(QuantileTest, RefusesWhatHasNoAnswer) {
  EXPECT_THROW(quantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW(quantile({1.0}, 1.01), std::invalid_argument);
  EXPECT_THROW(quantile({1.0}, std::nan("")), std::invalid_argument);
  EXPECT_THROW(median({1.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(median({1.0, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

TEST(WilsonTest, AgreesWithTheClosedFormsAtNoneAndHalf) {
  constexpr double z2 = 3.841458820694124;  // chi-squared, one degree of freedom, 95 %
  const auto none = wilson_interval(0, 10);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->low, 0.0);
  EXPECT_NEAR(none->high, z2 / (10.0 + z2), 1e-14);

  const auto half = wilson_interval(5, 10);
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->low, 0.5 - 0.5 * std::sqrt(z2 / (10.0 + z2)), 1e-14);
  EXPECT_NEAR(half->high, 0.5 + 0.5 * std::sqrt(z2 / (10.0 + z2)), 1e-14);
}

TEST(WilsonTest, BoundsSolveTheScoreEquation) {
  // Both ends p satisfy (k/n - p)^2 = z^2 p (1 - p) / n.
  constexpr double z2 = 3.841458820694124;
  for (int k = 1; k < 13; ++k) {
    const auto interval = wilson_interval(k, 13);
    ASSERT_TRUE(interval);
    for (const double p : {interval->low, interval->high}) {
      EXPECT_NEAR(std::pow(k / 13.0 - p, 2), z2 * p * (1.0 - p) / 13.0, 1e-14) << k;
    }
    EXPECT_LT(interval->low, k / 13.0);
    EXPECT_GT(interval->high, k / 13.0);
  }
}

TEST(WilsonTest, IsSymmetricAndEndsAtOneWhenAllFell) {
  const auto all = wilson_interval(9, 9);
  const auto none = wilson_interval(0, 9);
  ASSERT_TRUE(all && none);
  EXPECT_EQ(all->high, 1.0);
  EXPECT_NEAR(all->low, 1.0 - none->high, 1e-15);
}

TEST(WilsonTest, SaysNothingBelowEightTrialsAndRefusesNonsense) {
  EXPECT_FALSE(wilson_interval(3, 7));
  EXPECT_TRUE(wilson_interval(3, 8));
  EXPECT_THROW(wilson_interval(-1, 8), std::invalid_argument);
  EXPECT_THROW(wilson_interval(9, 8), std::invalid_argument);
}

TEST(BootstrapTest, FindsTheOrderStatisticsOfTheExactBootstrapDistribution) {
  // The median of a resample of 11 values is at most the k-th smallest with probability P(Bin(11, k/11) >= 6):
  // 0.0072 for k = 2 and 0.0513 for k = 3, so that 2.5 % is reached at the third smallest, by symmetry also above.
  const auto interval = bootstrap_median_interval(zero_to(10));
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 2.0);
  EXPECT_EQ(interval->high, 8.0);
}

TEST(BootstrapTest, GivesTheSameBitsEverywhere) {
  // Computed by an independent implementation of the 64-bit Mersenne Twister with the same draws.
  std::vector<double> squares = zero_to(99);
  for (double& x : squares) x *= x;
  const auto interval = bootstrap_median_interval(squares);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 1560.5);
  EXPECT_EQ(interval->high, 3540.5);
}

TEST(BootstrapTest, DoesNotDependOnTheOrderOfTheSamples) {
  const auto a = bootstrap_median_interval({1.0, 2.5, 3.0, 4.5, 5.0, 6.5, 7.0, 9.0});
  const auto b = bootstrap_median_interval({9.0, 2.5, 7.0, 1.0, 5.0, 4.5, 6.5, 3.0});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->low, b->low);
  EXPECT_EQ(a->high, b->high);
  EXPECT_LT(a->low, a->high);
}

TEST(BootstrapTest, SaysNothingBelowEightSamples) {
  EXPECT_FALSE(bootstrap_median_interval(zero_to(6)));
  EXPECT_TRUE(bootstrap_median_interval(zero_to(7)));
}

}  // namespace
}  // namespace dob::statistics_test
