#include "sim/ode_robot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <fmt/format.h>

namespace dob {
namespace {

dMass ode_mass(const LinkDescription& link) {
  const Mat3& I = link.inertia.inertia;
  const bool positive = link.inertia.mass > 0.0 && Eigen::LLT<Mat3>(I).info() == Eigen::Success;
  if (!positive || !std::isfinite(link.inertia.mass) || !I.allFinite()) {
    throw std::invalid_argument(
        fmt::format("robot: link '{}' has mass {} and inertia diagonal ({}, {}, {}); the mass must be positive and the "
                    "inertia positive definite",
                    link.name, link.inertia.mass, I(0, 0), I(1, 1), I(2, 2)));
  }
  dMass mass;
  dMassSetParameters(&mass, link.inertia.mass, 0.0, 0.0, 0.0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  return mass;
}

dGeomID ode_geom(dSpaceID space, const CollisionShape& shape) {
  switch (shape.kind) {
    case CollisionShape::Kind::kCylinder:
      return dCreateCylinder(space, shape.size.x(), shape.size.y());
    case CollisionShape::Kind::kSphere:
      return dCreateSphere(space, shape.size.x());
    case CollisionShape::Kind::kBox:
      break;
  }
  return dCreateBox(space, shape.size.x(), shape.size.y(), shape.size.z());
}

}  // namespace

OdeRobot::OdeRobot(dWorldID world, const RobotDescription& robot, bool joint_stops)
    : robot_(robot), space_(dSimpleSpaceCreate(nullptr)) {
  build_bodies(world);
  build_hinges(world, joint_stops);
  build_geoms();
}

void OdeRobot::build_bodies(dWorldID world) {
  for (int link = 0; link < kLinks; ++link) {
    const dMass mass = ode_mass(link_description(robot_, link));
    dBodyID& body = bodies_[static_cast<std::size_t>(link)];
    body = dBodyCreate(world);
    dBodySetMass(body, &mass);
  }
  set_state(RobotState{});
}

// ODE takes the pose at which a hinge is built as its angle zero, hence at RobotState{}.
void OdeRobot::build_hinges(dWorldID world, bool joint_stops) {
  const auto motions = link_motions(robot_, RobotState{});
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int i = 0; i < kJointsPerLeg; ++i) {
      const int index = kJointsPerLeg * leg + i;
      const auto link = static_cast<std::size_t>(link_index(leg, i));
      const JointDescription& joint = robot_.legs[static_cast<std::size_t>(leg)].joints[static_cast<std::size_t>(i)];
      dJointID hinge = dJointCreateHinge(world, nullptr);
      // First body: the child, so that angle, rate and torque are those of the child relative to its parent.
      dJointAttach(hinge, bodies_[link], bodies_[i == 0 ? 0 : link - 1]);
      const Vec3& anchor = motions[link].p_WL;
      dJointSetHingeAnchor(hinge, anchor.x(), anchor.y(), anchor.z());
      dJointSetHingeAxis(hinge, joint.axis.x(), joint.axis.y(), joint.axis.z());
      if (joint_stops) {
        dJointSetHingeParam(hinge, dParamLoStop, joint.lower);
        dJointSetHingeParam(hinge, dParamHiStop, joint.upper);
      }
      hinges_[static_cast<std::size_t>(index)] = hinge;
      effort_limit_[index] = joint.effort_limit;
    }
  }
}

void OdeRobot::build_geoms() {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDescription& description = robot_.legs[static_cast<std::size_t>(leg)];
    CollisionShape foot;
    foot.kind = CollisionShape::Kind::kSphere;
    foot.size.x() = description.foot_radius;
    foot.position = description.foot_center;
    add_geom(foot, link_index(leg, static_cast<int>(LegLink::kLower)), RobotGeom::Part::kFoot, leg);
  }
  for (int link = 0; link < kLinks; ++link) {
    const auto part = link == 0 ? RobotGeom::Part::kTrunk : RobotGeom::Part::kLeg;
    for (const CollisionShape& shape : link_description(robot_, link).shapes) {
      add_geom(shape, link, part, link == 0 ? AppliedForce::kTrunk : (link - 1) / kJointsPerLeg);
    }
  }
}

void OdeRobot::add_geom(const CollisionShape& shape, int link, RobotGeom::Part part, int leg) {
  dBodyID body = bodies_[static_cast<std::size_t>(link)];
  dGeomID geom = ode_geom(space_.get(), shape);
  dGeomSetBody(geom, body);
  const Vec3 offset = shape.position - link_description(robot_, link).inertia.com;
  dGeomSetOffsetPosition(geom, offset.x(), offset.y(), offset.z());
  dGeomSetOffsetRotation(geom, OdeRotation(shape.rotation).data);
  geoms_.push_back({geom, body, part, leg});
}

void OdeRobot::place(int link, const LinkMotion& motion) {
  dBodyID body = bodies_[static_cast<std::size_t>(link)];
  dBodySetPosition(body, motion.p_com.x(), motion.p_com.y(), motion.p_com.z());
  dBodySetRotation(body, OdeRotation(motion.R_WL).data);
  dBodySetLinearVel(body, motion.v_com.x(), motion.v_com.y(), motion.v_com.z());
  dBodySetAngularVel(body, motion.omega.x(), motion.omega.y(), motion.omega.z());
  dBodySetForce(body, 0.0, 0.0, 0.0);
  dBodySetTorque(body, 0.0, 0.0, 0.0);
}

void OdeRobot::set_state(const RobotState& state) {
  const auto motions = link_motions(robot_, state);
  for (int link = 0; link < kLinks; ++link) place(link, motions[static_cast<std::size_t>(link)]);
}

RobotState OdeRobot::state() const {
  dBodyID trunk = bodies_[0];
  RobotState state;
  state.R_WB = rotation_from_ode(dBodyGetRotation(trunk));
  state.omega_WB = from_ode(dBodyGetAngularVel(trunk));
  const Vec3 arm = state.R_WB * robot_.trunk.inertia.com;
  state.p_WB = from_ode(dBodyGetPosition(trunk)) - arm;
  state.v_WB = from_ode(dBodyGetLinearVel(trunk)) - state.omega_WB.cross(arm);
  for (int joint = 0; joint < kJoints; ++joint) {
    dJointID hinge = hinges_[static_cast<std::size_t>(joint)];
    state.q[joint] = dJointGetHingeAngle(hinge);
    state.qd[joint] = dJointGetHingeAngleRate(hinge);
  }
  return state;
}

Vec12 OdeRobot::add_torques(const Vec12& commanded) {
  Vec12 applied = commanded.cwiseMax(-effort_limit_).cwiseMin(effort_limit_);
  for (int joint = 0; joint < kJoints; ++joint) {
    dJointAddHingeTorque(hinges_[static_cast<std::size_t>(joint)], applied[joint]);
  }
  return applied;
}

void OdeRobot::add_force(const AppliedForce& force) {
  const int link = force.leg == AppliedForce::kTrunk ? 0 : link_index(force.leg, static_cast<int>(force.link));
  const Vec3 arm = force.p_L - link_description(robot_, link).inertia.com;
  const Vec3& f = force.force_W;
  dBodyAddForceAtRelPos(bodies_[static_cast<std::size_t>(link)], f.x(), f.y(), f.z(), arm.x(), arm.y(), arm.z());
}

}  // namespace dob
