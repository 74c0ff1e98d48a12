#include "controller/whole_body_controller.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace dob {
namespace {

void require(bool ok, const char* name, double value, const char* allowed) {
  if (!ok || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("controller: {} = {}; allowed: {}", name, value, allowed));
  }
}

}  // namespace

WholeBodyController::WholeBodyController(const WbcOptions& o, const Routing& routing,
                                         std::unique_ptr<WbcQpSolver> solver)
    : options_(o), routing_(routing), qp_(o) {
  use_solver(std::move(solver));
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
  require(o.acceleration_horizon > 0.0, "acceleration_horizon_s", o.acceleration_horizon, "> 0");
  for (int j = 0; j < kJoints; ++j) {
    const JointLimits& limits = o.joint_limits;
    if (!(limits.lower[j] <= limits.upper[j] && limits.velocity[j] > 0.0)) {
      throw std::invalid_argument(
          fmt::format("controller: limits of joint {}: {} to {} rad, {} rad/s; allowed: lower <= "
                      "upper, velocity > 0",
                      j, limits.lower[j], limits.upper[j], limits.velocity[j]));
    }
  }
}

void WholeBodyController::use_solver(std::unique_ptr<WbcQpSolver> solver) {
  if (solver == nullptr) throw std::invalid_argument("controller: no QP solver");
  solver_ = std::move(solver);
}

void WholeBodyController::reset() noexcept {
  solution_ = WbcSolution{};
  guess_.size = 0;
  torque_.setZero();
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
  if (stance != stance_) guess_.size = 0;
  stance_ = stance;
  if (!solve_now && options_.torque_between_solves == WbcOptions::BetweenSolves::kHeld) {
    tick.torque = torque_;
    return tick;
  }
  const PerLeg<LegPoint> points = task_points(m, stance);
  Compensation compensation;
  if (solve_now || estimate.has_legs) {
    TaskJacobian J;
    if (J.factorize(m, points)) {
      compensation = compensate(m, points, J, stance, estimate, routing_, solve_now);
      if (solve_now) solve(m, reference, compensation, points, J, tick);
    } else {  // of the due solve, or of the compensation between two
      tick.event = QpEvent::kNotSolved;
      tick.qp_status = QpStatus::kSingular;
    }
  }
  // (36), with the compensation of the standing legs where the routing asks for it.
  Vec12 torque = m.M_q.lazyProduct(solution_.qdd);
  if (options_.coriolis == WbcOptions::Coriolis::kExact) torque += m.c_q;
  torque -= joint_torques(m, points, solution_.foot_force) + compensation.torque;
  if (torque.allFinite()) {
    torque_ = torque.cwiseMax(-options_.torque_limit).cwiseMin(options_.torque_limit);
  } else {
    tick.event = QpEvent::kNotSolved;
    tick.qp_status = QpStatus::kInvalidInput;
  }
  tick.torque = torque_;
  return tick;
}

void WholeBodyController::solve(const ModelTerms& m, const MotionReference& reference, const Compensation& compensation,
                                const PerLeg<LegPoint>& points, const TaskJacobian& J, WbcTick& tick) noexcept {
  qp_.assemble(m, stance_, reference, compensation, points, J);
  tick.qp_status = solver_->solve(qp_.problem(), guess_, qp_solution_);
  tick.qp_iterations = qp_solution_.iterations;
  guess_.size = 0;
  if (tick.qp_status == QpStatus::kOptimal) {
    tick.event = QpEvent::kSolved;
    guess_ = qp_solution_.active;
  } else {
    tick.event = tick.qp_status == QpStatus::kInvalidInput ? QpEvent::kNotSolved : solve_with_fewer_rows();
  }
  if (tick.event == QpEvent::kNotSolved) return;
  solution_ = qp_.recover(qp_solution_.x, J);
  have_solution_ = true;
}

QpEvent WholeBodyController::solve_with_fewer_rows() noexcept {
  const auto is_solved = [this](const WbcProblem& problem) {
    return solver_->solve(problem, WbcActiveSet{}, qp_solution_) == QpStatus::kOptimal;
  };
  if (options_.joint_acceleration_limits && is_solved(qp_.without_acceleration_rows())) {
    return QpEvent::kAccelerationRelaxed;
  }
  return is_solved(qp_.with_contact_rows_only()) ? QpEvent::kTorqueRelaxed : QpEvent::kNotSolved;
}

}  // namespace dob
