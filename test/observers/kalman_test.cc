#include "observers/kalman.h"

#include <random>

#include <gtest/gtest.h>

namespace dob::kalman_test {
namespace {

constexpr double kTick = 1e-3;

TEST(KalmanCovariance, IsAtItsSteadyStateFromTheStart) {
  for (const double dt : {0.5e-3, 1e-3, 2.5e-3}) {
    for (const KalmanOptions& options : {KalmanOptions{}, KalmanOptions{.process = 0.02, .decay = 3.0}}) {
      const KalmanCovariance steady(options, dt);
      KalmanCovariance next = steady;
      for (int k = 0; k < 1000; ++k) next.step(dt);
      EXPECT_NEAR(next.pp / steady.pp, 1.0, 1e-9);
      EXPECT_NEAR(next.pd / steady.pd, 1.0, 1e-9);
      EXPECT_NEAR(next.dd / steady.dd, 1.0, 1e-9);
    }
  }
}

// As dt -> 0 the steady state has a closed form without process noise and decay: with w^2 = walk / (noise sqrt(dt)),
// P_dd = sqrt(2) walk^2 / w and L_d = w^2 dt.
TEST(KalmanCovariance, ApproachesTheClosedFormOfContinuousTime) {
  double last = 1.0;
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    const KalmanOptions options{.walk = 1.0, .noise = 4e-4 / std::sqrt(dt)};  // w = 50 rad/s
    const KalmanCovariance P(options, dt);
    const double w = std::sqrt(options.walk / (options.noise * std::sqrt(dt)));
    const double error = std::abs(P.dd * w / std::sqrt(2.0) - 1.0);
    EXPECT_LT(error, 0.15 * last);
    EXPECT_NEAR(P.L_d / (w * w * dt), 1.0, 2.0 * w * dt);
    last = error;
  }
}

// A plant that is as the filter believes it to be: the errors have the covariance that the filter reports.
TEST(KalmanFilter, ReportsTheCovarianceOfItsErrors) {
  using Vector = Eigen::Matrix<double, 12, 1>;
  for (const KalmanOptions& options :
       {KalmanOptions{}, KalmanOptions{.walk = 0.5, .process = 0.01, .noise = 2e-3, .decay = 5.0}}) {
    std::mt19937_64 random{5};
    std::normal_distribution<double> normal;
    const auto noise = [&](double size) { return Vector(size * Vector::NullaryExpr([&] { return normal(random); })); };
    KalmanFilter<12> filter(options, kTick);
    Vector p = Vector::Zero();
    Vector d = Vector::Zero();
    Vector measured = noise(options.noise);
    double square = 0.0;
    int count = 0;
    constexpr int kFine = 10;  // Euler steps of the plant in a tick
    constexpr double kStep = kTick / kFine;
    for (int k = 0; k < 20000; ++k) {
      for (int i = 0; i < kFine; ++i) {
        p += kStep * d + noise(options.process * std::sqrt(kStep));
        d += -kStep * options.decay * d + noise(options.walk * std::sqrt(kStep));
      }
      const Vector before = measured;
      measured = p + noise(options.noise);
      filter.step(measured - before, kTick);
      if (k < 500) continue;
      square += (filter.estimate() - d).squaredNorm();
      count += 12;
    }
    EXPECT_NEAR(square / count / filter.covariance().dd, 1.0, 0.08);
  }
}

TEST(KalmanFilter, WithDecayFindsOnlyPartOfAConstantDisturbance) {
  KalmanFilter<3> filter({.decay = 20.0}, kTick);
  for (int k = 0; k < 5000; ++k) filter.step(Vec3::Constant(kTick), kTick);
  EXPECT_GT(filter.estimate()[0], 0.5);
  EXPECT_LT(filter.estimate()[0], 0.95);
}

TEST(KalmanOptions, RefusesNoiseThatIsNone) {
  for (const char* key : {"walk", "noise"}) {
    EXPECT_THROW(KalmanObserver("kalman", {{key, 0.0}}, kTick), OptionError) << key;
  }
  for (const char* key : {"process", "decay_rad_s"}) {
    EXPECT_NO_THROW(KalmanObserver("kalman", {{key, 0.0}}, kTick)) << key;
    EXPECT_THROW(KalmanObserver("kalman", {{key, -1.0}}, kTick), OptionError) << key;
  }
}

}  // namespace
}  // namespace dob::kalman_test
