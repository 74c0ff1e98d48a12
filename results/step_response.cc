#include "results/step_response.h"

#include <algorithm>
#include <cmath>

#include "results/foot_errors.h"

namespace dob {
namespace {

constexpr double kBand = 0.05;  // of the true force
constexpr double kSame = 1e-9;  // relative: the force has not changed

}  // namespace

void StepResponse::add(const TickRecord& tick) noexcept {
  if (other_) return;
  if (!tick.has_force_estimate) {
    other_ = ticks_ > 0;  // it has ended, or another one has joined it
    return;
  }
  if (ticks_ == 0) force_ = tick.force_true;
  if ((tick.force_true - force_).norm() > kSame * force_.norm()) {
    other_ = true;
    return;
  }
  ++ticks_;
  const double excess = tick.force_estimate.dot(force_) / force_.squaredNorm() - 1.0;
  excess_ = larger(excess_, std::isnan(excess) ? excess : std::max(excess, 0.0));
  if (!(std::abs(excess) <= kBand)) last_outside_ = ticks_;
}

std::optional<double> StepResponse::overshoot() const noexcept {
  return other_ ? std::nullopt : excess_;
}

std::optional<double> StepResponse::settling_s() const noexcept {
  if (other_ || ticks_ == 0 || last_outside_ == ticks_) return std::nullopt;
  return static_cast<double>(last_outside_ + 1) * dt_;
}

}  // namespace dob
