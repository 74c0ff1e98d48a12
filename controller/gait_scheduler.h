// Foot scheduler (section 4.1): stand, trot and crawl. A footstep is a stance phase with all feet down, then a swing
// phase in which one set of legs swings. Touchdown is per leg and measured, so feet may land early or late. The gait
// changes only while all feet stand.
#pragma once

#include <string_view>
#include <vector>

#include "robot/types.h"

namespace dob {

enum class Gait {
  kStand,  // all feet stay down
  kTrot,   // the diagonals swing in turn: LF + RH, RF + LH
  kCrawl,  // one foot at a time: LH, LF, RH, RF
};

constexpr std::string_view to_string(Gait gait) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"stand", "trot", "crawl"};
  return kNames[static_cast<std::size_t>(gait)];
}

// Footsteps after which a gait repeats itself, and the legs that swing in footstep number `step` (any integer >= 0).
int footsteps_per_cycle(Gait gait) noexcept;
PerLeg<bool> swing_legs(Gait gait, int step) noexcept;

struct GaitPattern {
  Gait gait = Gait::kTrot;
  double stance_duration = 0.15;  // [s] all feet down, section 5.1; > 0
  double swing_duration = 0.115;  // [s] T_sw, section 5.1; > 0

  double footstep_duration() const noexcept { return stance_duration + swing_duration; }     // [s]
  double cycle() const noexcept { return footsteps_per_cycle(gait) * footstep_duration(); }  // [s]
  double support_duration() const noexcept { return cycle() - swing_duration; }  // [s] of one foot on the ground
};

struct GaitSwitch {
  double time = 0.0;  // [s] the first full stance at or after it starts the new gait
  GaitPattern pattern;
};

struct GaitOptions {
  GaitPattern pattern;                   // at the start
  std::vector<GaitSwitch> switches;      // in the order of time
  double early_touchdown_window = 0.05;  // [s] last part of a swing in which a contact counts as touchdown
  double touchdown_force = 5.0;          // [N] norm of the measured ground reaction force
  double late_wait = 0.1;                // [s] how long a lift-off waits for a late foot or for balance
};

enum class LegPhase { kStance, kSwing, kLate /* swing time is over, no ground yet: keeps descending */ };

struct GaitState {
  GaitPattern pattern;           // of the present footstep
  int step = 0;                  // number of the present footstep in the gait's cycle
  PerLeg<LegPhase> phase{};      // all kStance at the start
  PerLeg<double> swing_time{};   // [s] since lift-off, for legs in kSwing and kLate
  bool footstep_begins = false;  // this tick starts a new footstep: plan now
  PerLeg<bool> lift_off{};       // this leg leaves the ground at this tick
  PerLeg<bool> touchdown{};      // this leg landed at this tick
  PerLeg<bool> next_swing{};     // the legs that swing (or are about to) in the present footstep
  double footstep_time = 0.0;    // [s] since the footstep began

  // Leg by its index (LF, RF, LH, RH) in stance; any leg leaving the ground at this tick.
  bool stands(int leg) const noexcept { return phase[leg] == LegPhase::kStance; }
  bool lifts_off() const noexcept { return lift_off[0] || lift_off[1] || lift_off[2] || lift_off[3]; }
};

class GaitScheduler {
 public:
  // Throws std::invalid_argument naming the option, its value and what is allowed.
  explicit GaitScheduler(const GaitOptions& options);

  // Starts with a full stance phase of which `initial_footstep_time` [s] has passed, at footstep `first_step` of the
  // gait's cycle.
  void reset(double initial_footstep_time = 0.0, int first_step = 0) noexcept;

  // One tick of dt [s] with the measured foot forces [N, along W]. `balanced`: the CoM is where the feet that stay
  // can carry it; a lift-off waits for that as it does for a late foot. The first call after reset begins a footstep.
  const GaitState& update(double dt, const Vec12& foot_force, bool balanced = true) noexcept;

  // As of the last update() or reset().
  const GaitState& state() const noexcept { return state_; }
  const GaitOptions& options() const noexcept { return options_; }

 private:
  void begin_footstep(int step, double elapsed) noexcept;
  bool advance_swings(double dt, const Vec12& foot_force) noexcept;
  bool switch_gait() noexcept;
  void lift_off() noexcept;

  GaitOptions options_;
  GaitState state_;
  bool first_ = true;
  bool swinging_ = false;
  double swing_phase_time_ = 0.0;  // [s] since the lift-off of the present footstep
  double time_ = 0.0;              // [s] since reset
  std::size_t next_switch_ = 0;
  double initial_time_ = 0.0;
  int first_step_ = 0;
};

}  // namespace dob
