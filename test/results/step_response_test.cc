#include "results/step_response.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/quiet_tick.h"

namespace dob::step_response_test {
namespace {

using test::quiet;
using ::testing::DoubleNear;
using ::testing::Optional;

constexpr double kDt = 0.001;
const Vec3 kForce(0.0, -20.0, 0.0);

TickRecord estimated(const Vec3& estimate, const Vec3& truth = kForce) {
  TickRecord r = quiet();
  r.has_force_estimate = r.has_leg_estimate = true;
  r.force_estimate = estimate;
  r.force_true = truth;
  return r;
}

// A second order low pass of unit gain, damping d and natural frequency w, from the onset on.
StepResponse second_order(double d, double w, int ticks) {
  StepResponse step(kDt);
  for (int i = 0; i < 500; ++i) step.add(quiet());
  const double wd = w * std::sqrt(1.0 - d * d);
  for (int i = 1; i <= ticks; ++i) {
    const double t = i * kDt;
    const double y = 1.0 - std::exp(-d * w * t) * (std::cos(wd * t) + d * w / wd * std::sin(wd * t));
    step.add(estimated(y * kForce));
  }
  return step;
}

TEST(StepResponseTest, OvershootIsThatOfTheSecondOrderStep) {
  const double d = 0.5;
  const StepResponse step = second_order(d, 6.28, 3000);
  // Classical: exp(-pi d / sqrt(1 - d^2)); a tick of 1 ms misses the top by less than 1e-5.
  EXPECT_THAT(step.overshoot(), Optional(DoubleNear(std::exp(-M_PI * d / std::sqrt(1.0 - d * d)), 1e-5)));
}

TEST(StepResponseTest, AnEstimateThatCreepsUpDoesNotOvershootAndSettlesAtThreeTimeConstants) {
  StepResponse step(kDt);
  const double k = 10.0;
  for (int i = 1; i <= 1000; ++i) step.add(estimated((1.0 - std::exp(-k * i * kDt)) * kForce));
  EXPECT_THAT(step.overshoot(), Optional(0.0));
  EXPECT_THAT(step.settling_s(), Optional(DoubleNear(std::log(20.0) / k, kDt)));  // exp(-k t) = 5 %
}

TEST(StepResponseTest, OnlyTheDirectionOfTheForceCounts) {
  StepResponse step(kDt);
  step.add(estimated(kForce + Vec3(50.0, 0.0, 50.0)));
  EXPECT_THAT(step.overshoot(), Optional(DoubleNear(0.0, 1e-12)));
}

TEST(StepResponseTest, AnEstimateThatNeverStaysHasNoSettlingTime) {
  StepResponse step(kDt);
  for (int i = 0; i < 1001; ++i) step.add(estimated((i % 10 == 0 ? 1.5 : 1.0) * kForce));
  EXPECT_EQ(step.settling_s(), std::nullopt);
  EXPECT_THAT(step.overshoot(), Optional(DoubleNear(0.5, 1e-12)));
}

TEST(StepResponseTest, ForcesThatChangeOrEndAreNoSteps) {
  StepResponse changes(kDt), ends(kDt);
  changes.add(estimated(kForce));
  ends.add(estimated(kForce));
  changes.add(estimated(kForce, 1.01 * kForce));
  ends.add(quiet());
  EXPECT_EQ(changes.overshoot(), std::nullopt);
  EXPECT_EQ(ends.overshoot(), std::nullopt);
  EXPECT_EQ(ends.settling_s(), std::nullopt);
}

TEST(StepResponseTest, WithoutAnEstimateThereIsNone) {
  StepResponse step(kDt);
  step.add(quiet());
  EXPECT_EQ(step.overshoot(), std::nullopt);
  EXPECT_EQ(step.settling_s(), std::nullopt);
}

}  // namespace
}  // namespace dob::step_response_test
