#include "sim/ode_payload.h"

namespace dob {

OdePayload::OdePayload(dWorldID world, const Payload& payload)
    : payload_(payload), body_(dBodyCreate(world)), joint_(dJointCreateFixed(world, nullptr)) {
  dMass mass;
  dMassSetSphereTotal(&mass, payload.mass, Payload::kRadius);
  dBodySetMass(body_, &mass);
  dBodyDisable(body_);
}

void OdePayload::update(double t, dBodyID trunk, const Vec3& p_trunk) {
  if (!on_ && payload_.on(t)) put_on(trunk, p_trunk);
}

void OdePayload::put_on(dBodyID trunk, const Vec3& p_trunk) {
  dVector3 position;
  dVector3 velocity;
  dBodyGetRelPointPos(trunk, p_trunk.x(), p_trunk.y(), p_trunk.z(), position);
  dBodyGetRelPointVel(trunk, p_trunk.x(), p_trunk.y(), p_trunk.z(), velocity);
  const dReal* omega = dBodyGetAngularVel(trunk);
  dBodySetPosition(body_, position[0], position[1], position[2]);
  dBodySetRotation(body_, dBodyGetRotation(trunk));
  dBodySetLinearVel(body_, velocity[0], velocity[1], velocity[2]);
  dBodySetAngularVel(body_, omega[0], omega[1], omega[2]);
  dBodyEnable(body_);
  dJointAttach(joint_, body_, trunk);
  dJointSetFixed(joint_);
  on_ = true;
}

void OdePayload::take_off() {
  dJointAttach(joint_, nullptr, nullptr);
  dBodySetForce(body_, 0.0, 0.0, 0.0);
  dBodySetTorque(body_, 0.0, 0.0, 0.0);
  dBodyDisable(body_);
  on_ = false;
}

}  // namespace dob
