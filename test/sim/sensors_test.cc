#include "sim/sensors.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::sensors_test {
namespace {

StepResult some_step() {
  StepResult step;
  for (int i = 0; i < kJoints; ++i) step.joint_torque[i] = 3.0 * i - 10.0;
  for (std::size_t leg = 0; leg < kLegs; ++leg) step.foot_force_W[leg] = {5.0, -20.0, 50.0 + 10.0 * double(leg)};
  return step;
}

TEST(Sensors, WithoutNoiseReadTheTruthExactly) {
  Sensors sensors({}, 1);
  const StepResult step = some_step();
  const SensorReading reading = sensors.measure(step);
  EXPECT_EQ(reading.joint_torque, step.joint_torque);
  EXPECT_EQ(reading.foot_force_W, step.foot_force_W);
}

// Moments of the normalised errors; with n = 24 * 20000 the standard errors are 0.0014, 0.002, 0.0035 and
// 0.007.
TEST(Sensors, NoiseIsGaussianWithTheStatedFractionOfEveryComponent) {
  Sensors sensors({0.1, 0.05}, 7);
  const StepResult step = some_step();
  double count = 0.0;
  Eigen::Vector4d moments = Eigen::Vector4d::Zero();
  const auto add = [&](double measured, double truth, double fraction) {
    const double z = (measured - truth) / (fraction * truth);
    moments += Eigen::Vector4d(z, z * z, z * z * z, z * z * z * z);
    count += 1.0;
  };
  for (int n = 0; n < 20000; ++n) {
    const SensorReading reading = sensors.measure(step);
    for (int i = 0; i < kJoints; ++i) add(reading.joint_torque[i], step.joint_torque[i], 0.1);
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      for (int k = 0; k < 3; ++k) add(reading.foot_force_W[leg][k], step.foot_force_W[leg][k], 0.05);
    }
  }
  moments /= count;
  EXPECT_NEAR(moments[0], 0.0, 0.006);
  EXPECT_NEAR(moments[1], 1.0, 0.008);
  EXPECT_NEAR(moments[2], 0.0, 0.022);
  EXPECT_NEAR(moments[3], 3.0, 0.06);
}

TEST(Sensors, NoiseOfSuccessiveReadingsAndOfNeighboursIsIndependent) {
  Sensors sensors({0.1, 0.1}, 11);
  StepResult step;
  step.joint_torque.setConstant(10.0);
  double lagged = 0.0;
  double neighbours = 0.0;
  Vec12 previous = Vec12::Zero();
  const int n = 40000;
  for (int k = 0; k < n; ++k) {
    const Vec12 z = sensors.measure(step).joint_torque - step.joint_torque;
    lagged += z.dot(previous) / kJoints;
    neighbours += z[0] * z[1];  // the two deviates of one Box-Muller pair
    previous = z;
  }
  EXPECT_NEAR(lagged / n, 0.0, 5.0 / std::sqrt(12.0 * n));
  EXPECT_NEAR(neighbours / n, 0.0, 5.0 / std::sqrt(1.0 * n));
}

TEST(Sensors, SameSeedGivesTheSameBitsAndAnotherSeedDoesNot) {
  const StepResult step = some_step();
  Sensors a({0.1, 0.1}, 42);
  Sensors b({0.1, 0.1}, 42);
  Sensors c({0.1, 0.1}, 43);
  for (int k = 0; k < 100; ++k) {
    const SensorReading reading = a.measure(step);
    const SensorReading again = b.measure(step);
    EXPECT_EQ(reading.joint_torque, again.joint_torque);
    EXPECT_EQ(reading.foot_force_W, again.foot_force_W);
    EXPECT_NE(reading.joint_torque, c.measure(step).joint_torque);
  }
}

TEST(Sensors, NoiseOfAReadingDoesNotDependOnEarlierSignals) {
  Sensors a({0.1, 0.1}, 5);
  Sensors b({0.1, 0.1}, 5);
  a.measure(some_step());
  b.measure(StepResult{});
  EXPECT_EQ(a.measure(some_step()).joint_torque, b.measure(some_step()).joint_torque);
}

TEST(Sensors, RefuseANegativeFraction) {
  EXPECT_THAT(
      [] {
        Sensors({-0.1, 0.0}, 1);
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("torque_relative = -0.1")));
}

}  // namespace
}  // namespace dob::sensors_test
