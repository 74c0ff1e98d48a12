// Reference of one swinging foot (section 4.1.2): the height by two cubics of T_sw / 2 each, one that lifts the foot
// by the step height and one that lowers it; the horizontal motion by one cubic at rest at both ends. A foot that
// finds no ground in time goes on descending at a constant speed.
#pragma once

#include "controller/cubic.h"
#include "robot/types.h"

namespace dob {

struct SwingOptions {
  double step_height = 0.05;      // [m] above the higher of lift-off and landing, section 5.1
  double landing_offset = 0.008;  // [m] landing target BELOW the expected ground: zero gives late touchdowns
  double descent_speed = 0.15;    // [m/s] of a late foot
};

class SwingTrajectory {
 public:
  // Positions are those of the foot's sphere centre in W [m]; `landing` is on the expected ground.
  void plan(const Vec3& lift_off, const Vec3& landing, double duration, const SwingOptions& options) noexcept;

  // State at `t` [s] since lift-off; t > duration is the late descent.
  Motion<Vec3> at(double t) const noexcept;

  const Vec3& landing() const noexcept { return landing_; }  // without the landing offset

 private:
  Vec3 start_ = Vec3::Zero();
  Vec3 landing_ = Vec3::Zero();
  double duration_ = 1.0;
  double apex_ = 0.0;
  double target_z_ = 0.0;
  double descent_speed_ = 0.0;
};

}  // namespace dob
