#include "sim/forward_kinematics.h"

#include <cstddef>

#include <Eigen/Geometry>

namespace dob {
namespace {

// A frame with the velocity of its origin.
struct Frame {
  Mat3 R;
  Vec3 p, v, omega;
};

LinkMotion motion_of(const Frame& frame, const LinkInertia& inertia) noexcept {
  const Vec3 arm = frame.R * inertia.com;
  return {frame.R, frame.p, frame.p + arm, frame.v + frame.omega.cross(arm), frame.omega};
}

Frame child_of(const Frame& parent, const JointDescription& joint, double q, double qd) noexcept {
  const Vec3 arm = parent.R * joint.origin;
  return {parent.R * Eigen::AngleAxisd(q, joint.axis).toRotationMatrix(), parent.p + arm,
          parent.v + parent.omega.cross(arm), parent.omega + parent.R * joint.axis * qd};
}

}  // namespace

std::array<LinkMotion, kLinks> link_motions(const RobotDescription& robot, const RobotState& state) noexcept {
  std::array<LinkMotion, kLinks> motions;
  const Frame base{state.R_WB, state.p_WB, state.v_WB, state.omega_WB};
  motions[0] = motion_of(base, robot.trunk.inertia);
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDescription& description = robot.legs[static_cast<std::size_t>(leg)];
    Frame frame = base;
    for (int i = 0; i < kJointsPerLeg; ++i) {
      const int joint = kJointsPerLeg * leg + i;
      const auto at = static_cast<std::size_t>(i);
      frame = child_of(frame, description.joints[at], state.q[joint], state.qd[joint]);
      motions[static_cast<std::size_t>(link_index(leg, i))] = motion_of(frame, description.links[at].inertia);
    }
  }
  return motions;
}

const LinkDescription& link_description(const RobotDescription& robot, int index) noexcept {
  if (index == 0) return robot.trunk;
  const auto joint = static_cast<std::size_t>(index - 1);
  return robot.legs[joint / kJointsPerLeg].links[joint % kJointsPerLeg];
}

}  // namespace dob
