#include "sim/disturbance_schedule.h"

#include <vector>

#include <gtest/gtest.h>

namespace dob::disturbance_schedule_test {
namespace {

constexpr double kDt = 1e-3;
constexpr std::array kStand{-1.0, -1.0, -1.0, -1.0};

Disturbance pulse(double start, double duration) {
  Disturbance d;
  d.profile.amplitude_N = 80.0;
  d.profile.start_s = start;
  d.profile.duration_s = duration;
  return d;
}

Disturbance triggered(double phase, double not_before, double duration = 0.2) {
  Disturbance d = pulse(not_before, duration);
  d.trigger = SwingTrigger{Leg::kRF, phase};
  return d;
}

// A leg that stands for 0.15 s and swings for `swing` s of its planned 0.1 s, over and over from t = 0.
double swinging(long tick, long swing = 100) {
  const long in_cycle = tick % (150 + swing);
  return in_cycle < 150 ? -1.0 : static_cast<double>(in_cycle - 150) * kDt / 0.1;
}

// The ticks at which a disturbance acts while RF swings.
std::vector<long> acting(const Disturbance& d, long ticks, long swing = 100) {
  DisturbanceSchedule schedule({d});
  std::vector<long> on;
  for (long k = 0; k < ticks; ++k) {
    PerLeg<double> phase = kStand;
    phase[1] = swinging(k, swing);
    schedule.update(static_cast<double>(k) * kDt, phase, {});
    if (schedule.active()) on.push_back(k);
  }
  return on;
}

TEST(DisturbanceSchedule, APulseActsFromItsStartForItsDuration) {
  const std::vector<long> on = acting(pulse(0.3, 0.2), 1000);
  ASSERT_EQ(on.size(), 200u);
  EXPECT_EQ(on.front(), 300);
  EXPECT_EQ(on.back(), 499);
}

TEST(DisturbanceSchedule, BeginsAtTheTicksAtWhichAForceSetsInNotWhereOneEnds) {
  DisturbanceSchedule schedule({pulse(0.0, 0.01), pulse(0.01, 0.01), pulse(0.03, 0.01)});
  std::vector<long> begins;
  for (long k = 0; k < 50; ++k) {
    schedule.update(static_cast<double>(k) * kDt, kStand, {});
    if (schedule.began()) begins.push_back(k);
    EXPECT_EQ(schedule.active(), k < 20 || (k >= 30 && k < 40));
    EXPECT_EQ(schedule.forces().size(), schedule.active() ? 1u : 0u);
  }
  EXPECT_EQ(begins, (std::vector<long>{0, 10, 30}));
}

// Swings of RF begin at 150, 400, 650 ... ms; phase 0.3 is 30 ms later.
TEST(DisturbanceSchedule, ATriggerFiresWhenASwingPassesItsPhase) {
  const std::vector<long> on = acting(triggered(0.3, 0.0), 2000);
  ASSERT_EQ(on.size(), 200u);
  EXPECT_EQ(on.front(), 180);
  EXPECT_EQ(acting(triggered(0.0, 0.0), 2000).front(), 150);    // lift-off itself
  EXPECT_EQ(acting(triggered(0.305, 0.0), 2000).front(), 181);  // the first tick past it
}

TEST(DisturbanceSchedule, ASwingThatWasPastThePhaseAtTheEarliestTimeDoesNotCount) {
  EXPECT_EQ(acting(triggered(0.3, 0.180), 2000).front(), 180);
  EXPECT_EQ(acting(triggered(0.3, 0.181), 2000).front(), 430);
  EXPECT_EQ(acting(triggered(0.3, 1.0), 2000).front(), 1180);
}

TEST(DisturbanceSchedule, SwingsThatLandBeforeThePhaseAreSkippedAndATriggerMayNeverFire) {
  EXPECT_TRUE(acting(triggered(0.8, 0.0), 5000, 70).empty());
  DisturbanceSchedule schedule({pulse(0.0, 1.0), triggered(0.5, 0.0)});
  ASSERT_NE(schedule.waiting(), nullptr);
  EXPECT_EQ(schedule.waiting()->trigger->phase, 0.5);
  PerLeg<double> other = kStand;
  other[0] = 0.9;  // LF is not the leg
  schedule.update(0.0, other, {});
  EXPECT_NE(schedule.waiting(), nullptr);
  other[1] = 0.6;
  schedule.update(kDt, other, {});
  EXPECT_EQ(schedule.waiting(), nullptr);
  EXPECT_EQ(schedule.forces().size(), 2u);
}

TEST(DisturbanceSchedule, AProfileCountsFromTheMomentItsTriggerFires) {
  Disturbance ramp = triggered(0.3, 0.0, 1.0);
  ramp.profile.kind = ForceProfile::Kind::kRamp;
  ramp.profile.ramp_s = 0.1;
  DisturbanceSchedule schedule({ramp});
  for (long k = 0; k <= 230; ++k) {
    PerLeg<double> phase = kStand;
    phase[1] = swinging(k);
    schedule.update(static_cast<double>(k) * kDt, phase, {});
  }
  ASSERT_EQ(schedule.forces().size(), 1u);
  EXPECT_NEAR(schedule.forces()[0].force_W.x(), 40.0, 1e-9);  // half of the ramp after 50 ms
}

}  // namespace
}  // namespace dob::disturbance_schedule_test
