// Finds the contacts of the robot with the terrain and holds them for one step. Internal to sim/.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot/types.h"
#include "sim/ode_handles.h"
#include "sim/ode_robot.h"
#include "sim/simulator.h"
#include "sim/terrain.h"

namespace dob {

class OdeContacts {
 public:
  OdeContacts(dWorldID world, const Terrain& terrain, const SimOptions& options);

  // Removes the contacts of the last step and creates those of the present pose. The pairs are visited in a
  // fixed order, not in that of an ODE space, which depends on what moved before.
  void find(std::span<const RobotGeom> geoms);
  void clear();

  // Forces and flags of the step just done.
  void report(StepResult& result) const;

 private:
  struct Surface {
    dGeomID geom;
    double friction;
    std::array<dReal, 6> aabb;  // [m] the terrain never moves
  };
  struct Contact {
    const RobotGeom* part;
    Vec3 point, normal;  // [m] in W; unit vector from the surface to the robot
    dJointFeedback feedback;
  };
  // Feet come first, so that a robot lying in rubble loses contacts of its legs, never of its feet.
  static constexpr std::size_t kMaxContacts = 256;

  void add_surface(dGeomID geom, double friction);
  void collide(const RobotGeom& part, const Surface& surface);
  void add(const RobotGeom& part, double friction, const dContactGeom& geometry);

  dWorldID world_;
  SimOptions options_;
  OdeSpace space_;
  OdeJointGroup joints_;
  std::vector<Surface> surfaces_;
  std::array<Contact, kMaxContacts> contacts_;
  std::size_t count_ = 0;
};

}  // namespace dob
