// External forces as pure functions of time; any number of them act together.
#pragma once

#include <limits>

#include "robot/types.h"
#include "sim/applied_force.h"

namespace dob {

// Signed magnitude over time [N]; zero outside the window [start_s, start_s + duration_s).
struct ForceProfile {
  enum class Kind {
    kConstant,  // amplitude: a step with an endless window, a pulse with a finite one
    kSine,      // amplitude sin(2 pi (t - start) / period + phase)
  };
  Kind kind = Kind::kConstant;
  double amplitude_N = 0.0;                                     // [N]
  double period_s = 1.0;                                        // [s] of the sine
  double phase_rad = 0.0;                                       // [rad] of the sine
  double start_s = 0.0;                                         // [s]
  double duration_s = std::numeric_limits<double>::infinity();  // [s] may be infinite

  // The window's ends are met to 1 ns: a time k dt that is rounded to just before start_s is inside, so that
  // a pulse lasts a whole number of steps.
  double value(double t) const noexcept;  // [N]
  bool active(double t) const noexcept;   // t is inside the window
};

// A force on a point of the robot. The case studies' lists of pushes are lists of these.
struct Disturbance {
  enum class Frame { kWorld, kBase };

  ForceProfile profile;
  int leg = AppliedForce::kTrunk;  // index of a Leg, or kTrunk
  LegLink link = LegLink::kLower;  // ignored for the trunk
  Vec3 p_L = Vec3::Zero();         // [m] point, in the frame of the link
  Vec3 direction = Vec3::UnitX();  // unit vector
  Frame frame = Frame::kWorld;     // axes in which the direction is given: W, or B (turns with the trunk)

  // Throws std::invalid_argument naming the field, the value and what is allowed.
  void validate() const;

  // The force at time t [s]; of the state only R_WB matters, and only for Frame::kBase.
  AppliedForce at(double t, const RobotState& state) const noexcept;
};

}  // namespace dob
