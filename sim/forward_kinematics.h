// Pose and velocity of every link at a state of the robot. Deliberately not taken from robot/model.h: the
// simulator is the independent witness against which that model is tested.
#pragma once

#include <array>

#include "robot/description.h"
#include "robot/types.h"

namespace dob {

inline constexpr int kLinks = 1 + kJoints;

// The trunk is link 0; the links of a leg follow in the order of the stacked joint vector.
constexpr int link_index(int leg, int link) noexcept {
  return 1 + kJointsPerLeg * leg + link;
}

struct LinkMotion {
  Mat3 R_WL = Mat3::Identity();  // link axes to W
  Vec3 p_WL = Vec3::Zero();      // [m] origin of the link frame
  Vec3 p_com = Vec3::Zero();     // [m] centre of mass in W
  Vec3 v_com = Vec3::Zero();     // [m/s] of the centre of mass, along W
  Vec3 omega = Vec3::Zero();     // [rad/s] along W
};

// Of every link by its index, from base pose, joint angles and rates; along W.
std::array<LinkMotion, kLinks> link_motions(const RobotDescription& robot, const RobotState& state) noexcept;

// The description of a link by its index.
const LinkDescription& link_description(const RobotDescription& robot, int index) noexcept;

}  // namespace dob
