#include "observers/sliding_mode.h"

#include <gtest/gtest.h>

namespace dob::sliding_mode_test {
namespace {

constexpr SlidingModeOptions kOptions{.rate = 200.0};  // S_1 = 220 N m/s

// The bound on the chatter is zero: not even the last digits move, apart from those of the input.
TEST(SuperTwistingFilter, FindsAConstantDisturbanceInFiniteTimeAndDoesNotChatterThere) {
  for (const double dt : {0.5e-3, 1e-3, 2.5e-3}) {
    SuperTwistingFilter<3> filter(kOptions, dt);
    const Vec3 d(5.0, -3.0, 0.1);
    double before = 0.0;
    for (int k = 0; k * dt < 1.0; ++k) {
      filter.step(dt * d, dt);
      if (k * dt < 0.25) {
        EXPECT_LE(std::abs(filter.estimate()[0] - before), dt * 220.0 * (1.0 + 1e-12)) << "on the way there";
        before = filter.estimate()[0];
      } else {
        ASSERT_LT((filter.estimate() - d).cwiseAbs().maxCoeff(), 1e-13) << "tick " << k << " of " << dt;
      }
    }
  }
}

TEST(SuperTwistingFilter, FollowsADisturbanceWithinItsRateToTheLastDigit) {
  constexpr double kDt = 1e-3;
  SuperTwistingFilter<3> filter(kOptions, kDt);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 d = Vec3(10.0, -5.0, 1.0) * std::sin(20.0 * k * kDt);  // 200 N m/s at most
    filter.step(kDt * d, kDt);
    if (k > 500) {
      ASSERT_LT((filter.estimate() - d).cwiseAbs().maxCoeff(), 1e-11) << k;
    }
  }
}

TEST(SuperTwistingFilter, RespondsAlikeAtAllAmplitudesWhenItsRateGoesWithThem) {
  constexpr double kDt = 1e-3;
  SuperTwistingFilter<3> small(kOptions, kDt);
  SuperTwistingFilter<3> large({.rate = 64.0 * kOptions.rate}, kDt);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 d = Vec3(5.0, -20.0, 40.0) * std::sin(70.0 * k * kDt);
    small.step(kDt * d, kDt);
    large.step(kDt * 64.0 * d, kDt);
    ASSERT_LT((large.estimate() / 64.0 - small.estimate()).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
}

TEST(SuperTwistingFilter, ComesFromFarAwayFasterWithLinearTerms) {
  const auto ticks = [](double linear) {
    SuperTwistingFilter<3> filter({.rate = 50.0, .linear = linear}, 1e-3);
    int k = 0;
    while (k < 100000 && (filter.estimate() - Vec3::Constant(100.0)).norm() > 1e-9) {
      filter.step(Vec3::Constant(0.1), 1e-3);
      ++k;
    }
    return k;
  };
  EXPECT_LT(ticks(50.0), 0.5 * ticks(0.0));
}

}  // namespace
}  // namespace dob::sliding_mode_test
