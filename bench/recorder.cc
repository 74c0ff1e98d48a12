#include "bench/recorder.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "controller/support_polygon.h"

namespace dob {
namespace {

// The point where a force acts, with the Jacobian in CoM coordinates.
struct ForcePoint {
  Vec3 p;                            // [m]
  Mat36 J_com;                       // [-, m]
  Eigen::Matrix<double, 3, 12> J_j;  // [m]
};

ForcePoint force_point(const ModelTerms& m, const AppliedForce& force) noexcept {
  ForcePoint point;
  if (force.leg == AppliedForce::kTrunk) {
    point.p = m.state.p_WB + m.state.R_WB * force.p_L;
    point.J_com = point_jacobian_com(m, point.p);
    point.J_j = -point.J_com * m.A_c;
    return point;
  }
  const LegPoint on_leg = leg_point(m, Leg{force.leg}, force.link, force.p_L);
  point.p = on_leg.p;
  point.J_com = point_jacobian_com(m, point.p);
  point.J_j = -point.J_com * m.A_c;
  point.J_j.middleCols<3>(3 * force.leg) += on_leg.J_q;
  return point;
}

// Least-squares f of J^T f = torque; directions with singular values below 5 % of the largest are cut, since a force on
// a knee is nearly invisible in one direction and noise there would be blown up.
Vec3 force_at_point(const Eigen::Matrix<double, 3, 12>& J, const Vec12& torque) noexcept {
  constexpr double kCut = 0.05;
  Eigen::SelfAdjointEigenSolver<Mat3> eigen;
  eigen.computeDirect(J * J.transpose());
  const Vec3 b = eigen.eigenvectors().transpose() * (J * torque);
  const double smallest = kCut * kCut * eigen.eigenvalues()[2];
  Vec3 y = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (eigen.eigenvalues()[i] > smallest) y[i] = b[i] / eigen.eigenvalues()[i];
  }
  return eigen.eigenvectors() * y;
}

}  // namespace

Recorder::Recorder(const RobotDescription& robot, const Scenario& scenario) : dt_(scenario.sim.dt) {
  for (int j = 0; j < kJoints; ++j) {
    torque_limit_[j] = std::min(robot.legs[j / 3].joints[j % 3].effort_limit, scenario.controller.torque_limit);
  }
}

const TickRecord& Recorder::record(double t, const ModelTerms& m, const LocomotionController& controller,
                                   const WbcTick& command, const StepResult& step, const Estimate& estimate,
                                   const DisturbanceSchedule& disturbances) noexcept {
  TickRecord& r = record_;
  const MotionReference& reference = controller.reference();
  const GaitState& gait = controller.gait();
  r.t = t;
  r.com = m.p_com;
  r.com_reference = reference.com.p;
  r.trunk = m.state.p_WB;
  r.trunk_rotation = Eigen::Quaterniond(m.state.R_WB);
  r.joint_angle = m.state.q;
  r.path_position = reference.path;
  r.orientation_error = Eigen::AngleAxisd(Mat3(reference.R_WB * m.state.R_WB.transpose())).angle();
  r.stance = controller.stance();
  r.lift_off = gait.lift_off;
  r.touchdown = gait.touchdown;
  for (int l = 0; l < kLegs; ++l) {
    r.foot[l] = m.foot[l].p;
    r.foothold[l] = reference.foothold[l];
    r.foothold_clamped[l] = reference.clamped[l];
    r.foot_reference[l] = r.stance[l] ? reference.foothold[l] : reference.foot[l].p;
    r.foot_force.segment<3>(3 * l) = step.foot_force_W[l];
    r.slip[l] = step.foot_slip_W[l] * dt_;
  }
  record_balance(m, controller);
  r.foot_force_commanded = controller.solution().foot_force;
  r.joint_torque = step.joint_torque;
  r.saturated_joints = static_cast<int>((step.joint_torque.array().abs() >= torque_limit_.array()).count());
  r.disturbance_onset = disturbances.began();
  r.disturbance_active = disturbances.active();
  judge(estimate, r);
  remember_truth(m, disturbances.true_forces());
  r.qp_solved = command.event != QpEvent::kHeld;
  r.qp_status = command.qp_status;
  r.qp_iterations = command.qp_iterations;
  return r;
}

void Recorder::record_balance(const ModelTerms& m, const LocomotionController& controller) noexcept {
  TickRecord& r = record_;
  PerLeg<Vec2> feet;
  Vec2 moment = Vec2::Zero();
  double normal = 0.0;
  for (int l = 0; l < kLegs; ++l) {
    feet[l] = m.contact[l].p.head<2>();
    moment += r.foot_force[3 * l + 2] * feet[l];
    normal += r.foot_force[3 * l + 2];
  }
  const ZmpReport& report = controller.planner().zmp_report();
  r.zmp_planned = controller.planner().zmp_planned();
  r.zmp_status = report.status;
  r.zmp_active_rows = report.active_rows;
  r.zmp_slack = report.slack;
  r.zmp_reference = zero_moment_point(controller.reference().com);
  r.zmp_margin =
      support_polygon(r.stance, feet, controller.planner().options().zmp.line_half_width).margin(r.zmp_reference);
  r.center_of_pressure = moment / normal;
}

void Recorder::judge(const Estimate& estimate, TickRecord& r) const noexcept {
  r.has_leg_estimate = estimate.has_legs && have_truth_;
  r.leg_torque_estimate = estimate.leg_torque;
  r.leg_torque_true = true_torque_;
  r.has_force_estimate = r.has_leg_estimate && single_leg_force_;
  r.force_true = true_force_;
  r.force_estimate = r.has_force_estimate ? force_at_point(point_jacobian_, estimate.leg_torque) : Vec3::Zero();
  r.has_com_estimate = estimate.has_com && have_truth_;
  r.com_wrench_estimate = estimate.com_wrench;
  r.com_wrench_true = true_wrench_;
}

void Recorder::tell_truth(Estimate& estimate) const noexcept {
  if (estimate.has_legs) estimate.leg_torque = true_torque_;
  if (estimate.has_com) estimate.com_wrench = true_wrench_;
}

void Recorder::remember_truth(const ModelTerms& m, std::span<const AppliedForce> forces) noexcept {
  have_truth_ = true;
  true_torque_.setZero();
  true_wrench_.setZero();
  true_force_.setZero();
  record_.applied_point.setZero();
  record_.applied_force.setZero();
  int acting = 0;
  for (const AppliedForce& force : forces) {
    if (force.force_W.isZero(0.0)) continue;
    const ForcePoint point = force_point(m, force);
    true_torque_ += point.J_j.transpose() * force.force_W;
    true_wrench_ += point.J_com.transpose() * force.force_W;
    if (acting == 0) {
      record_.applied_point = point.p;
      record_.applied_force = force.force_W;
    }
    ++acting;
    single_leg_force_ = acting == 1 && force.leg != AppliedForce::kTrunk;
    point_jacobian_ = point.J_j;
    true_force_ = force.force_W;
  }
  if (acting != 1) single_leg_force_ = false;
  record_.applied_forces = acting;
}

}  // namespace dob
