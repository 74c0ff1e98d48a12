// Bounds on joint accelerations that keep joints within their position and velocity limits (published code, not in the
// paper).
#pragma once

#include "controller/wbc_options.h"

namespace dob {

struct AccelerationLimits {
  Vec12 lower;  // [rad/s^2]
  Vec12 upper;  // [rad/s^2]
};

// The accelerations that, held for the horizon T, leave the joint within its limits:
//     qdd <= min((qd_max - qd) / T, 2 (q_max - q - qd T) / T^2),   and likewise below.
// Near a limit, at speed, that demands a braking of hundreds of rad/s^2, and beyond it a retreat: together with
// contacts and torque limits often more than there is. So the bounds only forbid: they are widened to contain `rest`,
// an acceleration that is always possible, and a joint at or beyond a limit must not accelerate further that way.
inline AccelerationLimits acceleration_limits(const RobotState& state, const Vec12& rest,
                                              const WbcOptions& o) noexcept {
  const double T = o.acceleration_horizon;
  const JointLimits& limits = o.joint_limits;
  const auto q = state.q.array();
  const auto qd = state.qd.array();
  const Vec12 lower = ((-limits.velocity.array() - qd) / T).max(2.0 * (limits.lower.array() - q - qd * T) / (T * T));
  const Vec12 upper = ((limits.velocity.array() - qd) / T).min(2.0 * (limits.upper.array() - q - qd * T) / (T * T));
  return {lower.cwiseMin(rest), upper.cwiseMax(rest)};
}

}  // namespace dob
