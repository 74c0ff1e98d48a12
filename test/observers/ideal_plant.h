// A plant that obeys eq (3) to the last digit: d(rho)/dt = C_q^T qd + tau + F, everything constant over a
// tick, no contact forces. What an observer's estimate of F does on it is known in closed form.
#pragma once

#include "observers/observer.h"

namespace dob::test {

class IdealPlant {
 public:
  Vec12 momentum = Vec12::Zero();     // [kg m^2/s]
  Vec12 coriolis = Vec12::Zero();     // [N m]
  Vec12 torque = Vec12::Zero();       // [N m]
  Vec12 disturbance = Vec12::Zero();  // [N m] F

  // One tick; the input stays valid until the next one.
  ObserverInput advance(double dt) {
    fill(start_);
    momentum += dt * (coriolis + torque + disturbance);
    fill(now_);
    return {.start = start_,
            .now = now_,
            .joint_torque = torque,
            .foot_force = Vec12::Zero(),
            .stance = {true, true, true, true},
            .dt = dt};
  }

  const ModelTerms& terms() {
    fill(now_);
    return now_;
  }

 private:
  void fill(ModelTerms& t) const {
    t.rho = momentum;
    t.CqT_qd = coriolis;
    t.A_c.setZero();
    t.p_com.setZero();
    for (LegPoint& point : t.contact) {
      point.p.setZero();
      point.J_q.setZero();
    }
  }

  ModelTerms start_;
  ModelTerms now_;
};

}  // namespace dob::test
