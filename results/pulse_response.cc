#include "results/pulse_response.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "results/foot_errors.h"

namespace dob {
namespace {

constexpr double kBlock = 0.5;   // [s]
constexpr double kWindow = 1.5;  // [s] several footsteps
constexpr double kValley = 0.5;  // of the lower peak

std::size_t ticks_of(double seconds, double dt) {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds / dt)));
}

// The highest peak on the way from the top that is apart from it; nullopt if there is none.
template <typename Iterator>
std::optional<double> peak_apart(Iterator top, Iterator end) {
  std::optional<double> highest;
  double valley = *top;
  for (Iterator at = top; at != end; ++at) {
    valley = std::min(valley, *at);
    if (*at > valley && valley <= kValley * *at) highest = larger(highest, *at);
  }
  return highest;
}

}  // namespace

PulseResponse::PulseResponse(std::optional<Leg> metric_leg, double dt)
    : metric_leg_(metric_leg), block_ticks_(ticks_of(kBlock, dt)), window_ticks_(ticks_of(kWindow, dt)) {
  com_.reserve(window_ticks_);
}

void PulseResponse::add(const TickRecord& tick) noexcept {
  advance(tick);
  if (phase_ == Phase::kOther) return;
  add_com((tick.com - tick.com_reference).norm());
  if (metric_leg_) add_foot(tick);
}

void PulseResponse::advance(const TickRecord& tick) noexcept {
  switch (phase_) {
    case Phase::kBefore:
      if (tick.disturbance_active) phase_ = Phase::kActing;
      return;
    case Phase::kActing:
      if (!tick.disturbance_active) {
        phase_ = Phase::kAfter;
      } else if (tick.disturbance_onset) {
        phase_ = Phase::kOther;  // a new draw, or a second disturbance
      }
      return;
    case Phase::kAfter:
      if (tick.disturbance_active) phase_ = Phase::kOther;
      return;
    case Phase::kOther:
      return;
  }
}

void PulseResponse::add_com(double error) noexcept {
  if (phase_ != Phase::kBefore) {
    if (com_.size() < window_ticks_) com_.push_back(error);
    return;
  }
  if (ticks_ == block_ticks_) {
    last_block_ = block_;
    block_.reset();
    ticks_ = 0;
  }
  block_ = larger(block_, error);
  ++ticks_;
}

void PulseResponse::add_foot(const TickRecord& tick) noexcept {
  const auto leg = static_cast<std::size_t>(*metric_leg_);
  if (tick.stance[leg]) return;
  const double error = (tick.foot[leg] - tick.foot_reference[leg]).norm();
  std::optional<double>& peak = phase_ == Phase::kActing ? peaks_.foot_push : peaks_.foot_rest;
  peak = larger(peak, error);
}

PulsePeaks PulseResponse::finish() const noexcept {
  if (phase_ != Phase::kAfter) return {};
  PulsePeaks peaks = peaks_;
  peaks.com_before = larger(last_block_, block_);
  const auto broken = std::find_if(com_.begin(), com_.end(), [](double x) { return !std::isfinite(x); });
  if (broken != com_.end()) {
    peaks.com_first = peaks.com_second = *broken;
    return peaks;
  }
  const auto top = std::max_element(com_.begin(), com_.end());
  const std::optional<double> earlier = peak_apart(std::make_reverse_iterator(top + 1), com_.rend());
  const std::optional<double> later = peak_apart(top, com_.end());
  const bool top_is_second = earlier && (!later || *earlier > *later);
  peaks.com_first = top_is_second ? earlier : std::optional(*top);
  peaks.com_second = top_is_second ? std::optional(*top) : later;
  return peaks;
}

}  // namespace dob
