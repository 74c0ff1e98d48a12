// An ideal plant for any observer: the robot's own mass matrix and Jacobians at one pose, frozen there, in free fall.
// Linear and exact,
//     M_q d(qd)/dt = F,   m d(c_dot)/dt = -m g e_z + f_d,   I_c d(omega)/dt = m_d,
// joint torques zero, everything constant over a tick. What an observer makes of F, f_d and m_d is its own doing, not
// that of a gait, a contact or a changing inertia.
//
// The model terms agree with one another in everything that depends on velocity: rho, p_q, p_b, v_c, L, the velocities
// of base, joints, feet and contact points. Terms quadratic in velocity are zero (the pose does not move), link
// velocities stay zero. No foot touches anything, none is scheduled to stand.
#pragma once

#include <array>

#include <Eigen/Cholesky>

#include "observers/observer.h"

namespace dob {

class FrozenRobot {
 public:
  Vec12 leg_torque = Vec12::Zero();  // [N m] F, unknown to the observer
  Vec6 com_wrench = Vec6::Zero();    // [N; N m] f_d, m_d about the CoM along W, unknown to it

  // `pose`: terms of a robot at rest.
  explicit FrozenRobot(const ModelTerms& pose);

  const ModelTerms& terms() const noexcept { return *now_; }

  // One tick; the input stays valid until the next one.
  ObserverInput advance(double dt) noexcept;

 private:
  void move(ModelTerms& terms) const noexcept;

  std::array<ModelTerms, 2> terms_;
  ModelTerms* start_ = &terms_[0];
  ModelTerms* now_ = &terms_[1];
  Eigen::LLT<Mat12> M_q_;
  Vec12 rho_ = Vec12::Zero();  // [kg m^2/s]
  Vec6 P_ = Vec6::Zero();      // [kg m/s; kg m^2/s] momentum, angular about the CoM
};

}  // namespace dob
