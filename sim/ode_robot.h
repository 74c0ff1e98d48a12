// The robot's bodies, hinges and collision solids in an ODE world. Internal to sim/.
//
// Body frames: origin at the link's centre of mass, axes of the canonical link frame.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot/description.h"
#include "robot/types.h"
#include "sim/applied_force.h"
#include "sim/forward_kinematics.h"
#include "sim/ode_handles.h"

namespace dob {

// A collision solid of the robot and what touching something with it means.
struct RobotGeom {
  enum class Part { kFoot, kTrunk, kLeg };
  dGeomID geom;
  dBodyID body;
  Part part;
  int leg;  // of a foot
};

class OdeRobot {
 public:
  // Builds the robot at RobotState{}. Throws std::invalid_argument for masses that are not positive and
  // inertias that are not positive definite.
  OdeRobot(dWorldID world, const RobotDescription& robot, bool joint_stops);

  // Base pose and velocity along W, joint angles [rad] and rates [rad/s], put on and read off the bodies.
  void set_state(const RobotState& state);
  RobotState state() const;

  // Adds the torques within the effort limits [N m] and returns what was added.
  Vec12 add_torques(const Vec12& commanded);
  void add_force(const AppliedForce& force);

  dBodyID trunk() const noexcept { return bodies_[0]; }
  Vec3 on_trunk(const Vec3& p_B) const noexcept { return p_B - robot_.trunk.inertia.com; }  // [m] in the trunk's body

  // Feet first, then the trunk, then the legs.
  std::span<const RobotGeom> geoms() const noexcept { return geoms_; }

 private:
  void build_bodies(dWorldID world);
  void build_hinges(dWorldID world, bool joint_stops);
  void build_geoms();
  void add_geom(const CollisionShape& shape, int link, RobotGeom::Part part, int leg);
  void place(int link, const LinkMotion& motion);

  RobotDescription robot_;
  Vec12 effort_limit_ = Vec12::Zero();  // [N m]
  OdeSpace space_;
  std::array<dBodyID, kLinks> bodies_{};
  std::array<dJointID, kJoints> hinges_{};
  std::vector<RobotGeom> geoms_;
};

}  // namespace dob
