#include "observers/residual.h"

namespace dob {

Vec12 known_joint_torque(const ObserverInput& input) noexcept {
  return input.start.CqT_qd + input.joint_torque + joint_torques(input.start, input.start.contact, input.foot_force);
}

Vec12 leg_residual(const ObserverInput& input) noexcept {
  return input.now.rho - input.start.rho - input.dt * known_joint_torque(input);
}

Vec12 acceleration_residual(const ObserverInput& input) noexcept {
  const ModelTerms& m = input.start;
  Vec12 residual = m.c_q - input.joint_torque - joint_torques(m, m.contact, input.foot_force);
  residual *= input.dt;
  residual.noalias() += m.M_q * (input.now.state.qd - m.state.qd);
  return residual;
}

Vec6 com_momentum(const ModelTerms& m) noexcept {
  Vec6 p;
  p << m.mass * m.v_c.head<3>(), m.L;
  return p;
}

Vec6 known_com_wrench(const ObserverInput& input) noexcept {
  Vec6 known = com_wrench(input.start, input.start.contact, input.foot_force);
  known[2] -= input.start.mass * kGravity;
  return known;
}

Vec6 com_residual(const ObserverInput& input) noexcept {
  return com_momentum(input.now) - com_momentum(input.start) - input.dt * known_com_wrench(input);
}

Estimate leg_estimate(const Vec12& leg_torque, bool valid) noexcept {
  Estimate estimate;
  estimate.has_legs = true;
  estimate.leg_torque = leg_torque;
  estimate.status = valid ? EstimateStatus::kOk : EstimateStatus::kInvalidInput;
  return estimate;
}

Estimate com_estimate(const Vec6& com_wrench, bool valid) noexcept {
  Estimate estimate;
  estimate.has_com = true;
  estimate.com_wrench = com_wrench;
  estimate.status = valid ? EstimateStatus::kOk : EstimateStatus::kInvalidInput;
  return estimate;
}

}  // namespace dob
