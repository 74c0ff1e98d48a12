#include "sim/disturbance.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::disturbance_test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ForceProfile, AStepStaysOnForEver) {
  ForceProfile step;
  step.amplitude_N = 20.0;
  step.start_s = 1.0;
  EXPECT_EQ(step.value(0.999), 0.0);
  EXPECT_EQ(step.value(1.0), 20.0);
  EXPECT_EQ(step.value(1e6), 20.0);
}

TEST(ForceProfile, APulseLastsAWholeNumberOfStepsWhateverTheRoundingOfTime) {
  ForceProfile pulse;
  pulse.amplitude_N = 80.0;
  for (const double start : {0.0, 0.3, 2.8, 17.001, 40.7}) {
    pulse.start_s = start;
    pulse.duration_s = 0.2;
    int on = 0;
    for (int k = 0; k < 50000; ++k) on += pulse.value(k * 1e-3) != 0.0 ? 1 : 0;
    EXPECT_EQ(on, 200) << "start " << start;
  }
}

TEST(ForceProfile, ASineStartsAtItsPhaseAndRepeatsAfterItsPeriod) {
  ForceProfile sine;
  sine.kind = ForceProfile::Kind::kSine;
  sine.amplitude_N = 20.0;
  sine.period_s = 2.0 * std::numbers::pi;
  EXPECT_NEAR(sine.value(1.3), 20.0 * std::sin(1.3), 1e-12);
  EXPECT_NEAR(sine.value(1.3 + 4.0 * std::numbers::pi), 20.0 * std::sin(1.3), 1e-12);
  sine.start_s = 5.0;
  sine.phase_rad = 0.5;
  sine.duration_s = 1.0;
  EXPECT_EQ(sine.value(4.99), 0.0);
  EXPECT_NEAR(sine.value(5.0), 20.0 * std::sin(0.5), 1e-12);
  EXPECT_EQ(sine.value(6.0), 0.0);
}

TEST(ForceProfile, ARampRisesLinearlyAndStaysAtItsAmplitude) {
  ForceProfile ramp;
  ramp.kind = ForceProfile::Kind::kRamp;
  ramp.amplitude_N = -30.0;
  ramp.start_s = 2.0;
  ramp.ramp_s = 3.0;
  ramp.duration_s = 6.0;
  EXPECT_EQ(ramp.value(1.999), 0.0);
  EXPECT_NEAR(ramp.value(2.0), 0.0, 1e-12);
  EXPECT_NEAR(ramp.value(3.0), -10.0, 1e-12);
  EXPECT_NEAR(ramp.value(4.5), -25.0, 1e-12);
  EXPECT_EQ(ramp.value(5.0), -30.0);
  EXPECT_EQ(ramp.value(7.9), -30.0);
  EXPECT_EQ(ramp.value(8.0), 0.0);
}

// From 1 to 5 Hz in 4 s the frequency is 1 + t Hz: t + t^2 / 2 cycles have passed.
TEST(ForceProfile, AChirpsFrequencyGoesLinearlyFromOneToTheOther) {
  ForceProfile chirp;
  chirp.kind = ForceProfile::Kind::kChirp;
  chirp.amplitude_N = 20.0;
  chirp.f0_Hz = 1.0;
  chirp.f1_Hz = 5.0;
  chirp.start_s = 10.0;
  chirp.duration_s = 4.0;
  chirp.phase_rad = 0.5;
  for (const double t : {0.0, 0.1, 0.77, 1.5, 2.9, 3.999}) {
    const double cycles = t + 0.5 * t * t;
    EXPECT_NEAR(chirp.value(10.0 + t), 20.0 * std::sin(2.0 * std::numbers::pi * cycles + 0.5), 1e-9) << t;
  }
  EXPECT_EQ(chirp.value(9.999), 0.0);
  EXPECT_EQ(chirp.value(14.0), 0.0);
  chirp.phase_rad = 0.0;
  int crossings = 0;  // upward, one per cycle: 4 + 8 of them, the first at the start
  for (int k = 1; k < 4000; ++k)
    crossings += chirp.value(10.0 + (k - 1) * 1e-3) <= 0.0 && chirp.value(10.0 + k * 1e-3) > 0.0 ? 1 : 0;
  EXPECT_EQ(crossings, 12);
}

TEST(Disturbance, PointsAlongTheWorldOrTurnsWithTheTrunk) {
  Disturbance push;
  push.profile.amplitude_N = 10.0;
  push.leg = static_cast<int>(Leg::kRH);
  push.link = LegLink::kUpper;
  push.p_L = {0.0, 0.1, -0.2};
  RobotState state;
  state.R_WB << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;  // quarter turn to the left
  const AppliedForce world = push.at(0.0, state);
  EXPECT_EQ(world.leg, 3);
  EXPECT_EQ(world.link, LegLink::kUpper);
  EXPECT_EQ(world.p_L, push.p_L);
  EXPECT_EQ(world.force_W, Vec3(10.0, 0.0, 0.0));
  push.frame = Disturbance::Frame::kBase;
  EXPECT_EQ(push.at(0.0, state).force_W, Vec3(0.0, 10.0, 0.0));
}

TEST(Disturbance, IsAFunctionOfTimeAlone) {
  Disturbance push;
  push.profile.kind = ForceProfile::Kind::kSine;
  push.profile.amplitude_N = 10.0;
  const Vec3 first = push.at(0.3, {}).force_W;
  push.at(0.9, {});
  EXPECT_EQ(push.at(0.3, {}).force_W, first);
}

TEST(Disturbance, SaysWhatIsWrong) {
  const auto with = [](const std::function<void(Disturbance&)>& change) {
    return [change] {
      Disturbance push;
      change(push);
      push.validate();
    };
  };
  const auto message = [](const char* text) { return ThrowsMessage<std::invalid_argument>(HasSubstr(text)); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(with([](Disturbance&) {})());
  EXPECT_THAT(with([](Disturbance& d) { d.direction *= 2.0; }), message("norm of direction = 2, must be 1"));
  EXPECT_THAT(with([](Disturbance& d) { d.leg = 4; }), message("leg = 4"));
  EXPECT_THAT(with([](Disturbance& d) { d.profile.duration_s = 0.0; }), message("duration_s = 0, must be > 0"));
  EXPECT_THAT(with([nan](Disturbance& d) { d.profile.amplitude_N = nan; }), message("amplitude_N = nan"));
  EXPECT_THAT(with([nan](Disturbance& d) { d.p_L.y() = nan; }), message("p_L = nan"));
  EXPECT_THAT(with([](Disturbance& d) {
                d.profile.kind = ForceProfile::Kind::kSine;
                d.profile.period_s = 0.0;
              }),
              message("period_s = 0"));
  EXPECT_THAT(with([](Disturbance& d) {
                d.profile.kind = ForceProfile::Kind::kRamp;
                d.profile.ramp_s = 2.0;
                d.profile.duration_s = 1.0;
              }),
              message("ramp_s = 2, must be finite, > 0 and <= duration_s"));
  EXPECT_THAT(with([](Disturbance& d) { d.profile.kind = ForceProfile::Kind::kChirp; }), message("duration_s = inf"));
  EXPECT_THAT(with([](Disturbance& d) {
                d.profile.kind = ForceProfile::Kind::kChirp;
                d.profile.duration_s = 1.0;
                d.profile.f1_Hz = -1.0;
              }),
              message("f1_Hz = -1"));
  EXPECT_THAT(with([](Disturbance& d) {
                d.trigger = SwingTrigger{Leg::kRF, 1.0};
              }),
              message("phase of the trigger = 1"));
}

}  // namespace
}  // namespace dob::disturbance_test
