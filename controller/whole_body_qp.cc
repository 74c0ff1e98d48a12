#include "controller/whole_body_qp.h"

#include <limits>

namespace dob {

Vec6 desired_wrench(const ModelTerms& m, const MotionReference& reference, const WbcOptions& options) noexcept {
  const Eigen::AngleAxisd rotation(Mat3(reference.R_WB * m.state.R_WB.transpose()));
  Vec6 position_error, velocity_error, wrench;
  position_error << reference.com.p - m.p_com, rotation.angle() * rotation.axis();
  velocity_error << reference.com.v - m.v_c.head<3>(), reference.omega - m.state.omega_WB;
  wrench = options.wrench_kp.cwiseProduct(position_error) + options.wrench_kd.cwiseProduct(velocity_error);
  wrench.head<3>() += m.mass * reference.com.a;
  wrench[2] += m.mass * kGravity;
  return wrench;
}

bool WholeBodyQp::assemble(const ModelTerms& m, const PerLeg<bool>& stance, const MotionReference& reference,
                           const Compensation& compensation, const PerLeg<LegPoint>& points,
                           const Mat12& J_j_inverse) noexcept {
  stance_ = stance;
  assemble_maps(m, reference, compensation, points, J_j_inverse);
  assemble_cost(compensation.wrench - desired_wrench(m, reference, options_));
  assemble_rows(m, compensation, points);
  return problem_.H.allFinite() && problem_.g.allFinite();
}

void WholeBodyQp::assemble_maps(const ModelTerms& m, const MotionReference& reference, const Compensation& compensation,
                                const PerLeg<LegPoint>& points, const Mat12& J_j_inverse) noexcept {
  wrench_map_.setZero();
  Vec12 target = -acceleration_bias(m, points);  // e of the header at delta = 0
  for (int l = 0; l < kLegs; ++l) {
    if (stance_[l]) {
      wrench_map_.block<3, 3>(0, 3 * l).setIdentity();
      wrench_map_.block<3, 3>(3, 3 * l) = skew(points[l].p - m.p_com);
    } else {
      const Motion<Vec3>& ref = reference.foot[l];
      target.segment<3>(3 * l) += ref.a + options_.swing_kd * (ref.v - points[l].v) +
                                  options_.swing_kp * (ref.p - points[l].p) -
                                  compensation.swing_acceleration.segment<3>(3 * l);  // (30), (31)
    }
  }
  rdd_map_.topRows<3>() = wrench_map_.topRows<3>() / m.mass;
  rdd_map_.bottomRows<3>().noalias() = m.I_c_inv * wrench_map_.bottomRows<3>();
  rdd_0_.head<3>() = compensation.dynamics.head<3>() / m.mass;
  rdd_0_[2] -= kGravity;
  rdd_0_.tail<3>().noalias() = m.I_c_inv * compensation.dynamics.tail<3>();

  const Mat12x6 J_com = jacobian_com(m, points);
  Mat12x6 coupling;  // qdd per rdd_c, J_j^-1 J_com
  coupling.noalias() = J_j_inverse * J_com;
  qdd_0_.noalias() = J_j_inverse * target;
  qdd_0_.noalias() -= coupling * rdd_0_;
  qdd_map_.noalias() = -coupling * rdd_map_;
  for (int l = 0; l < kLegs; ++l) {
    if (!stance_[l]) qdd_map_.middleCols<3>(3 * l) += J_j_inverse.middleCols<3>(3 * l) / kTrackingErrorScale;
  }
}

void WholeBodyQp::assemble_cost(const Vec6& wrench_error) noexcept {
  const double r = options_.regularization;
  const double q = options_.wrench_weight;
  Mat12& H = problem_.H;
  H.noalias() = r * qdd_map_.transpose() * qdd_map_;
  H.noalias() += r * rdd_map_.transpose() * rdd_map_;
  H.noalias() += q * wrench_map_.transpose() * wrench_map_;
  problem_.g.noalias() = r * qdd_map_.transpose() * qdd_0_;
  problem_.g.noalias() += r * rdd_map_.transpose() * rdd_0_;
  problem_.g.noalias() += q * wrench_map_.transpose() * wrench_error;
  const double slack = options_.slack_weight / (kTrackingErrorScale * kTrackingErrorScale);
  for (int l = 0; l < kLegs; ++l) {
    H.diagonal().segment<3>(3 * l).array() += stance_[l] ? r : slack;
  }
}

void WholeBodyQp::assemble_rows(const ModelTerms& m, const Compensation& compensation,
                                const PerLeg<LegPoint>& points) noexcept {
  constexpr double kInf = WbcProblem::kInfinity;
  WbcProblem& p = problem_;
  int row = 0;
  for (int l = 0; l < kLegs; ++l) {
    if (!stance_[l]) continue;
    const int x = 3 * l;
    p.C.middleRows<5>(row).setZero();
    for (int k = 0; k < 4; ++k) {  // (23), one facet each: +-f_t - mu f_n <= 0
      p.C(row + k, x + k / 2) = k % 2 == 0 ? 1.0 : -1.0;
      p.C(row + k, x + 2) = -options_.friction;
    }
    p.C(row + 4, x + 2) = 1.0;
    p.lower.segment<4>(row).setConstant(-kInf);
    p.upper.segment<4>(row).setZero();
    p.lower[row + 4] = options_.min_normal_force;
    p.upper[row + 4] = kInf;
    row += 5;
  }
  // (24): the torque of (36), as it is sent.
  torque_row_ = row;
  Mat12 torque_map;
  torque_map.noalias() = m.M_q * qdd_map_;
  torque_map.noalias() += m.A_c.transpose() * wrench_map_;  // - J_j^T f = -J_q^T f + A_c^T J_com^T f
  for (int l = 0; l < kLegs; ++l) {
    if (stance_[l]) torque_map.block<3, 3>(3 * l, 3 * l) -= points[l].J_q.transpose();
  }
  p.C.middleRows<12>(row) = torque_map;
  const Vec12 torque_0 = m.M_q * qdd_0_ + m.c_q - compensation.torque;
  p.lower.segment<12>(row) = -options_.torque_limit - torque_0.array();
  p.upper.segment<12>(row) = options_.torque_limit - torque_0.array();
  p.rows = row + 12;
}

WbcProblem WholeBodyQp::without_torque_rows() const noexcept {
  WbcProblem relaxed = problem_;
  relaxed.rows = torque_row_;
  return relaxed;
}

WbcSolution WholeBodyQp::recover(const Vec12& x) const noexcept {
  WbcSolution s;
  s.rdd_c = rdd_0_ + rdd_map_ * x;
  s.qdd = qdd_0_ + qdd_map_ * x;
  for (int l = 0; l < kLegs; ++l) {
    if (stance_[l]) {
      s.foot_force.segment<3>(3 * l) = x.segment<3>(3 * l);
    } else {
      s.tracking_error.segment<3>(3 * l) = x.segment<3>(3 * l) / kTrackingErrorScale;
    }
  }
  return s;
}

}  // namespace dob
