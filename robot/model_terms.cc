#include "robot/model_terms.h"

namespace dob {

Mat18 ModelTerms::mass_matrix() const noexcept {
  Mat18 M = Mat18::Zero();
  M.topLeftCorner<6, 6>() = M_bb;
  M.topRightCorner<6, 12>() = M_bq;
  M.bottomLeftCorner<12, 6>() = M_bq.transpose();
  for (int l = 0; l < kLegs; ++l) M.block<3, 3>(6 + 3 * l, 6 + 3 * l) = M_qq[l];
  return M;
}

Vec18 ModelTerms::velocity() const noexcept {
  Vec18 v;
  v << state.v_WB, state.omega_WB, state.qd;
  return v;
}

Mat12 jacobian_joints(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept {
  Mat12 J;
  for (int l = 0; l < kLegs; ++l) {
    J.middleRows<3>(3 * l).noalias() = -point_jacobian_com(m, points[l].p) * m.A_c;
    J.block<3, 3>(3 * l, 3 * l) += points[l].J_q;
  }
  return J;
}

Mat12x6 jacobian_com(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept {
  Mat12x6 J;
  for (int l = 0; l < kLegs; ++l) J.middleRows<3>(3 * l) = point_jacobian_com(m, points[l].p);
  return J;
}

Vec12 acceleration_bias(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept {
  const Vec3 linear = m.h_c_centrifugal.head<3>() / m.mass;
  const Vec3 angular = m.I_c_inv * m.h_c_centrifugal.tail<3>();
  Vec12 bias;
  for (int l = 0; l < kLegs; ++l) {
    bias.segment<3>(3 * l) = points[l].Jdot_v - linear - angular.cross(points[l].p - m.p_com);
  }
  return bias;
}

LegPoint leg_point(const ModelTerms& m, Leg leg, LegLink link, const Vec3& p_L) noexcept {
  const auto& chain = m.link[static_cast<int>(leg)];
  const LinkKinematics& body = chain[static_cast<int>(link)];
  const Vec3 r = body.R_WL * p_L;
  LegPoint point;
  point.p = body.p_WL + r;
  point.v = body.v + body.omega.cross(r);
  point.Jdot_v = body.a_bias + body.alpha_bias.cross(r) + body.omega.cross(body.omega.cross(r));
  point.J_q.setZero();
  for (int k = 0; k <= static_cast<int>(link); ++k) {
    point.J_q.col(k) = chain[k].axis_W.cross(point.p - chain[k].p_WL);
  }
  return point;
}

Vec6 com_wrench(const ModelTerms& m, const PerLeg<LegPoint>& points, const Vec12& forces) noexcept {
  Vec6 wrench = Vec6::Zero();
  for (int l = 0; l < kLegs; ++l) {
    const Vec3 f = forces.segment<3>(3 * l);
    wrench.head<3>() += f;
    wrench.tail<3>() += (points[l].p - m.p_com).cross(f);
  }
  return wrench;
}

Vec12 joint_torques(const ModelTerms& m, const PerLeg<LegPoint>& points, const Vec12& forces) noexcept {
  Vec12 torque;
  torque.noalias() = -m.A_c.transpose() * com_wrench(m, points, forces);
  for (int l = 0; l < kLegs; ++l) {
    torque.segment<3>(3 * l) += points[l].J_q.transpose() * forces.segment<3>(3 * l);
  }
  return torque;
}

}  // namespace dob
