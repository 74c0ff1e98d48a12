#include "controller/gait_scheduler.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kTimeTolerance = 1e-9;  // [s] phase ends fall on ticks; rounding must not shift them by one

void require(bool ok, std::string_view name, double value, std::string_view allowed) {
  if (!ok || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("gait: {} = {}; allowed: {}", name, value, allowed));
  }
}

void require_valid(const GaitPattern& p) {
  require(p.stance_duration > 0.0, "stance_s", p.stance_duration, "> 0");
  require(p.swing_duration > 0.0, "swing_s", p.swing_duration, "> 0");
}

constexpr PerLeg<bool> only(Leg a, Leg b) noexcept {
  PerLeg<bool> legs{};
  legs[static_cast<std::size_t>(a)] = true;
  legs[static_cast<std::size_t>(b)] = true;
  return legs;
}

}  // namespace

int footsteps_per_cycle(Gait gait) noexcept {
  switch (gait) {
    case Gait::kStand:
      return 1;
    case Gait::kTrot:
      return 2;
    case Gait::kCrawl:
      return 4;
  }
  return 1;
}

PerLeg<bool> swing_legs(Gait gait, int step) noexcept {
  constexpr std::array kTrot{only(Leg::kLF, Leg::kRH), only(Leg::kRF, Leg::kLH)};
  constexpr std::array kCrawl{only(Leg::kLH, Leg::kLH), only(Leg::kLF, Leg::kLF), only(Leg::kRH, Leg::kRH),
                              only(Leg::kRF, Leg::kRF)};
  const auto i = static_cast<std::size_t>(step % footsteps_per_cycle(gait));
  switch (gait) {
    case Gait::kStand:
      return {};
    case Gait::kTrot:
      return kTrot[i];
    case Gait::kCrawl:
      return kCrawl[i];
  }
  return {};
}

GaitScheduler::GaitScheduler(const GaitOptions& o) : options_(o) {
  require_valid(o.pattern);
  double shortest = o.pattern.swing_duration;
  double before = 0.0;
  for (const GaitSwitch& s : o.switches) {
    require_valid(s.pattern);
    require(s.time >= before, "switch at_s", s.time, ">= 0 and not before the previous switch");
    before = s.time;
    shortest = std::min(shortest, s.pattern.swing_duration);
  }
  require(o.early_touchdown_window >= 0.0 && o.early_touchdown_window <= shortest, "early_touchdown_window_s",
          o.early_touchdown_window, "0 to swing_s");
  require(o.touchdown_force > 0.0, "touchdown_force_N", o.touchdown_force, "> 0");
  require(o.late_wait >= 0.0, "late_wait_s", o.late_wait, ">= 0");
  reset();
}

void GaitScheduler::reset(double initial_footstep_time, int first_step) noexcept {
  state_ = GaitState{};
  state_.pattern = options_.pattern;
  first_ = true;
  swinging_ = false;
  time_ = 0.0;
  next_switch_ = 0;
  first_step_ = first_step;
  initial_time_ = std::clamp(initial_footstep_time, 0.0, options_.pattern.stance_duration);
}

void GaitScheduler::begin_footstep(int step, double elapsed) noexcept {
  swinging_ = false;
  state_.step = step % footsteps_per_cycle(state_.pattern.gait);
  state_.footstep_begins = true;
  state_.footstep_time = elapsed;
  state_.next_swing = swing_legs(state_.pattern.gait, state_.step);
}

// Moves the legs in the air on, detects touchdown; true if one of them is late.
bool GaitScheduler::advance_swings(double dt, const Vec12& foot_force) noexcept {
  GaitState& s = state_;
  bool any_late = false;
  for (int l = 0; l < kLegs; ++l) {
    if (s.stands(l)) continue;
    s.swing_time[l] += dt;
    const double remaining = s.pattern.swing_duration - s.swing_time[l];
    const bool contact = foot_force.segment<3>(3 * l).norm() > options_.touchdown_force;
    if (contact && remaining <= options_.early_touchdown_window + kTimeTolerance) {
      s.phase[l] = LegPhase::kStance;
      s.touchdown[l] = true;
    } else if (remaining <= kTimeTolerance) {
      s.phase[l] = LegPhase::kLate;
      any_late = true;
    }
  }
  return any_late;
}

// At a full stance, when a switch is due: the new gait begins with its first footstep.
bool GaitScheduler::switch_gait() noexcept {
  bool switched = false;
  while (next_switch_ < options_.switches.size() && time_ >= options_.switches[next_switch_].time - kTimeTolerance) {
    state_.pattern = options_.switches[next_switch_++].pattern;
    switched = true;
  }
  if (switched) begin_footstep(0, 0.0);
  return switched;
}

void GaitScheduler::lift_off() noexcept {
  swinging_ = true;
  swing_phase_time_ = 0.0;
  for (int l = 0; l < kLegs; ++l) {
    if (!state_.next_swing[l]) continue;
    state_.phase[l] = LegPhase::kSwing;
    state_.swing_time[l] = 0.0;
    state_.lift_off[l] = true;
  }
}

const GaitState& GaitScheduler::update(double dt, const Vec12& foot_force, bool balanced) noexcept {
  GaitState& s = state_;
  s.footstep_begins = false;
  s.lift_off.fill(false);
  s.touchdown.fill(false);
  if (first_) {
    first_ = false;
    begin_footstep(first_step_, initial_time_);
    return s;
  }
  time_ += dt;
  s.footstep_time += dt;
  const bool any_late = advance_swings(dt, foot_force);
  if (swinging_) {
    swing_phase_time_ += dt;
    if (swing_phase_time_ >= s.pattern.swing_duration - kTimeTolerance) begin_footstep(s.step + 1, 0.0);
    return s;
  }
  if (!any_late && switch_gait()) return s;
  if (s.pattern.gait == Gait::kStand) return s;
  const bool due = s.footstep_time >= s.pattern.stance_duration - kTimeTolerance;
  const bool waited = s.footstep_time >= s.pattern.stance_duration + options_.late_wait - kTimeTolerance;
  if (due && ((!any_late && balanced) || waited)) lift_off();
  return s;
}

}  // namespace dob
