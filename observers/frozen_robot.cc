#include "observers/frozen_robot.h"

#include <utility>

namespace dob {

FrozenRobot::FrozenRobot(const ModelTerms& pose) : terms_{pose, pose}, M_q_(pose.M_q) {}

ObserverInput FrozenRobot::advance(double dt) noexcept {
  rho_ += dt * leg_torque;
  P_ += dt * com_wrench;
  P_[2] -= dt * now_->mass * kGravity;
  std::swap(start_, now_);
  move(*now_);
  return {.start = *start_,
          .now = *now_,
          .joint_torque = Vec12::Zero(),
          .foot_force = Vec12::Zero(),
          .stance = {false, false, false, false},
          .dt = dt};
}

// v_c = X v_b + A_c qd, where X moves the reference point from the base origin to the CoM.
void FrozenRobot::move(ModelTerms& t) const noexcept {
  t.rho = rho_;
  t.state.qd = M_q_.solve(rho_);
  t.v_c << P_.head<3>() / t.mass, t.I_c_inv * P_.tail<3>();
  t.L = P_.tail<3>();
  const Vec6 carried = t.v_c - t.A_c * t.state.qd;
  const Vec3 omega = carried.tail<3>();
  const Vec3 v = carried.head<3>() - omega.cross(t.p_com - t.state.p_WB);
  t.state.omega_WB = omega;
  t.state.v_WB = v;

  Vec6 v_b;
  v_b << v, omega;
  t.p_b.noalias() = t.M_bb * v_b + t.M_bq * t.state.qd;
  t.p_q.noalias() = t.M_bq.transpose() * v_b;
  for (int l = 0; l < kLegs; ++l) {
    const Vec3 qd = t.state.qd.segment<3>(3 * l);
    t.p_q.segment<3>(3 * l) += t.M_qq[l] * qd;
    for (LegPoint* point : {&t.foot[l], &t.contact[l]}) {
      point->v = v + omega.cross(point->p - t.state.p_WB) + point->J_q * qd;
    }
  }
}

}  // namespace dob
