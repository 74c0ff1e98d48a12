#pragma once

#include "results/tick_record.h"

namespace dob::test {

// All feet stand where they should, nothing acts, nothing is estimated.
inline TickRecord quiet() {
  TickRecord r;
  r.com = r.com_reference = Vec3(0.1, 0.2, 0.4);
  r.path_position = r.zmp_reference = r.center_of_pressure = Vec2(0.1, 0.2);
  r.foot.fill(Vec3(0.3, 0.2, 0.028));
  r.foot_reference = r.foothold = r.foot;
  r.stance.fill(true);
  r.slip.fill(Vec3::Zero());
  for (Vec12* v :
       {&r.foot_force_commanded, &r.foot_force, &r.joint_torque, &r.leg_torque_estimate, &r.leg_torque_true}) {
    v->setZero();
  }
  r.force_estimate = r.force_true = Vec3::Zero();
  r.com_wrench_estimate = r.com_wrench_true = Vec6::Zero();
  return r;
}

}  // namespace dob::test
