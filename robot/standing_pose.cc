#include "robot/standing_pose.h"

#include <fmt/format.h>

#include "robot/inverse_kinematics.h"

namespace dob {

RobotState standing_pose(const Model& model, double com_height, double foot_offset_x, double foot_offset_y,
                         const std::map<std::string, double>& posture) {
  const RobotDescription& robot = model.description();
  RobotState state;
  for (int l = 0; l < kLegs; ++l) {
    for (int k = 0; k < kJointsPerLeg; ++k) {
      const auto seed = posture.find(robot.legs[l].joints[k].name);
      if (seed != posture.end()) state.q[3 * l + k] = seed->second;
    }
  }
  // The trunk's place depends on where the legs put the CoM: a contraction, since the legs weigh less than the robot.
  constexpr int kMaxSteps = 200;
  constexpr double kSettled = 1e-12;  // [m]
  const Vec3 target(0.0, 0.0, com_height);
  state.p_WB = target;
  ModelTerms terms;
  for (int i = 0; i < kMaxSteps; ++i) {
    for (int l = 0; l < kLegs; ++l) {
      const Vec3 foot(l < 2 ? foot_offset_x : -foot_offset_x, l % 2 == 0 ? foot_offset_y : -foot_offset_y,
                      robot.legs[l].foot_radius);
      const auto q = solve_leg(robot, Leg{l}, foot - state.p_WB, state.q.segment<3>(3 * l));
      if (!q) {
        throw DescriptionError(
            fmt::format("{}: leg {} cannot reach its standing foothold ({}, {}) m with the CoM at {} m; a lower CoM or "
                        "footholds nearer to the hips are needed",
                        robot.name, kLegNames[l], foot.x(), foot.y(), com_height));
      }
      state.q.segment<3>(3 * l) = *q;
    }
    model.compute(state, terms);
    const Vec3 error = target - terms.p_com;
    if (error.norm() < kSettled) break;
    state.p_WB += error;
  }
  return state;
}

}  // namespace dob
