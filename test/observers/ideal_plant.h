// A plant that obeys eq (3) and the momentum balance of the first six rows of (1) to the last digit, everything
// constant over a tick:
//     d(rho)/dt = C_q^T qd + tau + F,   dP/dt = -m g e_z + sum f_i + f_d,   dL/dt = sum (p_i - c) x f_i + m_d.
// Legs and CoM do not know of one another (A_c = 0), and M_q = I, so that the joint rates are the momentum. Ground
// reaction forces have a lever on their own leg's joints, none by default. What an observer's estimates of F, f_d and
// m_d do on it is known in closed form.
#pragma once

#include "observers/observer.h"

namespace dob::test {

class IdealPlant {
 public:
  Vec12 momentum = Vec12::Zero();     // [kg m^2/s]
  Vec12 coriolis = Vec12::Zero();     // [N m]
  Vec12 torque = Vec12::Zero();       // [N m]
  Vec12 disturbance = Vec12::Zero();  // [N m] F

  double mass = 20.0;                                                            // [kg]
  Vec6 com_momentum = Vec6::Zero();                                              // [kg m/s; kg m^2/s] P, L
  Vec6 com_disturbance = Vec6::Zero();                                           // [N; N m] f_d, m_d
  Vec12 foot_force = Vec12::Zero();                                              // [N]
  Vec3 com = Vec3::Zero();                                                       // [m]
  PerLeg<Vec3> contact{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // [m]
  Mat3 lever = Mat3::Zero();                                                     // [m] J_q of every leg
  PerLeg<bool> stance{true, true, true, true};

  // One tick; the input stays valid until the next one.
  ObserverInput advance(double dt) {
    fill(start_);
    momentum += dt * (coriolis + torque + disturbance);
    com_momentum += dt * com_disturbance;
    com_momentum[2] -= dt * mass * kGravity;
    for (int l = 0; l < kLegs; ++l) {
      const Vec3 f = foot_force.segment<3>(3 * l);
      const Vec3 r = contact[l] - com;
      momentum.segment<3>(3 * l) += dt * lever.transpose() * f;
      com_momentum.head<3>() += dt * f;
      com_momentum[3] += dt * (r.y() * f.z() - r.z() * f.y());
      com_momentum[4] += dt * (r.z() * f.x() - r.x() * f.z());
      com_momentum[5] += dt * (r.x() * f.y() - r.y() * f.x());
    }
    fill(now_);
    return {.start = start_, .now = now_, .joint_torque = torque, .foot_force = foot_force, .stance = stance, .dt = dt};
  }

  const ModelTerms& terms() {
    fill(now_);
    return now_;
  }

 private:
  void fill(ModelTerms& t) const {
    t.rho = momentum;
    t.CqT_qd = coriolis;
    t.state.qd = momentum;
    t.M_q.setIdentity();
    t.c_q = -coriolis;
    t.A_c.setZero();
    t.mass = mass;
    t.v_c << com_momentum.head<3>() / mass, Vec3::Zero();
    t.L = com_momentum.tail<3>();
    t.p_com = com;
    for (int l = 0; l < kLegs; ++l) {
      t.contact[l].p = contact[l];
      t.contact[l].J_q = lever;
    }
  }

  ModelTerms start_;
  ModelTerms now_;
};

}  // namespace dob::test
