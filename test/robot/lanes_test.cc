#include "robot/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace dob {
namespace {

TEST(Lanes, SineAndCosineAreExactToRoundingOverTheStatedRange) {
  std::mt19937_64 random(1);
  for (const double range : {0.8, 3.0, 10.0, 1e3, 1e5}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    long double worst = 0.0L;
    for (int i = 0; i < 20000; ++i) {
      const Lanes x{uniform(random), uniform(random)};
      const SinCos answer = sincos(x);
      for (int lane = 0; lane < kLanes; ++lane) {
        worst = std::max({worst, std::abs(answer.sin[lane] - std::sin(static_cast<long double>(x[lane]))),
                          std::abs(answer.cos[lane] - std::cos(static_cast<long double>(x[lane])))});
      }
    }
    EXPECT_LT(worst, 2e-16L) << "|x| <= " << range;
  }
}

TEST(Lanes, NaNStaysInItsLane) {
  const SinCos answer = sincos(Lanes{std::numeric_limits<double>::quiet_NaN(), 0.5});
  EXPECT_TRUE(std::isnan(answer.sin[0]));
  EXPECT_TRUE(std::isnan(answer.cos[0]));
  EXPECT_NEAR(answer.sin[1], std::sin(0.5), 2e-16);
}

}  // namespace
}  // namespace dob
