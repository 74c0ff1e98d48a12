// Initial posture of a trial.
#pragma once

#include <map>
#include <string>

#include "robot/model.h"

namespace dob {

// The robot at rest, trunk level, CoM at (0, 0, com_height) of W, sphere centres of the feet at (+-foot_offset_x,
// +-foot_offset_y, radius): all feet just touch the ground z = 0. `posture` [rad] seeds the inverse kinematics by joint
// name and so decides which way the knees bend; joints it does not name start from 0. Throws DescriptionError naming
// the leg whose foot cannot get there.
RobotState standing_pose(const Model& model, double com_height, double foot_offset_x, double foot_offset_y,
                         const std::map<std::string, double>& posture);

}  // namespace dob
