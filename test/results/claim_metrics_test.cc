#include "results/claim_metrics.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/metrics.h"
#include "test/results/quiet_tick.h"

namespace dob::claim_metrics_test {
namespace {

using test::quiet;
using ::testing::DoubleNear;
using ::testing::Optional;

TickRecord estimate_error(double first, double last) {
  TickRecord r = quiet();
  r.has_leg_estimate = true;
  r.leg_torque_true.setConstant(1.0);
  r.leg_torque_estimate = r.leg_torque_true;
  r.leg_torque_estimate[0] += first;
  r.leg_torque_estimate[11] += last;
  return r;
}

CellMetrics metrics_of(const std::vector<TickRecord>& ticks, std::optional<Leg> leg = {}) {
  MetricsAccumulator metrics(leg, 0.001, 1.0);
  for (const TickRecord& tick : ticks) metrics.add(tick);
  return metrics.finish();
}

TEST(ClaimMetricsTest, OffsetIsTheNormOfTheMeanErrorNotTheMeanOfItsNorm) {
  const CellMetrics m = metrics_of({estimate_error(3.0, 9.0), estimate_error(3.0, -1.0), quiet()});
  EXPECT_THAT(m.estimate_offset_Nm, Optional(DoubleNear(5.0, 1e-12)));  // (3, 4)
  EXPECT_EQ(metrics_of({quiet()}).estimate_offset_Nm, std::nullopt);
}

TEST(ClaimMetricsTest, ComErrorIsToldApartBySwingAndStanceOfTheMetricLeg) {
  TickRecord swings = quiet(), other = quiet();
  swings.stance[1] = false;
  swings.com.z() += 0.004;
  other.stance[0] = false;
  other.com.z() += 0.003;
  const CellMetrics m = metrics_of({swings, other}, Leg::kRF);
  EXPECT_THAT(m.com_error_swing_max_m, Optional(DoubleNear(0.004, 1e-12)));
  EXPECT_THAT(m.com_error_stance_max_m, Optional(DoubleNear(0.003, 1e-12)));
  EXPECT_EQ(metrics_of({swings, other}).com_error_swing_max_m, std::nullopt);
}

TEST(ClaimMetricsTest, WhatIsNotFiniteIsNoFigure) {
  const CellMetrics m = metrics_of({estimate_error(std::numeric_limits<double>::quiet_NaN(), 0.0), quiet()});
  EXPECT_EQ(m.estimate_offset_Nm, std::nullopt);
}

TEST(ClaimMetricsTest, PulseReachesTheCell) {
  TickRecord acts = quiet();
  acts.disturbance_active = acts.disturbance_onset = true;
  acts.com.x() += 0.02;
  const CellMetrics m = metrics_of({quiet(), acts, quiet()});
  EXPECT_THAT(m.com_peak_push_m, Optional(DoubleNear(0.02, 1e-12)));
  EXPECT_EQ(m.com_peak_recovery_m, std::nullopt);
}

}  // namespace
}  // namespace dob::claim_metrics_test
