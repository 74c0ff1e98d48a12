#include "controller/whole_body_controller.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

void require(bool ok, const char* name, double value, const char* allowed) {
  if (!ok || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("controller: {} = {}; allowed: {}", name, value, allowed));
  }
}

}  // namespace

WholeBodyController::WholeBodyController(const WbcOptions& o, const Routing& routing)
    : options_(o), routing_(routing), qp_(o) {
  for (int i = 0; i < 6; ++i) {
    require(o.wrench_kp[i] >= 0.0, "wrench_kp", o.wrench_kp[i], ">= 0");
    require(o.wrench_kd[i] >= 0.0, "wrench_kd", o.wrench_kd[i], ">= 0");
  }
  require(o.swing_kp >= 0.0, "swing_kp", o.swing_kp, ">= 0");
  require(o.swing_kd >= 0.0, "swing_kd", o.swing_kd, ">= 0");
  require(o.wrench_weight > 0.0, "wrench_weight", o.wrench_weight, "> 0");
  require(o.regularization > 0.0, "regularization", o.regularization, "> 0");
  require(o.slack_weight > 0.0, "slack_weight", o.slack_weight, "> 0");
  require(o.friction > 0.0, "friction", o.friction, "> 0");
  require(o.min_normal_force >= 0.0, "min_normal_force_N", o.min_normal_force, ">= 0");
  require(o.torque_limit > 0.0, "torque_limit_Nm", o.torque_limit, "> 0");
  require(o.qp_rate > 0.0, "qp_rate_Hz", o.qp_rate, "> 0");
}

void WholeBodyController::reset() noexcept {
  solution_ = WbcSolution{};
  have_solution_ = false;
}

bool WholeBodyController::due(long k, double dt, const PerLeg<bool>& stance) const noexcept {
  if (!have_solution_ || stance != stance_) return true;
  // The j-th solve belongs to the first tick at or after j / qp_rate.
  constexpr double kTolerance = 1e-9;  // [cycles]
  const double cycles = static_cast<double>(k) * dt * options_.qp_rate;
  const double before = static_cast<double>(k - 1) * dt * options_.qp_rate;
  return std::floor(cycles + kTolerance) > std::floor(before + kTolerance);
}

WbcTick WholeBodyController::update(long k, double dt, const ModelTerms& m, const PerLeg<bool>& stance,
                                    const MotionReference& reference, const DisturbanceEstimate& estimate) noexcept {
  WbcTick tick;
  const bool solve_now = due(k, dt, stance);
  stance_ = stance;
  const PerLeg<LegPoint> points = task_points(m, stance);
  Compensation now;
  if (solve_now || estimate.has_legs) {
    Mat12 J_j_inverse;
    if (inverse_jacobian_joints(m, points, J_j_inverse)) {
      if (solve_now) solve(m, reference, estimate, points, J_j_inverse, tick);
      now = compensate(m, points, J_j_inverse, stance, estimate, routing_, false);
    } else if (solve_now) {
      tick.event = QpEvent::kNotSolved;
      tick.qp_status = QpStatus::kSingular;
    }
  }
  // (36), with the compensation of the standing legs where the routing asks for it.
  tick.torque.noalias() = m.M_q * solution_.qdd;
  tick.torque += m.c_q - joint_torques(m, points, solution_.foot_force) - now.torque;
  tick.torque = tick.torque.cwiseMax(-options_.torque_limit).cwiseMin(options_.torque_limit);
  return tick;
}

void WholeBodyController::solve(const ModelTerms& m, const MotionReference& reference,
                                const DisturbanceEstimate& estimate, const PerLeg<LegPoint>& points,
                                const Mat12& J_j_inverse, WbcTick& tick) noexcept {
  const Compensation c = compensate(m, points, J_j_inverse, stance_, estimate, routing_, true);
  tick.event = QpEvent::kNotSolved;
  if (!qp_.assemble(m, stance_, reference, c, points, J_j_inverse)) {
    tick.qp_status = QpStatus::kInvalidInput;
    return;
  }
  tick.qp_status = solver_.solve(qp_.problem(), qp_solution_);
  tick.qp_iterations = qp_solution_.iterations;
  if (tick.qp_status == QpStatus::kOptimal) {
    tick.event = QpEvent::kSolved;
  } else if (solver_.solve(qp_.without_torque_rows(), qp_solution_) == QpStatus::kOptimal) {
    tick.event = QpEvent::kTorqueRelaxed;
  } else {
    return;
  }
  solution_ = qp_.recover(qp_solution_.x);
  have_solution_ = true;
}

}  // namespace dob
