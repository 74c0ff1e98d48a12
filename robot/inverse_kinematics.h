// Joint angles that put a foot at a given place relative to the trunk. For setting up postures, not for the
// tick.
#pragma once

#include <optional>

#include "robot/description.h"

namespace dob {

// Centre of the foot's contact sphere in B [m], at the leg's joint angles q [rad] (roll, pitch, knee).
Vec3 foot_center_in_base(const RobotDescription& robot, Leg leg, const Vec3& q) noexcept;

// Joint angles within the joint limits [rad] that put the centre of the foot's contact sphere at p_BF [m, in
// B], to 1e-12 m. Levenberg-Marquardt on the leg's 3x3 Jacobian from seed_q, steps clipped to the limits;
// where that stalls, again from 27 points spread over the limits. A leg may have several solutions: the one
// found first is returned, which near a solution is the one near the seed. std::nullopt if none was found:
// out of reach or beyond the joint limits.
std::optional<Vec3> solve_leg(const RobotDescription& robot, Leg leg, const Vec3& p_BF, const Vec3& seed_q);

}  // namespace dob
