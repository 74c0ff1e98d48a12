// The paper's Fig. 1 from a robot description: the robot, standing, as the solids of its links, seen from its right and
// from above, with the world frame W, the base frame B, the centre of mass and the feet.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/figure.h"
#include "robot/description.h"

namespace dob {

// Of a link at a pose, seen along `view`: 1 from the right (x to the right, z up), 2 from above (x to the right, y up).
// The outline of the shape's projection, counter-clockwise; a box is exact, what is round has corners. [m]
std::vector<std::array<double, 2>> outline(const CollisionShape& shape, const Mat3& R_WL, const Vec3& p_WL, int view);

// The robots of scenarios' files, each once, in the posture of its first one: two panels each. Throws InputError,
// DescriptionError.
Figure robot_figure(const std::string& id, const std::vector<std::filesystem::path>& scenarios);

}  // namespace dob
