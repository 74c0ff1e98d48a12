#include "controller/whole_body_qp.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "controller/acceleration_limits.h"

namespace dob {
namespace {

// R = Rz(yaw) Ry(pitch) Rx(roll); [roll, pitch, yaw].
Vec3 zyx_angles(const Mat3& R) noexcept {
  return {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2))),
          std::atan2(R(1, 0), R(0, 0))};
}

// Rotation vector of R_ref R^T along W, or the printed difference of angles with each component in [-pi, pi].
Vec3 orientation_error(const Mat3& R_ref, const Mat3& R, WbcOptions::OrientationError kind) noexcept {
  if (kind == WbcOptions::OrientationError::kRotationVector) {
    const Eigen::AngleAxisd rotation(Mat3(R_ref * R.transpose()));
    return rotation.angle() * rotation.axis();
  }
  Vec3 difference = zyx_angles(R_ref) - zyx_angles(R);
  for (double& angle : difference) angle = std::remainder(angle, 2.0 * std::numbers::pi);
  return difference;
}

// a Y: one row of a map from x by way of y.
template <typename Coefficients, typename Map>
Eigen::Matrix<double, 1, 12> row_through(const Coefficients& a, const Map& Y) noexcept {
  Eigen::Matrix<double, 1, 12> row = Y.row(0) * a[0];
  for (int k = 1; k < 6; ++k) row += Y.row(k) * a[k];
  return row;
}

}  // namespace

Vec6 desired_wrench(const ModelTerms& m, const MotionReference& reference, const WbcOptions& options) noexcept {
  Vec6 position_error, velocity_error, wrench;
  position_error << reference.com.p - m.p_com,
      orientation_error(reference.R_WB, m.state.R_WB, options.orientation_error);
  velocity_error << reference.com.v - m.v_c.head<3>(), reference.omega - m.state.omega_WB;
  wrench = options.wrench_kp.cwiseProduct(position_error) + options.wrench_kd.cwiseProduct(velocity_error);
  wrench.head<3>() += m.mass * reference.com.a;
  wrench.tail<3>() += m.I_c * reference.alpha;
  wrench[2] += m.mass * kGravity;
  return wrench;
}

void WholeBodyQp::assemble(const ModelTerms& m, const PerLeg<bool>& stance, const MotionReference& reference,
                           const Compensation& compensation, const PerLeg<LegPoint>& points,
                           const TaskJacobian& J) noexcept {
  stance_ = stance;
  mass_ = m.mass;
  I_c_inv_ = m.I_c_inv;
  assemble_maps(m, reference, compensation, points, J);
  assemble_cost(compensation.wrench - desired_wrench(m, reference, options_), J);
  assemble_contact_rows();
  torque_row_ = problem_.rows;
  if (options_.torque_rows) assemble_torque_rows(m, compensation.torque, points, J);
  acceleration_row_ = problem_.rows;
  if (options_.joint_acceleration_limits) assemble_acceleration_rows(m.state, J);
}

Vec6 WholeBodyQp::per_com_inertia(const Vec6& wrench) const noexcept {
  Vec6 acceleration;
  acceleration.head<3>() = wrench.head<3>() / mass_;
  acceleration.tail<3>().noalias() = I_c_inv_ * wrench.tail<3>();
  return acceleration;
}

void WholeBodyQp::assemble_maps(const ModelTerms& m, const MotionReference& reference, const Compensation& compensation,
                                const PerLeg<LegPoint>& points, const TaskJacobian& J) noexcept {
  const double sign = options_.printed_sign_21 ? -1.0 : 1.0;
  e_0_ = -acceleration_bias(m, points);
  Mat6x12 trunk;  // S Y
  for (int l = 0; l < kLegs; ++l) {
    if (stance_[l]) {
      const Mat3 moment = skew(J.arm[l]);
      W_.block<3, 3>(0, 3 * l).setIdentity();
      W_.block<3, 3>(3, 3 * l) = moment;
      trunk.block<3, 3>(0, 3 * l) = Mat3::Identity() * (sign / m.mass);
      trunk.block<3, 3>(3, 3 * l).noalias() = sign * m.I_c_inv.lazyProduct(moment);
      B_[l].setZero();
    } else {
      const Motion<Vec3>& ref = reference.foot[l];
      e_0_.segment<3>(3 * l) += ref.a + options_.swing_kd * (ref.v - points[l].v) +
                                options_.swing_kp * (ref.p - points[l].p) -
                                compensation.swing_acceleration.segment<3>(3 * l);  // (30), (31)
      W_.middleCols<3>(3 * l).setZero();
      B_[l] = J.D_inv[l] / kTrackingErrorScale;
      trunk.middleCols<3>(3 * l).noalias() = -J.A_c.middleCols<3>(3 * l).lazyProduct(B_[l]);
    }
    own_qdd_0_.segment<3>(3 * l).noalias() = J.D_inv[l] * e_0_.segment<3>(3 * l);
  }
  Vec6 w_18 = compensation.dynamics;
  w_18[2] -= m.mass * kGravity;
  rdd_0_ = per_com_inertia(w_18);
  const Vec6 y_0 = J.S_inv * (rdd_0_ - J.A_c.lazyProduct(own_qdd_0_));
  const Rows6x12 SY = trunk;
  for (int i = 0; i < 6; ++i) Y_.row(i) = row_through(J.S_inv.row(i), SY);
  for (int l = 0; l < kLegs; ++l) {
    qdd_0_.segment<3>(3 * l) = own_qdd_0_.segment<3>(3 * l) - J.E[l] * y_0;
  }
}

void WholeBodyQp::assemble_cost(const Vec6& wrench_error, const TaskJacobian& J) noexcept {
  const double r = options_.regularization;
  const double q = options_.wrench_weight;
  const double slack = options_.slack_weight / (kTrackingErrorScale * kTrackingErrorScale);
  const double sign = options_.printed_sign_21 ? -1.0 : 1.0;

  Mat6 EtE = Mat6::Zero();
  Vec6 Et_qdd_0 = Vec6::Zero();
  Rows6x12 V;
  for (int l = 0; l < kLegs; ++l) {
    EtE.noalias() += J.E[l].transpose().lazyProduct(J.E[l]);
    Et_qdd_0.noalias() += J.E[l].transpose() * qdd_0_.segment<3>(3 * l);
    V.middleCols<3>(3 * l).noalias() = J.E[l].transpose().lazyProduct(B_[l]);
  }
  Rows6x12 K, NW;
  Mat3 N_angular = r * I_c_inv_.lazyProduct(I_c_inv_);
  N_angular.diagonal().array() += q;
  NW.topRows<3>() = (q + r / (mass_ * mass_)) * W_.topRows<3>();
  NW.bottomRows<3>().noalias() = N_angular.lazyProduct(W_.bottomRows<3>());
  for (int i = 0; i < 6; ++i) K.row(i) = r * (row_through(EtE.row(i), Y_) - V.row(i));

  assemble_hessian<0>(K, NW, V);
  assemble_hessian<1>(K, NW, V);
  assemble_hessian<2>(K, NW, V);
  assemble_hessian<3>(K, NW, V);

  problem_.g = row_through(-r * Et_qdd_0, Y_).transpose();
  const Vec6 on_force = sign * r * per_com_inertia(rdd_0_) + q * wrench_error;
  for (int l = 0; l < kLegs; ++l) {
    auto g = problem_.g.segment<3>(3 * l);
    if (stance_[l]) {
      g += on_force.head<3>() + on_force.tail<3>().cross(J.arm[l]);
      problem_.H.diagonal().segment<3>(3 * l).array() += r;
    } else {
      g.noalias() += r * B_[l].transpose() * qdd_0_.segment<3>(3 * l);
      problem_.H.block<3, 3>(3 * l, 3 * l).noalias() += r * B_[l].transpose().lazyProduct(B_[l]);
      problem_.H.diagonal().segment<3>(3 * l).array() += slack;
    }
  }
}

// The leg's three columns of H from its own rows on, and their mirror image.
template <int leg>
void WholeBodyQp::assemble_hessian(const Rows6x12& K, const Rows6x12& NW, const Rows6x12& V) noexcept {
  constexpr int kFirst = 3 * leg;
  constexpr int kBelow = kWbcVariables - kFirst;
  const double r = options_.regularization;
  const bool stands = stance_[leg];
  const Rows6x12& right = stands ? NW : Y_;
  for (int j = kFirst; j < kFirst + 3; ++j) {
    Eigen::Matrix<double, 1, kBelow> column = Eigen::Matrix<double, 1, kBelow>::Zero();
    for (int k = 0; k < 6; ++k) {
      column += K.row(k).template tail<kBelow>() * Y_(k, j);
      column += right.row(k).template tail<kBelow>() * (stands ? W_(k, j) : -r * V(k, j));
    }
    problem_.H.col(j).template tail<kBelow>() = column.transpose();
    problem_.H.row(j).template tail<kBelow>() = column;
  }
}

void WholeBodyQp::assemble_contact_rows() noexcept {
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
  p.rows = row;
}

// (24): the torque of (36), as it is sent.
void WholeBodyQp::assemble_torque_rows(const ModelTerms& m, const Vec12& compensated, const PerLeg<LegPoint>& points,
                                       const TaskJacobian& J) noexcept {
  WbcProblem& p = problem_;
  Vec12 torque_0 = m.M_q.lazyProduct(qdd_0_) - compensated;
  if (options_.coriolis == WbcOptions::Coriolis::kExact) torque_0 += m.c_q;
  for (int l = 0; l < kLegs; ++l) {
    const int row = p.rows + 3 * l;
    Mat36 through_y = J.F.middleCols<3>(3 * l).transpose();
    through_y.noalias() -= m.M_qq[l].lazyProduct(J.E[l]);
    for (int i = 0; i < 3; ++i) p.C.row(row + i) = row_through(through_y.row(i), Y_);
    if (options_.printed_sign_21) {  // then (18) makes of -J_j^T f more than the trunk's share
      p.C.middleRows<3>(row).noalias() += 2.0 * J.A_c.middleCols<3>(3 * l).transpose().lazyProduct(W_);
    }
    if (stance_[l]) {
      p.C.block<3, 3>(row, 3 * l) -= points[l].J_q.transpose();
    } else {
      p.C.block<3, 3>(row, 3 * l).noalias() += m.M_qq[l].lazyProduct(B_[l]);
    }
  }
  p.lower.segment<12>(p.rows) = -options_.torque_limit - torque_0.array();
  p.upper.segment<12>(p.rows) = options_.torque_limit - torque_0.array();
  p.rows += 12;
}

void WholeBodyQp::assemble_acceleration_rows(const RobotState& state, const TaskJacobian& J) noexcept {
  WbcProblem& p = problem_;
  Vec12 rest = Vec12::Zero();
  for (int l = 0; l < kLegs; ++l) {
    const int row = p.rows + 3 * l;
    for (int i = 0; i < 3; ++i) p.C.row(row + i) = row_through(-J.E[l].row(i), Y_);
    p.C.block<3, 3>(row, 3 * l) += B_[l];
    if (stance_[l]) rest.segment<3>(3 * l) = own_qdd_0_.segment<3>(3 * l);  // what the contact itself demands
  }
  const AccelerationLimits limits = acceleration_limits(state, rest, options_);
  p.lower.segment<12>(p.rows) = limits.lower - qdd_0_;
  p.upper.segment<12>(p.rows) = limits.upper - qdd_0_;
  p.rows += 12;
}

WbcProblem WholeBodyQp::with_first_rows(int rows) const noexcept {
  WbcProblem relaxed = problem_;
  relaxed.rows = rows;
  return relaxed;
}

// From e and rdd_c again, not by the maps from x: a large e_0 that delta takes back would leave its rounding errors.
WbcSolution WholeBodyQp::recover(const Vec12& x, const TaskJacobian& J) const noexcept {
  const double sign = options_.printed_sign_21 ? -1.0 : 1.0;
  WbcSolution s;
  for (int l = 0; l < kLegs; ++l) {
    if (stance_[l]) {
      s.foot_force.segment<3>(3 * l) = x.segment<3>(3 * l);
    } else {
      s.tracking_error.segment<3>(3 * l) = x.segment<3>(3 * l) / kTrackingErrorScale;
    }
  }
  s.rdd_c = rdd_0_ + sign * per_com_inertia(W_.lazyProduct(x));
  s.qdd = J.solve(s.rdd_c, e_0_ + s.tracking_error);
  return s;
}

}  // namespace dob
