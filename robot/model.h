// Computes ModelTerms: our own recursive kinematics and dynamics for the fixed topology, no heap, no branches.
//
// All quantities are along the axes of W and relative to the base origin, so that one outward pass per leg
// (velocities, bias accelerations, link inertias) and one inward pass (subtree sums) give everything. The legs are
// identical chains and go through both passes side by side (leg_lanes.h).
#pragma once

#include "robot/description.h"
#include "robot/leg_lanes.h"
#include "robot/model_terms.h"

namespace dob {

class Model {
 public:
  // Keeps a copy of the description; its inertias must be those of a physical robot (the loader checks).
  explicit Model(const RobotDescription& robot);

  // All terms at the given state. Assumes a right-handed orthonormal R_WB and joint angles within 1e5 rad.
  void compute(const RobotState& state, ModelTerms& terms) const noexcept;

  double mass() const noexcept { return mass_; }  // [kg] of all links
  const RobotDescription& description() const noexcept { return robot_; }

 private:
  RobotDescription robot_;
  LanesBody trunk_;  // in the first lane only
  std::array<LanesLeg, kLegs / kLanes> legs_;
  double mass_;
};

}  // namespace dob
