#include "controller/compensation.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace dob {

PerLeg<LegPoint> task_points(const ModelTerms& m, const PerLeg<bool>& stance) noexcept {
  PerLeg<LegPoint> points;
  for (int l = 0; l < kLegs; ++l) points[l] = stance[l] ? m.contact[l] : m.foot[l];
  return points;
}

Vec12 swing_response(const ModelTerms& m, const PerLeg<LegPoint>& points, const TaskJacobian& J,
                     const PerLeg<bool>& stance, const Vec12& tip_force) noexcept {
  Mat6 inertia = Mat6::Zero();  // of the trunk with legs that stand or hang freely
  inertia.diagonal().head<3>().setConstant(m.mass);
  inertia.bottomRightCorner<3, 3>() = m.I_c;
  Vec6 wrench = Vec6::Zero();
  Vec12 free = Vec12::Zero();  // joint accelerations of the swinging legs under a trunk at rest
  PerLeg<Mat36> follow;        // joint accelerations of a swinging leg per -y
  for (int l = 0; l < kLegs; ++l) {
    const Mat36 F_t = J.F.middleCols<3>(3 * l).transpose();
    if (stance[l]) {
      const Mat36 F_t_E = F_t - m.M_qq[l].lazyProduct(J.E[l]);
      inertia.noalias() -= F_t.transpose().lazyProduct(J.E[l]);
      inertia.noalias() -= J.E[l].transpose().lazyProduct(F_t_E);
    } else {
      const Mat3 M_inv = m.M_qq[l].inverse();
      const Vec3 f = tip_force.segment<3>(3 * l);
      follow[l].noalias() = M_inv * F_t;
      free.segment<3>(3 * l).noalias() = M_inv * (points[l].J_q.transpose() * f).eval();
      inertia.noalias() -= F_t.transpose().lazyProduct(follow[l]);
      wrench.head<3>() += f;
      wrench.tail<3>() += J.arm[l].cross(f);
      wrench.noalias() -= F_t.transpose() * free.segment<3>(3 * l);
    }
  }
  const Vec6 y = inertia.llt().solve(wrench);
  Vec12 acceleration = Vec12::Zero();
  for (int l = 0; l < kLegs; ++l) {
    if (stance[l]) continue;
    const Vec3 qdd = free.segment<3>(3 * l) - follow[l] * y;
    acceleration.segment<3>(3 * l) = y.head<3>() + y.tail<3>().cross(J.arm[l]) + points[l].J_q * qdd;
  }
  return acceleration;
}

Compensation compensate(const ModelTerms& m, const PerLeg<LegPoint>& points, const TaskJacobian& J,
                        const PerLeg<bool>& stance, const DisturbanceEstimate& estimate, const Routing& routing,
                        bool with_swing_term) noexcept {
  using Source = Routing::WrenchSource;
  Compensation c;
  const bool use_com = routing.wrench_source == Source::kCom && estimate.has_com;
  Vec6 wrench = use_com ? estimate.com_wrench : Vec6::Zero();
  if (estimate.has_legs) {
    const Vec12 tip_force = J.solve_transposed(estimate.leg_torque);
    Vec12 stance_force = Vec12::Zero();
    Vec12 swing_force = Vec12::Zero();
    for (int l = 0; l < kLegs; ++l)
      (stance[l] ? stance_force : swing_force).segment<3>(3 * l) = tip_force.segment<3>(3 * l);
    if (!use_com) {
      wrench = com_wrench(m, points, routing.wrench_source == Source::kAllLegs ? tip_force : stance_force);
    }
    if (routing.torque_36) c.torque += joint_torques(m, points, stance_force);
    if (routing.swing_31 == Routing::Swing::kDirect) c.torque += joint_torques(m, points, swing_force);
    if (routing.swing_31 == Routing::Swing::kProjected && with_swing_term && !swing_force.isZero(0.0)) {
      c.swing_acceleration = swing_response(m, points, J, stance, swing_force);
    }
  }
  if (routing.wrench_17) c.wrench = wrench;
  if (routing.dynamics_18) c.dynamics = wrench;
  return c;
}

}  // namespace dob
