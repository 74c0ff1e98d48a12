#include "controller/compensation.h"

#include <Eigen/Cholesky>

namespace dob {

PerLeg<LegPoint> task_points(const ModelTerms& m, const PerLeg<bool>& stance) noexcept {
  PerLeg<LegPoint> points;
  for (int l = 0; l < kLegs; ++l) points[l] = stance[l] ? m.contact[l] : m.foot[l];
  return points;
}

Vec12 swing_response(const ModelTerms& m, const PerLeg<LegPoint>& points, const PerLeg<bool>& stance,
                     const Vec12& tip_force) noexcept {
  // J M^-1 J^T of all feet in CoM coordinates, where M is block-diagonal.
  const Eigen::LLT<Mat12> M_q(m.M_q);
  const Mat12 Y = M_q.matrixL().solve(jacobian_joints(m, points).transpose());
  const Mat12x6 J_com = jacobian_com(m, points);
  Mat12 response;
  response.noalias() = Y.transpose() * Y;
  response.noalias() += J_com.leftCols<3>() * J_com.leftCols<3>().transpose() / m.mass;
  response.noalias() += J_com.rightCols<3>() * m.I_c_inv * J_com.rightCols<3>().transpose();

  // Eliminate the standing feet: a unit block in place of the swinging ones keeps the size fixed.
  Vec12 swing_force = Vec12::Zero();
  for (int l = 0; l < kLegs; ++l) {
    if (!stance[l]) swing_force.segment<3>(3 * l) = tip_force.segment<3>(3 * l);
  }
  const Vec12 free = response * swing_force;
  Mat12 stance_block = Mat12::Identity();
  Vec12 stance_free = Vec12::Zero();
  for (int l = 0; l < kLegs; ++l) {
    if (!stance[l]) continue;
    stance_free.segment<3>(3 * l) = free.segment<3>(3 * l);
    for (int k = 0; k < kLegs; ++k) {
      if (stance[k]) stance_block.block<3, 3>(3 * l, 3 * k) = response.block<3, 3>(3 * l, 3 * k);
    }
  }
  const Vec12 reaction = -stance_block.llt().solve(stance_free);
  Vec12 acceleration = free + response * reaction;
  for (int l = 0; l < kLegs; ++l) {
    if (stance[l]) acceleration.segment<3>(3 * l).setZero();
  }
  return acceleration;
}

Compensation compensate(const ModelTerms& m, const PerLeg<LegPoint>& points, const Mat12& J_j_inverse,
                        const PerLeg<bool>& stance, const DisturbanceEstimate& estimate, const Routing& routing,
                        bool with_swing_term) noexcept {
  Compensation c;
  Vec6 wrench = estimate.com_wrench;
  if (estimate.has_legs) {
    const Vec12 tip_force = J_j_inverse.transpose() * estimate.leg_torque;
    Vec12 stance_force = Vec12::Zero();
    Vec12 swing_force = Vec12::Zero();
    for (int l = 0; l < kLegs; ++l)
      (stance[l] ? stance_force : swing_force).segment<3>(3 * l) = tip_force.segment<3>(3 * l);
    if (!estimate.has_com) wrench = com_wrench(m, points, stance_force);
    if (routing.torque_36) c.torque += joint_torques(m, points, stance_force);
    if (routing.swing_31 == Routing::Swing::kDirect) c.torque += joint_torques(m, points, swing_force);
    if (routing.swing_31 == Routing::Swing::kProjected && with_swing_term) {
      c.swing_acceleration = swing_response(m, points, stance, swing_force);
    }
  }
  if (routing.wrench_17) c.wrench = wrench;
  if (routing.dynamics_18) c.dynamics = wrench;
  return c;
}

}  // namespace dob
