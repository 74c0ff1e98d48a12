#include "results/pulse_response.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/quiet_tick.h"

namespace dob::pulse_response_test {
namespace {

using test::quiet;
using ::testing::DoubleNear;
using ::testing::Optional;

constexpr double kDt = 0.01;

auto about(double x) {
  return Optional(DoubleNear(x, 1e-12));
}

// A walk in which the CoM's error is as told, tick for tick, and a force acts from tick `begin` to before `end`.
struct Walk {
  PulseResponse pulse{Leg::kLF, kDt};
  int tick = 0, begin = 200, end = 220;

  void step(double com_error, double foot_error = 0.0, bool swing = false) {
    TickRecord r = quiet();
    r.com.x() += com_error;
    r.foot[0].y() += foot_error;
    r.stance[0] = !swing;
    r.disturbance_active = tick >= begin && tick < end;
    r.disturbance_onset = tick == begin || tick == end;
    pulse.add(r);
    ++tick;
  }
  void steps(int count, double com_error) {
    for (int i = 0; i < count; ++i) step(com_error);
  }
};

TEST(PulseResponseTest, TwoPeaksAreApartWhenTheErrorFallsToHalfOfTheLowerOne) {
  for (const double valley : {0.0035, 0.0036}) {
    Walk walk;
    walk.steps(200, 0.002);
    walk.steps(10, 0.004);
    walk.step(0.009);
    walk.steps(29, valley);
    walk.step(0.007);
    walk.steps(200, 0.0034);
    const PulsePeaks peaks = walk.pulse.finish();
    EXPECT_THAT(peaks.com_before, about(0.002));
    EXPECT_THAT(peaks.com_first, about(0.009));
    if (valley <= 0.5 * 0.007) {
      EXPECT_THAT(peaks.com_second, about(0.007));
    } else {
      EXPECT_EQ(peaks.com_second, std::nullopt);
    }
  }
}

TEST(PulseResponseTest, PeaksComeInTheOrderOfTimeWhicheverIsHigher) {
  Walk walk;
  walk.steps(200, 0.0);
  walk.step(0.005);
  walk.steps(30, 0.001);
  walk.step(0.009);
  walk.steps(30, 0.001);
  walk.step(0.003);  // a third, lower one
  walk.steps(100, 0.0);
  EXPECT_THAT(walk.pulse.finish().com_first, about(0.005));
  EXPECT_THAT(walk.pulse.finish().com_second, about(0.009));
}

TEST(PulseResponseTest, AHumpAndADecayAreOnePeak) {
  Walk walk;
  walk.steps(200, 0.0);
  for (int i = 0; i < 100; ++i) walk.step(0.01 * std::sin(M_PI * i / 100.0));
  EXPECT_THAT(walk.pulse.finish().com_first, about(0.01));
  EXPECT_EQ(walk.pulse.finish().com_second, std::nullopt);
}

TEST(PulseResponseTest, WhatWasLongBeforeThePulseAndLongAfterItIsForgotten) {
  Walk walk;
  walk.step(0.1);  // the start of the walk
  walk.steps(199, 0.002);
  walk.steps(20, 0.008);
  walk.steps(130, 0.006);
  walk.steps(100, 0.05);  // more than 1.5 s after the onset
  const PulsePeaks peaks = walk.pulse.finish();
  EXPECT_THAT(peaks.com_before, about(0.002));
  EXPECT_THAT(peaks.com_first, about(0.008));
  EXPECT_EQ(peaks.com_second, std::nullopt);
}

TEST(PulseResponseTest, FootErrorsInSwingAreThoseOfThePushAndTheRest) {
  Walk walk;
  walk.steps(199, 0.0);
  walk.step(0.0, 0.003, true);
  walk.step(0.0, 0.030, true);
  walk.step(0.0, 0.050, false);  // in stance: of no account
  walk.steps(18, 0.0);
  walk.step(0.0, 0.010, true);
  const PulsePeaks peaks = walk.pulse.finish();
  EXPECT_THAT(peaks.foot_push, about(0.030));
  EXPECT_THAT(peaks.foot_rest, about(0.010));
}

TEST(PulseResponseTest, ForcesThatStayChangeOrReturnAreNoPulses) {
  Walk stays;
  stays.end = 1000;
  stays.steps(400, 0.01);
  EXPECT_EQ(stays.pulse.finish().com_first, std::nullopt);

  PulseResponse redrawn({}, kDt), returns({}, kDt);
  for (const bool onset : {true, false, true, false}) {
    TickRecord r = quiet();
    r.disturbance_active = true;
    r.disturbance_onset = onset;
    redrawn.add(r);
  }
  for (const bool active : {false, true, false, true, false}) {
    TickRecord r = quiet();
    r.disturbance_active = active;
    r.disturbance_onset = true;
    returns.add(r);
  }
  redrawn.add(quiet());
  EXPECT_EQ(redrawn.finish().com_first, std::nullopt);
  EXPECT_EQ(returns.finish().com_first, std::nullopt);
}

}  // namespace
}  // namespace dob::pulse_response_test
