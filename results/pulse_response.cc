#include "results/pulse_response.h"

#include <cmath>

#include "results/foot_errors.h"

namespace dob {
namespace {

constexpr double kBlock = 0.5;     // [s]
constexpr double kRecovery = 1.0;  // [s]

std::optional<double> smaller(std::optional<double> a, double b) noexcept {
  return !a || b < *a ? b : *a;
}

}  // namespace

PulseResponse::PulseResponse(std::optional<Leg> metric_leg, double dt)
    : metric_leg_(metric_leg), block_ticks_(std::lround(kBlock / dt)), recovery_ticks_(std::lround(kRecovery / dt)) {}

void PulseResponse::add(const TickRecord& tick) noexcept {
  advance(tick);
  if (phase_ == Phase::kOther) return;
  add_com((tick.com - tick.com_reference).norm());
  if (metric_leg_) add_foot(tick);
}

void PulseResponse::advance(const TickRecord& tick) noexcept {
  switch (phase_) {
    case Phase::kBefore:
      if (!tick.disturbance_active) return;
      phase_ = Phase::kActing;
      peaks_.com_before = larger(last_block_, block_);
      return;
    case Phase::kActing:
      if (!tick.disturbance_active) {
        phase_ = Phase::kAfter;
        ticks_ = 0;
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
  if (phase_ == Phase::kBefore) {
    if (ticks_ == block_ticks_) {
      last_block_ = block_;
      block_.reset();
      ticks_ = 0;
    }
    block_ = larger(block_, error);
    ++ticks_;
    return;
  }
  if (phase_ == Phase::kAfter && ticks_++ >= recovery_ticks_) return;
  since_peak_ = smaller(since_peak_, error);
  std::optional<double>& peak = phase_ == Phase::kActing ? peaks_.com_push : peaks_.com_recovery;
  if (peak && error <= *peak) return;
  peak = larger(peak, error);
  if (phase_ == Phase::kAfter) {
    peaks_.com_valley = since_peak_;  // it may still get deeper for a later, larger peak
  } else {
    since_peak_ = error;
  }
}

void PulseResponse::add_foot(const TickRecord& tick) noexcept {
  const auto leg = static_cast<std::size_t>(*metric_leg_);
  if (tick.stance[leg]) return;
  const double error = (tick.foot[leg] - tick.foot_reference[leg]).norm();
  std::optional<double>& peak = phase_ == Phase::kActing ? peaks_.foot_push : peaks_.foot_rest;
  peak = larger(peak, error);
}

PulsePeaks PulseResponse::finish() const noexcept {
  const bool pulse = phase_ == Phase::kAfter;
  return pulse ? peaks_ : PulsePeaks{};
}

}  // namespace dob
