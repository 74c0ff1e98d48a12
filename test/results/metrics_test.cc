#include "results/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/quiet_tick.h"

namespace dob::metrics_test {
namespace {

using test::quiet;
using ::testing::Optional;

constexpr double kDt = 0.001;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

auto about(double x) {
  return Optional(::testing::DoubleNear(x, 1e-12));
}

CellMetrics metrics_of(const std::vector<TickRecord>& ticks, std::optional<Leg> leg = {}, double dt = kDt) {
  MetricsAccumulator metrics(leg, dt, static_cast<double>(ticks.size()) * dt);
  for (const TickRecord& tick : ticks) metrics.add(tick);
  return metrics.finish();
}

// One swing of one leg: errors [m] along y from lift-off on; the tick after it is the touchdown.
std::vector<TickRecord> swing(int leg, const std::vector<double>& errors) {
  std::vector<TickRecord> ticks;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    ticks.push_back(quiet());
    ticks.back().stance[leg] = false;
    ticks.back().lift_off[leg] = i == 0;
    ticks.back().foot[leg].y() += errors[i];
  }
  ticks.push_back(quiet());
  ticks.back().touchdown[leg] = true;
  return ticks;
}

std::vector<TickRecord> joined(std::vector<TickRecord> a, const std::vector<TickRecord>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(MetricsTest, ComErrorIsTheDistanceToTheReference) {
  std::vector<TickRecord> ticks(3, quiet());
  ticks[0].com += Vec3(0.001, 0.002, 0.002);  // 3 mm
  ticks[1].com += Vec3(0.0, 0.0, 0.006);
  const CellMetrics m = metrics_of(ticks);
  EXPECT_THAT(m.com_error_max_m, about(0.006));
  EXPECT_THAT(m.com_error_rms_m, about(std::sqrt((9.0 + 36.0 + 0.0) / 3.0) * 1e-3));
  EXPECT_THAT(m.com_error_p99_m, about(0.003 + 0.98 * 0.003));  // h = 2 * 0.99
}

TEST(MetricsTest, PathErrorIsHorizontalAndAgainstTheCommandedPath) {
  TickRecord r = quiet();
  r.path_position += Vec2(0.03, -0.04);
  r.com.z() += 1.0;
  r.com_reference.z() += 1.0;
  const CellMetrics shifted_path = metrics_of({quiet(), r, quiet()});
  EXPECT_THAT(shifted_path.path_error_max_m, about(0.05));
  EXPECT_THAT(shifted_path.com_error_max_m, about(0.0));

  TickRecord replanned = quiet();  // the reference follows something else: of no account
  replanned.com_reference.x() += 0.5;
  EXPECT_THAT(metrics_of({replanned}).path_error_max_m, about(0.0));
}

TEST(MetricsTest, FootErrorInSwingIsThatOfTheWorstLegUnlessOneIsNamed) {
  const auto ticks = joined(swing(0, {0.001, 0.004, 0.002}), swing(3, {0.003, 0.009}));
  EXPECT_THAT(metrics_of(ticks).foot_error_max_m, about(0.009));
  EXPECT_THAT(metrics_of(ticks, Leg::kLF).foot_error_max_m, about(0.004));
  EXPECT_THAT(metrics_of(ticks, Leg::kRH).foot_error_max_m, about(0.009));
  EXPECT_EQ(metrics_of(ticks, Leg::kRF).foot_error_max_m, std::nullopt);  // never swings
}

TEST(MetricsTest, FootErrorP99IsTheWorstLegsOwnAndOverItsSwingTicksOnly) {
  // Sorted errors of RH: 3, 9 mm, h = 0.99; of LF: 1, 2, 4, h = 1.98. Pooled it would be another figure.
  const auto ticks = joined(swing(0, {0.001, 0.004, 0.002}), swing(3, {0.003, 0.009}));
  EXPECT_THAT(metrics_of(ticks).foot_error_p99_m, about(0.003 + 0.99 * 0.006));
  EXPECT_THAT(metrics_of(ticks, Leg::kLF).foot_error_p99_m, about(0.002 + 0.98 * 0.002));
}

TEST(MetricsTest, SwingThatMeetsAnOnsetIsKeptApartAsAWhole) {
  std::vector<double> errors(40, 0.001);
  errors[2] = 0.050;  // before the onset, same swing
  errors[30] = 0.020;
  auto ticks = joined(swing(1, errors), swing(1, {0.002, 0.003}));
  ticks[19].disturbance_onset = true;  // 19 ms after lift-off
  const CellMetrics m = metrics_of(ticks);
  EXPECT_THAT(m.foot_error_onset_max_m, about(0.050));
  EXPECT_THAT(m.foot_error_max_m, about(0.003));
  EXPECT_THAT(m.foot_error_p99_m, about(0.002 + 0.99 * 0.001));
}

TEST(MetricsTest, OnsetTwentyMillisecondsAfterLiftOffIsTooLate) {
  auto ticks = swing(1, std::vector<double>(40, 0.004));
  ticks[20].disturbance_onset = true;
  const CellMetrics m = metrics_of(ticks);
  EXPECT_EQ(m.foot_error_onset_max_m, std::nullopt);
  EXPECT_THAT(m.foot_error_max_m, about(0.004));
}

TEST(MetricsTest, OnsetWindowIsATimeWhateverTheTick) {
  for (const double dt : {0.0005, 0.001, 0.0025}) {
    const auto last = static_cast<std::size_t>(std::lround(0.020 / dt)) - 1;
    for (const bool inside : {true, false}) {
      auto ticks = swing(1, std::vector<double>(60, 0.004));
      ticks[inside ? last : last + 1].disturbance_onset = true;
      EXPECT_EQ(metrics_of(ticks, {}, dt).foot_error_onset_max_m.has_value(), inside) << dt;
    }
  }
}

TEST(MetricsTest, OnsetInStanceOrBeforeLiftOffLeavesTheSwingAlone) {
  TickRecord onset = quiet();
  onset.disturbance_onset = true;
  const CellMetrics m = metrics_of(joined({onset}, swing(2, {0.005, 0.006})));
  EXPECT_EQ(m.foot_error_onset_max_m, std::nullopt);
  EXPECT_THAT(m.foot_error_max_m, about(0.006));
}

TEST(MetricsTest, OnsetConcernsOnlyTheLegsThatHaveJustLiftedOff) {
  auto ticks = swing(0, std::vector<double>(60, 0.007));
  for (std::size_t i = 40; i < 50; ++i) {
    ticks[i].stance[3] = false;
    ticks[i].lift_off[3] = i == 40;
    ticks[i].foot[3].x() += 0.002;
  }
  ticks[45].disturbance_onset = true;  // LF is 45 ms into its swing, RH 5 ms
  const CellMetrics m = metrics_of(ticks);
  EXPECT_THAT(m.foot_error_max_m, about(0.007));
  EXPECT_THAT(m.foot_error_onset_max_m, about(0.002));
}

TEST(MetricsTest, SwingThatTheTrialEndsInCounts) {
  auto ticks = swing(1, {0.001, 0.008});
  ticks.pop_back();
  EXPECT_THAT(metrics_of(ticks).foot_error_max_m, about(0.008));
  ticks[1].disturbance_onset = true;
  EXPECT_THAT(metrics_of(ticks).foot_error_onset_max_m, about(0.008));
  EXPECT_EQ(metrics_of(ticks).foot_error_max_m, std::nullopt);
}

TEST(MetricsTest, SwingThatFollowsAnotherWithoutStanceIsANewOne) {
  std::vector<TickRecord> ticks(30, quiet());
  for (TickRecord& tick : ticks) {
    tick.stance[0] = false;
    tick.foot[0].x() += 0.003;
  }
  ticks[0].lift_off[0] = ticks[25].lift_off[0] = true;
  ticks[27].disturbance_onset = true;
  const CellMetrics m = metrics_of(ticks);
  EXPECT_THAT(m.foot_error_max_m, about(0.003));
  EXPECT_THAT(m.foot_error_onset_max_m, about(0.003));
}

TEST(MetricsTest, StanceErrorIsApartFromSwing) {
  std::vector<TickRecord> ticks = swing(1, {0.040});
  ticks[0].foot[2].z() -= 0.002;
  ticks[1].foot[1] += Vec3(0.003, 0.004, 0.0);
  EXPECT_THAT(metrics_of(ticks).foot_error_stance_max_m, about(0.005));
  EXPECT_THAT(metrics_of(ticks, Leg::kLH).foot_error_stance_max_m, about(0.002));
  EXPECT_THAT(metrics_of(ticks).foot_error_max_m, about(0.040));
}

TEST(MetricsTest, FootholdErrorIsTakenAtTouchdownOnly) {
  auto ticks = joined(swing(1, {0.001}), swing(2, {0.001}));
  ticks[0].foothold[1].x() += 1.0;  // in swing: of no account
  ticks[1].foothold[1] += Vec3(0.006, 0.0, 0.008);
  ticks[3].foothold[2] += Vec3(0.0, 0.015, 0.0);
  EXPECT_THAT(metrics_of(ticks).foothold_error_max_m, about(0.015));
  EXPECT_THAT(metrics_of(ticks, Leg::kRF).foothold_error_max_m, about(0.010));
  EXPECT_EQ(metrics_of(ticks, Leg::kLF).foothold_error_max_m, std::nullopt);
}

TEST(MetricsTest, GrfErrorIsTheMeanOverStandingLegsAndTicks) {
  std::vector<TickRecord> ticks(2, quiet());
  ticks[0].foot_force_commanded.segment<3>(3) << 0.0, 3.0, 50.0;
  ticks[0].foot_force.segment<3>(3) << 0.0, 0.0, 46.0;  // RF: 5 N
  ticks[1].stance[1] = false;
  ticks[1].foot_force.segment<3>(3) << 0.0, 0.0, 99.0;  // swings: of no account
  ticks[1].foot_force.segment<3>(9) << 0.0, 0.0, -9.0;  // RH: 9 N
  EXPECT_THAT(metrics_of(ticks).grf_error_mean_N, about((5.0 + 9.0) / 7.0));
  EXPECT_THAT(metrics_of(ticks, Leg::kRF).grf_error_mean_N, about(5.0));
  EXPECT_THAT(metrics_of(ticks, Leg::kRH).grf_error_mean_N, about(4.5));
}

TEST(MetricsTest, EstimateRmseIsOverTheTicksThatHaveOne) {
  std::vector<TickRecord> ticks(4, quiet());
  for (int i : {1, 2}) ticks[static_cast<std::size_t>(i)].has_force_estimate = true;
  ticks[1].force_true = Vec3(20.0, 0.0, 0.0);
  ticks[1].force_estimate = Vec3(17.0, 4.0, 0.0);
  ticks[2].force_estimate = Vec3(0.0, 0.0, 1.0);
  ticks[3].force_estimate = Vec3(500.0, 0.0, 0.0);  // does not apply
  EXPECT_THAT(metrics_of(ticks).estimate_rmse_N, about(std::sqrt((25.0 + 1.0) / 2.0)));
}

TEST(MetricsTest, JointEstimateRmseIsTheNormOverAllJoints) {
  std::vector<TickRecord> ticks(3, quiet());
  ticks[0].has_leg_estimate = ticks[1].has_leg_estimate = true;
  ticks[0].leg_torque_estimate.setConstant(1.0);  // squared norm 12
  ticks[1].leg_torque_true[7] = 2.0;              // squared norm 4
  ticks[2].leg_torque_estimate.setConstant(100.0);
  EXPECT_THAT(metrics_of(ticks).joint_estimate_rmse_Nm, about(std::sqrt(8.0)));
}

TEST(MetricsTest, EstimateMetricsAreNullWithoutAnEstimate) {
  const CellMetrics m = metrics_of({quiet()});
  EXPECT_EQ(m.estimate_rmse_N, std::nullopt);
  EXPECT_EQ(m.joint_estimate_rmse_Nm, std::nullopt);
}

TEST(MetricsTest, OrientationSaturationAndQpAreCounted) {
  std::vector<TickRecord> ticks(4, quiet());
  ticks[1].orientation_error = 0.07;
  ticks[2].orientation_error = 0.03;
  ticks[0].saturated_joints = 5;
  ticks[3].saturated_joints = 1;
  ticks[0].qp_solved = ticks[1].qp_solved = ticks[2].qp_solved = true;
  ticks[1].qp_status = QpStatus::kInfeasible;
  ticks[3].qp_status = QpStatus::kSingular;  // held from before: no solve
  const CellMetrics m = metrics_of(ticks);
  EXPECT_THAT(m.orientation_error_max_rad, about(0.07));
  EXPECT_THAT(m.torque_saturation_ratio, about(6.0 / 48.0));
  EXPECT_EQ(m.qp_solves, 3);
  EXPECT_EQ(m.qp_failures, 1);
}

TEST(MetricsTest, EveryStatusButOptimalIsAQpFailure) {
  for (const QpStatus status : {QpStatus::kInfeasible, QpStatus::kSingular, QpStatus::kIterationLimit,
                                QpStatus::kInaccurate, QpStatus::kInvalidInput}) {
    TickRecord r = quiet();
    r.qp_solved = true;
    r.qp_status = status;
    EXPECT_EQ(metrics_of({r, quiet()}).qp_failures, 1) << to_string(status);
  }
}

TEST(MetricsTest, SlipAccumulatesWithinOneStanceAsADisplacement) {
  std::vector<TickRecord> ticks(8, quiet());
  ticks[0].slip[2] = ticks[1].slip[2] = Vec3(0.002, 0.0, 0.0);
  ticks[2].slip[2] = Vec3(-0.003, 0.0, 0.0);  // slides back: 1 mm in the end, 4 mm at most
  ticks[3].stance[2] = false;
  ticks[3].slip[2] = Vec3(0.5, 0.0, 0.0);  // scuffs in swing: of no account
  ticks[4].touchdown[2] = true;
  ticks[4].slip[2] = ticks[5].slip[2] = Vec3(0.0015, 0.0, 0.0);
  EXPECT_THAT(metrics_of(ticks).slip_max_m, about(0.004));
  EXPECT_THAT(metrics_of(ticks, Leg::kLF).slip_max_m, about(0.004));  // any foot, named or not
}

TEST(MetricsTest, TouchdownBeginsANewStanceForTheSlip) {
  std::vector<TickRecord> ticks(4, quiet());
  ticks[0].slip[0] = ticks[1].slip[0] = ticks[2].slip[0] = ticks[3].slip[0] = Vec3(0.0, 0.001, 0.0);
  ticks[2].touchdown[0] = true;
  EXPECT_THAT(metrics_of(ticks).slip_max_m, about(0.002));
}

TEST(MetricsTest, NothingAppliesWithoutATick) {
  const CellMetrics m = metrics_of({});
  EXPECT_EQ(m.com_error_max_m, std::nullopt);
  EXPECT_EQ(m.com_error_rms_m, std::nullopt);
  EXPECT_EQ(m.torque_saturation_ratio, std::nullopt);
  EXPECT_EQ(m.slip_max_m, std::nullopt);
}

TEST(MetricsTest, ValueThatIsNotFiniteNullsItsMetricAndNoOther) {
  std::vector<TickRecord> ticks = swing(1, {0.002, 0.003, 0.004});
  for (TickRecord& tick : ticks) tick.has_leg_estimate = true;
  ticks[1].leg_torque_estimate[3] = kNaN;
  ticks[1].foot[1].x() = std::numeric_limits<double>::infinity();
  ticks[0].com_reference.x() = kNaN;
  ticks[0].path_position.x() = kNaN;
  const CellMetrics m = metrics_of(ticks);
  EXPECT_EQ(m.joint_estimate_rmse_Nm, std::nullopt);
  EXPECT_EQ(m.foot_error_max_m, std::nullopt);
  EXPECT_EQ(m.foot_error_p99_m, std::nullopt);
  EXPECT_EQ(m.com_error_max_m, std::nullopt);
  EXPECT_EQ(m.com_error_rms_m, std::nullopt);
  EXPECT_EQ(m.com_error_p99_m, std::nullopt);
  EXPECT_EQ(m.path_error_max_m, std::nullopt);
  EXPECT_THAT(m.foot_error_stance_max_m, about(0.0));
}

TEST(MetricsTest, TheMetricThatIsNotFiniteIsNamed) {
  const auto not_finite = [](const TickRecord& tick) {
    MetricsAccumulator metrics({}, kDt, kDt);
    metrics.add(tick);
    return std::string(metrics.not_finite());
  };
  TickRecord tick = quiet();
  EXPECT_EQ(not_finite(tick), "");
  tick.has_leg_estimate = true;
  tick.leg_torque_estimate[3] = 1e200;  // finite, but not its square
  EXPECT_EQ(not_finite(tick), "joint_estimate_rmse_Nm");
  tick.com_reference.x() = kNaN;
  EXPECT_EQ(not_finite(tick), "com_error_max_m");
}

TEST(MetricsTest, RefusesATickOrDurationThatIsNone) {
  EXPECT_THROW(MetricsAccumulator({}, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(MetricsAccumulator({}, kNaN, 1.0), std::invalid_argument);
  EXPECT_THROW(MetricsAccumulator({}, kDt, -1.0), std::invalid_argument);
  EXPECT_THROW(MetricsAccumulator({}, kDt, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

// Ticks of everything a checkpoint holds, with an onset swing that the checkpoint at 0.5 s falls into.
std::vector<TickRecord> eventful_ticks(int count) {
  std::vector<TickRecord> ticks;
  for (int k = 0; k < count; ++k) {
    TickRecord r = quiet();
    const bool in_swing = k % 250 >= 240 || k % 250 < 60;
    r.stance[1] = !in_swing;
    r.lift_off[1] = k % 250 == 240;
    r.foot[1].y() += 1e-5 * ((k * 37) % 251);
    r.com.x() += 1e-6 * ((k * 91) % 1009);
    r.path_position.y() += 1e-6 * k;
    r.foot_force[5] = 0.1 * (k % 7);
    r.disturbance_onset = k == 505;  // 15 ms after the lift-off at 490 ms, after the checkpoint
    ticks.push_back(r);
  }
  return ticks;
}

TEST(MetricsTest, ACheckpointIsWhatTheMetricsWouldBeHadTheTrialEndedThere) {
  const auto ticks = eventful_ticks(1700);
  MetricsAccumulator metrics({}, kDt, 1.0);  // longer than announced
  for (const TickRecord& tick : ticks) metrics.add(tick);
  const std::vector<MetricsCheckpoint> checkpoints = metrics.checkpoints();
  ASSERT_EQ(checkpoints.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t count = std::min<std::size_t>(500 * (i + 1), 1700);
    EXPECT_DOUBLE_EQ(checkpoints[i].t, 1e-3 * static_cast<double>(count));
    const CellMetrics prefix = metrics_of({ticks.begin(), ticks.begin() + static_cast<std::ptrdiff_t>(count)});
    EXPECT_EQ(checkpoints[i].com_error_max_m, prefix.com_error_max_m);
    EXPECT_EQ(checkpoints[i].com_error_rms_m, prefix.com_error_rms_m);
    EXPECT_EQ(checkpoints[i].path_error_max_m, prefix.path_error_max_m);
    EXPECT_EQ(checkpoints[i].foot_error_max_m, prefix.foot_error_max_m);
    EXPECT_EQ(checkpoints[i].grf_error_mean_N, prefix.grf_error_mean_N);
    EXPECT_TRUE(checkpoints[i].foot_error_max_m && checkpoints[i].grf_error_mean_N);
  }
}

TEST(MetricsTest, ACheckpointInsideASwingHoldsItsErrorSoFarUntilAnOnsetSetsTheSwingApart) {
  std::vector<TickRecord> ticks(490, quiet());
  ticks = joined(ticks, swing(0, std::vector<double>(100, 0.030)));
  auto with_onset = ticks;
  with_onset[505].disturbance_onset = true;
  MetricsAccumulator metrics({}, kDt, 1.0);
  for (const TickRecord& tick : with_onset) metrics.add(tick);
  const auto checkpoints = metrics.checkpoints();
  ASSERT_EQ(checkpoints.size(), 2U);
  EXPECT_THAT(checkpoints[0].foot_error_max_m, about(0.030));
  EXPECT_EQ(checkpoints[1].foot_error_max_m, std::nullopt);
}

TEST(MetricsTest, TheEndOfATrialIsACheckpointOnce) {
  EXPECT_EQ(MetricsAccumulator({}, kDt, 1.0).checkpoints().size(), 0U);
  MetricsAccumulator metrics({}, 0.1, 1.0);
  for (int k = 0; k < 10; ++k) metrics.add(quiet());
  ASSERT_EQ(metrics.checkpoints().size(), 2U);
  EXPECT_DOUBLE_EQ(metrics.checkpoints().back().t, 1.0);
}

TEST(MetricsTest, ComWrenchErrorsAreApartInForceAndMomentOverTheTicksWithAnEstimate) {
  std::vector<TickRecord> ticks(3, quiet());
  for (int i : {0, 1}) ticks[static_cast<std::size_t>(i)].has_com_estimate = true;
  ticks[0].com_wrench_true << 3.0, 0.0, 0.0, 0.0, 0.0, 2.0;
  ticks[0].com_wrench_estimate << 0.0, 4.0, 0.0, 0.0, 0.0, 1.0;
  ticks[2].com_wrench_estimate.setConstant(99.0);  // none: of no account
  const CellMetrics m = metrics_of(ticks);
  EXPECT_THAT(m.com_force_rmse_N, about(5.0 / std::sqrt(2.0)));
  EXPECT_THAT(m.com_moment_rmse_Nm, about(1.0 / std::sqrt(2.0)));
  EXPECT_EQ(metrics_of({quiet()}).com_force_rmse_N, std::nullopt);
}

}  // namespace
}  // namespace dob::metrics_test
