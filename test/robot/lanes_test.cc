#include "robot/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace dob::lanes_test {
namespace {

TEST(Lanes, SineAndCosineAreExactToRoundingOverTheStatedRange) {
  std::mt19937_64 random(1);
  for (const double range : {0.8, 3.0, 10.0, 1e3, 1e5}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    long double worst = 0.0L;
    for (int i = 0; i < 20000; ++i) {
      Lanes x;
      for (int lane = 0; lane < kLanes; ++lane) x[lane] = uniform(random);
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
  for (int bad = 0; bad < kLanes; ++bad) {
    Lanes x = broadcast(0.5);
    x[bad] = std::numeric_limits<double>::quiet_NaN();
    const SinCos answer = sincos(x);
    for (int lane = 0; lane < kLanes; ++lane) {
      EXPECT_EQ(std::isnan(answer.sin[lane]), lane == bad);
      EXPECT_EQ(std::isnan(answer.cos[lane]), lane == bad);
      if (lane == bad) continue;
      EXPECT_NEAR(answer.sin[lane], std::sin(0.5), 2e-16);
    }
  }
}

Lanes numbered() {
  Lanes x;
  for (int lane = 0; lane < kLanes; ++lane) x[lane] = lane + 1.0;
  return x;
}

TEST(Lanes, RotateByOneGatherWithAStrideAndSum) {
  const Lanes rotated = rotate_lanes(numbered());
  const double memory[] = {1.0, -1.0, -1.0, 2.0, -1.0, -1.0, 3.0, -1.0, -1.0, 4.0, -1.0, -1.0};
  const Lanes gathered = gather_lanes<3>(memory);
  for (int lane = 0; lane < kLanes; ++lane) {
    EXPECT_EQ(rotated[lane], (lane + 1) % kLanes + 1.0);
    EXPECT_EQ(gathered[lane], lane + 1.0);
    EXPECT_TRUE(std::signbit(broadcast(-0.0)[lane]));
  }
  EXPECT_EQ(sum_lanes(numbered()), kLanes * (kLanes + 1) / 2.0);
}

TEST(Lanes, AreStoredAsVectorsOfTheirLegsAndNothingBeside) {
  std::array<double, 4 * kLanes> memory;
  memory.fill(-1.0);
  store({numbered(), 10.0 * numbered(), 100.0 * numbered()}, [&](int n) { return memory.data() + 4 * n; });
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double x = static_cast<double>(lane) + 1.0;
    EXPECT_EQ(memory[4 * lane], x);
    EXPECT_EQ(memory[4 * lane + 1], 10.0 * x);
    EXPECT_EQ(memory[4 * lane + 2], 100.0 * x);
    EXPECT_EQ(memory[4 * lane + 3], -1.0);
  }
}

}  // namespace
}  // namespace dob::lanes_test
