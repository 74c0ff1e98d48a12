// Computes ModelTerms: our own recursive kinematics and dynamics for the fixed topology, no heap, no branches.
//
// All quantities are along the axes of W and relative to the base origin, so that one outward pass per leg
// (velocities, bias accelerations, link inertias) and one inward pass (subtree sums) give everything.
#pragma once

#include "robot/description.h"
#include "robot/model_terms.h"

namespace dob {

class Model {
 public:
  explicit Model(const RobotDescription& robot);

  // All terms at the given state. Assumes a right-handed orthonormal R_WB; no other precondition.
  void compute(const RobotState& state, ModelTerms& terms) const noexcept;

  double mass() const noexcept { return mass_; }
  const RobotDescription& description() const noexcept { return robot_; }

 private:
  struct Joint {
    Vec3 axis, origin;
    Mat3 skew_axis, skew_axis_squared;  // Rodrigues: R = I + sin q [a] + (1 - cos q) [a]^2
  };
  struct Body {
    double mass;
    Vec3 com;
    Mat3 inertia;
  };
  struct LegModel {
    std::array<Joint, kJointsPerLeg> joints;
    std::array<Body, kJointsPerLeg> links;
    Vec3 foot_center;
    double foot_radius;
  };
  RobotDescription robot_;
  Body trunk_;
  PerLeg<LegModel> legs_;
  double mass_;
};

}  // namespace dob
