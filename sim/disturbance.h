// External forces as pure functions of time; any number of them act together.
#pragma once

#include <limits>
#include <optional>

#include "robot/types.h"
#include "sim/applied_force.h"

namespace dob {

// Signed magnitude over time [N]; zero outside the window [start_s, start_s + duration_s).
struct ForceProfile {
  enum class Kind {
    kConstant,  // amplitude: a step with an endless window, a pulse with a finite one
    kSine,      // amplitude sin(2 pi (t - start) / period + phase)
    kRamp,      // from 0 to the amplitude over ramp, then held
    kChirp,     // amplitude sin(2 pi integral of f + phase); f goes linearly from f0 to f1 over the (finite) window
  };
  Kind kind = Kind::kConstant;
  double amplitude_N = 0.0;                                     // [N]
  double period_s = 1.0;                                        // [s] of the sine
  double phase_rad = 0.0;                                       // [rad] of the sine and the chirp
  double ramp_s = 1.0;                                          // [s] of the ramp, at most the duration
  double f0_Hz = 0.0;                                           // [Hz] of the chirp at the start
  double f1_Hz = 0.0;                                           // [Hz] of the chirp at the end
  double start_s = 0.0;                                         // [s]
  double duration_s = std::numeric_limits<double>::infinity();  // [s] may be infinite

  // The window's ends are met to 1 ns: a time k dt that is rounded to just before start_s is inside, so that
  // a pulse lasts a whole number of steps.
  double value(double t) const noexcept;  // [N]
  bool active(double t) const noexcept;   // t is inside the window
};

// A moment of the gait: a leg's swing passes this share of its planned duration. Shares near the end of a swing are
// missed by the swings that land before.
struct SwingTrigger {
  Leg leg = Leg::kLF;
  double phase = 0.0;  // [-] 0 (lift-off) to below 1
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
  // With a trigger the window opens when that moment comes, profile.start_s being the earliest time; a
  // DisturbanceSchedule then puts the moment into profile.start_s.
  std::optional<SwingTrigger> trigger = std::nullopt;

  // Throws std::invalid_argument naming the field, the value and what is allowed.
  void validate() const;

  // The force at time t [s]; of the state only R_WB matters, and only for Frame::kBase.
  AppliedForce at(double t, const RobotState& state) const noexcept;
};

}  // namespace dob
