// Random robot states for property tests: any attitude, joints within +-1.5 rad, speeds well above walking. (Braces, as
// their elements are drawn from left to right; arguments are in any order.)
#pragma once

#include <random>

#include <Eigen/Geometry>

#include "robot/types.h"

namespace dob::test {

inline RobotState random_state(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::normal_distribution<double> normal;
  const auto vec = [&](double scale) { return Vec3(scale * Vec3{uniform(random), uniform(random), uniform(random)}); };
  RobotState state;
  state.p_WB = vec(2.0);
  const Eigen::Quaterniond quat{normal(random), normal(random), normal(random), normal(random)};
  state.R_WB = quat.normalized().toRotationMatrix();
  state.v_WB = vec(1.0);
  state.omega_WB = vec(2.0);
  for (int i = 0; i < kJoints; ++i) {
    state.q[i] = 1.5 * uniform(random);
    state.qd[i] = 5.0 * uniform(random);
  }
  return state;
}

}  // namespace dob::test
