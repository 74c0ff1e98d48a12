// A payload as an ODE body of its own. Internal to sim/.
#pragma once

#include "sim/ode_handles.h"
#include "sim/payload.h"

namespace dob {

// Body and joint are there from the start, so that putting the load on allocates nothing; until then the body is
// disabled and in no island. They are destroyed with the world.
class OdePayload {
 public:
  OdePayload(dWorldID world, const Payload& payload);

  // Fixes the load to the trunk when its time has come; `p_trunk` [m] is its place from the trunk body's origin.
  void update(double t, dBodyID trunk, const Vec3& p_trunk);
  void take_off();

  const Payload& payload() const noexcept { return payload_; }

 private:
  void put_on(dBodyID trunk, const Vec3& p_trunk);

  Payload payload_;
  dBodyID body_;
  dJointID joint_;
  bool on_ = false;
};

}  // namespace dob
