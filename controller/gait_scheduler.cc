#include "controller/gait_scheduler.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kTimeTolerance = 1e-9;  // [s] phase ends fall on ticks; rounding must not shift them by one

void require(bool ok, const char* name, double value, const char* allowed) {
  if (!ok || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("gait: {} = {}; allowed: {}", name, value, allowed));
  }
}

}  // namespace

GaitScheduler::GaitScheduler(const GaitOptions& o) : options_(o) {
  require(o.stance_duration > 0.0, "stance_s", o.stance_duration, "> 0");
  require(o.swing_duration > 0.0, "swing_s", o.swing_duration, "> 0");
  require(o.early_touchdown_window >= 0.0 && o.early_touchdown_window <= o.swing_duration, "early_touchdown_window_s",
          o.early_touchdown_window, "0 to swing_s");
  require(o.touchdown_force > 0.0, "touchdown_force_N", o.touchdown_force, "> 0");
  require(o.late_wait >= 0.0, "late_wait_s", o.late_wait, ">= 0");
  reset();
}

void GaitScheduler::reset(double initial_footstep_time, bool other_diagonal_first) noexcept {
  state_ = GaitState{};
  first_ = true;
  swinging_ = false;
  diagonal_ = !other_diagonal_first;  // begin_footstep flips it
  initial_time_ = std::clamp(initial_footstep_time, 0.0, options_.stance_duration);
}

void GaitScheduler::begin_footstep(double elapsed) noexcept {
  diagonal_ = !diagonal_;
  swinging_ = false;
  state_.footstep_begins = true;
  state_.footstep_time = elapsed;
  const bool lf_rh = !diagonal_;
  state_.next_swing = {lf_rh, !lf_rh, !lf_rh, lf_rh};
}

const GaitState& GaitScheduler::update(double dt, const Vec12& foot_force) noexcept {
  GaitState& s = state_;
  s.footstep_begins = false;
  s.lift_off.fill(false);
  s.touchdown.fill(false);
  if (first_) {
    first_ = false;
    begin_footstep(initial_time_);
    return s;
  }
  s.footstep_time += dt;
  bool any_late = false;
  for (int l = 0; l < kLegs; ++l) {
    if (s.stands(l)) continue;
    s.swing_time[l] += dt;
    const double remaining = options_.swing_duration - s.swing_time[l];
    const bool contact = foot_force.segment<3>(3 * l).norm() > options_.touchdown_force;
    if (contact && remaining <= options_.early_touchdown_window + kTimeTolerance) {
      s.phase[l] = LegPhase::kStance;
      s.touchdown[l] = true;
    } else if (remaining <= kTimeTolerance) {
      s.phase[l] = LegPhase::kLate;
      any_late = true;
    }
  }
  if (swinging_) {
    swing_phase_time_ += dt;
    if (swing_phase_time_ >= options_.swing_duration - kTimeTolerance) begin_footstep(0.0);
    return s;
  }
  const bool due = s.footstep_time >= options_.stance_duration - kTimeTolerance;
  const bool waited = s.footstep_time >= options_.stance_duration + options_.late_wait - kTimeTolerance;
  if (due && (!any_late || waited)) {
    swinging_ = true;
    swing_phase_time_ = 0.0;
    for (int l = 0; l < kLegs; ++l) {
      if (!s.next_swing[l]) continue;
      s.phase[l] = LegPhase::kSwing;
      s.swing_time[l] = 0.0;
      s.lift_off[l] = true;
    }
  }
  return s;
}

}  // namespace dob
