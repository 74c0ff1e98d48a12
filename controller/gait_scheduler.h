// Foot scheduler of the trot (section 4.1): a footstep is a stance phase with all feet down, then a swing phase in
// which one diagonal pair swings. Touchdown is per leg and measured, so feet may land early or late.
#pragma once

#include "robot/types.h"

namespace dob {

struct GaitOptions {
  double stance_duration = 0.15;         // [s] all feet down, section 5.1
  double swing_duration = 0.115;         // [s] T_sw, section 5.1
  double early_touchdown_window = 0.05;  // [s] last part of a swing in which a contact counts as touchdown
  double touchdown_force = 5.0;          // [N] norm of the measured ground reaction force
  double late_wait = 0.1;                // [s] how long a lift-off waits for a late foot
};

enum class LegPhase { kStance, kSwing, kLate /* swing time is over, no ground yet: keeps descending */ };

struct GaitState {
  PerLeg<LegPhase> phase{};      // all kStance at the start
  PerLeg<double> swing_time{};   // [s] since lift-off, for legs in kSwing and kLate
  bool footstep_begins = false;  // this tick starts a new footstep: plan now
  PerLeg<bool> lift_off{};       // this leg leaves the ground at this tick
  PerLeg<bool> touchdown{};      // this leg landed at this tick
  PerLeg<bool> next_swing{};     // the pair that swings (or is about to) in the present footstep
  double footstep_time = 0.0;    // [s] since the footstep began

  bool stands(int leg) const noexcept { return phase[leg] == LegPhase::kStance; }
};

class GaitScheduler {
 public:
  // Throws std::invalid_argument naming the option, its value and what is allowed.
  explicit GaitScheduler(const GaitOptions& options);

  // Starts with a full stance phase of which `initial_footstep_time` [s] has passed; LF and RH swing first unless
  // `other_diagonal_first`.
  void reset(double initial_footstep_time = 0.0, bool other_diagonal_first = false) noexcept;

  // One tick of dt [s] with the measured foot forces [N, along W]. The first call after reset begins a footstep.
  const GaitState& update(double dt, const Vec12& foot_force) noexcept;

  const GaitState& state() const noexcept { return state_; }
  const GaitOptions& options() const noexcept { return options_; }

 private:
  void begin_footstep(double elapsed) noexcept;

  GaitOptions options_;
  GaitState state_;
  bool first_ = true;
  bool swinging_ = false;
  double swing_phase_time_ = 0.0;  // [s] since lift-off of the pair
  bool diagonal_ = false;          // which diagonal swings: false = LF + RH
  double initial_time_ = 0.0;
};

}  // namespace dob
