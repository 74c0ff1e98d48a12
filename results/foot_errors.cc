#include "results/foot_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/statistics.h"

namespace dob {
namespace {

constexpr double kOnsetWindow = 0.020;  // [s]

}  // namespace

FootErrors::FootErrors(int leg, double dt, std::size_t expected_ticks)
    : leg_(static_cast<std::size_t>(leg)),
      // A tick k after lift-off is at k dt: those before 20 ms, whatever the last bit of dt.
      onset_window_(static_cast<int>(std::ceil(kOnsetWindow / dt - 1e-9))) {
  swing_.reserve(expected_ticks);
}

void FootErrors::add(const TickRecord& tick) noexcept {
  const double error = (tick.foot[leg_] - tick.foot_reference[leg_]).norm();
  if (tick.touchdown[leg_]) {
    foothold_max_ = larger(foothold_max_, (tick.foot[leg_] - tick.foothold[leg_]).norm());
  }
  if (tick.stance[leg_]) {
    in_swing_ = false;
    stance_max_ = larger(stance_max_, error);
  } else {
    add_swing(tick, error);
  }
}

void FootErrors::add_swing(const TickRecord& tick, double error) noexcept {
  if (!in_swing_ || tick.lift_off[leg_]) {
    in_swing_ = true;
    onset_swing_ = false;
    swing_ticks_ = 0;
    swing_begin_ = swing_.size();
    earlier_swings_max_ = swing_max();
    present_swing_max_.reset();
  }
  if (tick.disturbance_onset && swing_ticks_ < onset_window_ && !onset_swing_) move_present_swing_to_onset();
  ++swing_ticks_;
  if (onset_swing_) {
    onset_max_ = larger(onset_max_, error);
  } else {
    swing_.push_back(error);
    present_swing_max_ = larger(present_swing_max_, error);
  }
}

void FootErrors::move_present_swing_to_onset() noexcept {
  onset_swing_ = true;
  onset_max_ = larger(onset_max_, present_swing_max_);
  present_swing_max_.reset();
  swing_.resize(swing_begin_);
}

FootErrorSummary FootErrors::finish() const {
  return {swing_max(), p99_of(swing_), onset_max_, stance_max_, foothold_max_};
}

std::optional<double> larger(std::optional<double> a, std::optional<double> b) noexcept {
  if (!a) return b;
  if (!b) return a;
  return std::isnan(*a) || *a > *b ? a : b;
}

std::optional<double> p99_of(const std::vector<double>& samples) {
  if (samples.empty()) return std::nullopt;
  const bool finite = std::all_of(samples.begin(), samples.end(), [](double x) { return std::isfinite(x); });
  return finite ? quantile(samples, 0.99) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace dob
