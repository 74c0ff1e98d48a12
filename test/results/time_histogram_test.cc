#include "results/time_histogram.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dob::time_histogram_test {
namespace {

TEST(TimeHistogram, ADurationIsInTheBinWhoseLowerEdgeItReaches) {
  // 20 bins for each factor of ten: 1 us begins one, 10^0.05 us the next.
  const TimeHistogram histogram = time_histogram({1.0, 1.1, std::pow(10.0, 0.05), 10.0});
  ASSERT_EQ(histogram.counts.size(), 21U);
  ASSERT_EQ(histogram.edges_us.size(), 22U);
  EXPECT_EQ(histogram.edges_us.front(), 1.0);
  EXPECT_EQ(histogram.edges_us[20], 10.0);
  EXPECT_EQ(histogram.counts[0], 2);
  EXPECT_EQ(histogram.counts[1], 1);
  EXPECT_EQ(histogram.counts[20], 1);
  for (std::size_t i = 2; i < 20; ++i) EXPECT_EQ(histogram.counts[i], 0);
}

TEST(TimeHistogram, EveryDurationIsCountedOnceBetweenItsEdges) {
  for (int i = 0; i < 2000; ++i) {
    const double duration = 0.02 * std::pow(1.01, i);
    const TimeHistogram one = time_histogram({duration});
    ASSERT_EQ(one.counts, std::vector<long>{1});
    ASSERT_LE(one.edges_us[0], duration);
    ASSERT_GT(one.edges_us[1], duration);
    ASSERT_NEAR(one.edges_us[1] / one.edges_us[0], std::pow(10.0, 0.05), 1e-12);
  }
}

TEST(TimeHistogram, ZeroIsInTheShortestBin) {
  const TimeHistogram histogram = time_histogram({0.0});
  EXPECT_EQ(histogram.counts, std::vector<long>{1});
  EXPECT_NEAR(histogram.edges_us[0], 0.01, 1e-9);
}

TEST(TimeHistogram, NothingIsEmptyAndWhatIsNoDurationIsRefused) {
  EXPECT_TRUE(time_histogram({}).edges_us.empty());
  EXPECT_TRUE(time_histogram({}).counts.empty());
  EXPECT_THROW(time_histogram({-1.0}), std::invalid_argument);
  EXPECT_THROW(time_histogram({std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  EXPECT_THROW(time_histogram({std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

}  // namespace
}  // namespace dob::time_histogram_test
