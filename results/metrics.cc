#include "results/metrics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "results/metric_fields.h"

namespace dob {
namespace {

constexpr double kCheckpointInterval = 0.5;  // [s]

std::size_t expected_ticks(double dt, double duration) {
  if (!(dt > 0.0) || !std::isfinite(dt)) {
    throw std::invalid_argument("metrics: dt = " + std::to_string(dt) + " s, allowed: > 0");
  }
  if (!(duration >= 0.0) || !std::isfinite(duration)) {
    throw std::invalid_argument("metrics: duration = " + std::to_string(duration) + " s, allowed: >= 0");
  }
  return static_cast<std::size_t>(std::ceil(duration / dt)) + 1;
}

FootErrorSummary worst_of(const std::vector<FootErrors>& feet) {
  FootErrorSummary worst;
  for (const FootErrors& foot : feet) {
    const FootErrorSummary one = foot.finish();
    worst.swing_max = larger(worst.swing_max, one.swing_max);
    worst.swing_p99 = larger(worst.swing_p99, one.swing_p99);
    worst.onset_max = larger(worst.onset_max, one.onset_max);
    worst.stance_max = larger(worst.stance_max, one.stance_max);
    worst.foothold_max = larger(worst.foothold_max, one.foothold_max);
  }
  return worst;
}

}  // namespace

MetricsAccumulator::MetricsAccumulator(std::optional<Leg> metric_leg, double dt, double duration)
    : metric_leg_(metric_leg), dt_(dt), claim_metrics_(metric_leg, dt) {
  const std::size_t ticks = expected_ticks(dt, duration);
  ticks_per_checkpoint_ = std::max(1L, std::lround(kCheckpointInterval / dt));
  com_error_.reserve(ticks);
  checkpoints_.reserve(ticks / static_cast<std::size_t>(ticks_per_checkpoint_) + 1);
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!metric_leg || static_cast<int>(*metric_leg) == leg) feet_.emplace_back(leg, dt, ticks);
  }
  slip_.fill(Vec3::Zero());
}

void MetricsAccumulator::add(const TickRecord& tick) noexcept {
  const double com_error = (tick.com - tick.com_reference).norm();
  com_error_.push_back(com_error);
  com_error_max_ = larger(com_error_max_, com_error);
  com_error_square_.add(com_error * com_error);
  path_error_max_ = larger(path_error_max_, (tick.com.head<2>() - tick.path_position).norm());
  orientation_error_max_ = larger(orientation_error_max_, tick.orientation_error);
  saturated_joints_.add(tick.saturated_joints);
  for (FootErrors& foot : feet_) foot.add(tick);
  add_force_errors(tick);
  estimate_errors_.add(estimate_error(tick));
  add_slip(tick);
  claim_metrics_.add(tick);
  if (tick.zmp_planned && tick.zmp_status != QpStatus::kOptimal) ++planner_failures_;
  if (tick.qp_solved) {
    ++qp_solves_;
    if (tick.qp_status != QpStatus::kOptimal) ++qp_failures_;
  }
  ++ticks_;
  if (ticks_ % ticks_per_checkpoint_ == 0) checkpoints_.push_back(checkpoint());
}

void MetricsAccumulator::add_force_errors(const TickRecord& tick) noexcept {
  for (Eigen::Index leg = 0; leg < kLegs; ++leg) {
    if (!tick.stance[static_cast<std::size_t>(leg)]) continue;
    if (metric_leg_ && static_cast<Eigen::Index>(*metric_leg_) != leg) continue;
    grf_error_.add((tick.foot_force_commanded.segment<3>(3 * leg) - tick.foot_force.segment<3>(3 * leg)).norm());
  }
}

void MetricsAccumulator::add_slip(const TickRecord& tick) noexcept {
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (!tick.stance[leg] || tick.touchdown[leg]) slip_[leg].setZero();
    if (!tick.stance[leg]) continue;
    slip_[leg] += tick.slip[leg];
    slip_max_ = larger(slip_max_, slip_[leg].norm());
  }
}

std::optional<double> MetricsAccumulator::foot_error_max() const noexcept {
  std::optional<double> worst;
  for (const FootErrors& foot : feet_) worst = larger(worst, foot.swing_max());
  return worst;
}

MetricsCheckpoint MetricsAccumulator::checkpoint() const noexcept {
  return {.t = static_cast<double>(ticks_) * dt_,
          .com_error_max_m = finite(com_error_max_),
          .com_error_rms_m = finite(root(com_error_square_.value())),
          .path_error_max_m = finite(path_error_max_),
          .foot_error_max_m = finite(foot_error_max()),
          .grf_error_mean_N = finite(grf_error_.value())};
}

std::vector<MetricsCheckpoint> MetricsAccumulator::checkpoints() const {
  std::vector<MetricsCheckpoint> all = checkpoints_;
  if (ticks_ % ticks_per_checkpoint_ != 0) all.push_back(checkpoint());
  return all;
}

// Also what is not finite.
CellMetrics MetricsAccumulator::as_measured() const {
  const FootErrorSummary foot = worst_of(feet_);
  const EstimateRmse estimate = estimate_errors_.rmse();
  const std::optional<double> saturated = saturated_joints_.value();
  CellMetrics m;
  m.com_error_max_m = com_error_max_;
  m.com_error_rms_m = root(com_error_square_.value());
  m.com_error_p99_m = p99_of(com_error_);
  m.path_error_max_m = path_error_max_;
  m.foot_error_max_m = foot.swing_max;
  m.foot_error_p99_m = foot.swing_p99;
  m.foot_error_onset_max_m = foot.onset_max;
  m.foot_error_stance_max_m = foot.stance_max;
  m.foothold_error_max_m = foot.foothold_max;
  m.grf_error_mean_N = grf_error_.value();
  m.estimate_rmse_N = estimate.force_N;
  m.joint_estimate_rmse_Nm = estimate.joint_Nm;
  m.com_force_rmse_N = estimate.com_force_N;
  m.com_moment_rmse_Nm = estimate.com_moment_Nm;
  m.orientation_error_max_rad = orientation_error_max_;
  m.torque_saturation_ratio = saturated ? std::optional(*saturated / kJoints) : std::nullopt;
  m.slip_max_m = slip_max_;
  m.qp_solves = qp_solves_;
  m.qp_failures = qp_failures_;
  m.planner_failures = planner_failures_;
  return m;
}

CellMetrics MetricsAccumulator::finish() const {
  CellMetrics m = as_measured();
  for (const MetricField& field : kMetricFields) {
    if (field.value != nullptr) m.*field.value = finite(m.*field.value);
  }
  claim_metrics_.write(m);
  return m;
}

std::string_view MetricsAccumulator::not_finite() const {
  const CellMetrics m = as_measured();
  for (const MetricField& field : kMetricFields) {
    if (field.value != nullptr && m.*field.value && !std::isfinite(*(m.*field.value))) return field.name;
  }
  return {};
}

}  // namespace dob
