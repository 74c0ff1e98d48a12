// DogBot written down by hand in canonical axes (figures: the published description), so that the simulator's
// tests depend neither on the loader nor on the URDF.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "robot/description.h"
#include "sim/forward_kinematics.h"

namespace dob::test {

// Canonical x is the description's -y (it walks backwards), canonical y its +x.
inline LegDescription hand_built_leg(double front, double left) {
  LegDescription leg;
  const auto link = [](std::string name, double mass, const Vec3& com, const Vec3& moments) {
    return LinkDescription{std::move(name), {mass, com, moments.asDiagonal()}, {}};
  };
  leg.links[0] = link("hip", 0.836, {0.0, left * 0.0074, 0.0}, {0.00147, 0.00213, 0.00172});
  leg.links[1] = link("upper", 1.851, {0.0, left * 0.0418, -0.0517}, {0.0252, 0.0238, 0.0044});
  leg.links[2] = link("lower", 0.302, {0.029, 0.0, -0.1439}, {0.00509, 0.00527, 0.0008});
  CollisionShape thigh;
  thigh.kind = CollisionShape::Kind::kCylinder;
  thigh.size = {0.03, 0.28, 0.0};
  thigh.position = {0.0, 0.0, -0.1575};
  leg.links[1].shapes = {thigh};

  leg.joints[0] = {"roll", {front * 0.2875, left * 0.088, 0.0}, {-front, 0.0, 0.0}, -1.7453, 1.7453, 60.0, 6.0};
  leg.joints[1] = {"pitch", {0.0, left * 0.09875, 0.0}, {0.0, left, 0.0}, -3.1416, 3.1416, 60.0, 6.0};
  leg.joints[2] = {"knee", {0.0, 0.0, -0.315}, {0.0, -left, 0.0}, -2.618, 2.618, 60.0, 6.0};
  leg.foot_center = {0.035, 0.0, -0.3};
  leg.foot_radius = 0.028;
  return leg;
}

inline RobotDescription hand_built_robot() {
  RobotDescription robot;
  robot.name = "DogBot by hand";
  robot.trunk.name = "trunk";
  robot.trunk.inertia = {9.3, Vec3::Zero(), Vec3(0.091, 0.41, 0.482).asDiagonal()};
  CollisionShape box;
  box.size = {0.72, 0.32, 0.11};
  robot.trunk.shapes = {box};
  robot.legs = {hand_built_leg(1.0, 1.0), hand_built_leg(1.0, -1.0), hand_built_leg(-1.0, 1.0),
                hand_built_leg(-1.0, -1.0)};
  return robot;
}

inline double mass_of(const RobotDescription& robot) {
  double mass = 0.0;
  for (int i = 0; i < kLinks; ++i) mass += link_description(robot, i).inertia.mass;
  return mass;
}

// Centre of a foot's sphere in W [m].
inline Vec3 foot_center(const RobotDescription& robot, const RobotState& state, int leg) {
  const auto motions = link_motions(robot, state);
  const LinkMotion& lower = motions[static_cast<std::size_t>(link_index(leg, 2))];
  return lower.p_WL + lower.R_WL * robot.legs[static_cast<std::size_t>(leg)].foot_center;
}

// Four feet side by side under the hips, the lowest one just touching z = `ground`.
inline RobotState standing_state(const RobotDescription& robot, double ground = 0.0) {
  RobotState state;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double left = leg % 2 == 0 ? 1.0 : -1.0;
    state.q.segment<3>(3 * leg) << 0.0, left * 0.885, left * 1.604;
  }
  double lowest = 1e9;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double radius = robot.legs[static_cast<std::size_t>(leg)].foot_radius;
    lowest = std::min(lowest, foot_center(robot, state, leg).z() - radius);
  }
  state.p_WB.z() = ground - lowest;
  return state;
}

// Stiff joint position control around a posture [N m].
inline Vec12 hold(const Vec12& posture, const RobotState& state) {
  return 300.0 * (posture - state.q) - 6.0 * state.qd;
}

}  // namespace dob::test
