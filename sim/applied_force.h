// A pure force on one material point of the robot, constant over one step.
#pragma once

#include "robot/types.h"

namespace dob {

struct AppliedForce {
  static constexpr int kTrunk = -1;

  int leg = kTrunk;                // index of a Leg, or kTrunk
  LegLink link = LegLink::kLower;  // which link of that leg; ignored for the trunk
  Vec3 p_L = Vec3::Zero();         // [m] point, in the frame of the link (of B for the trunk)
  Vec3 force_W = Vec3::Zero();     // [N] along the axes of W
};

}  // namespace dob
