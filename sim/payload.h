// A load that is put on the trunk while the robot walks, and that controller and observer are not told of.
#pragma once

#include "robot/types.h"

namespace dob {

// A solid ball of 50 mm radius, fixed to the trunk with its centre at p_B from start_s on. When it is put on it already
// moves with the trunk: there is no impact. It touches nothing.
struct Payload {
  double start_s = 0.0;     // [s]
  double mass = 0.0;        // [kg]
  Vec3 p_B = Vec3::Zero();  // [m] in B

  static constexpr double kRadius = 0.05;  // [m]

  // Throws std::invalid_argument naming the field, the value and what is allowed.
  void validate() const;

  bool on(double t) const noexcept;  // the window's start is met to 1 ns, as that of a force
};

}  // namespace dob
