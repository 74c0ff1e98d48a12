#include "observers/momentum.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr std::string_view kMomentum = "momentum";

MomentumGains checked_gains(const MomentumOptions& options, double dt) {
  if (!std::isfinite(dt) || dt <= 0.0) throw OptionError(kMomentum, "dt", dt, "allowed is a finite tick > 0 s");
  MomentumGains gains = scale(options.gains, options.gain_scale);
  std::string reason = check_gains(gains);
  if (reason.empty() && !options.allow_unstable) {
    reason = check_stability(gains, dt);
    if (!reason.empty()) reason += "; allowed are stable gains, or any with allow_unstable=true";
  }
  if (reason.empty()) return gains;
  if (options.gain_scale != 1.0) reason = fmt::format("with gain_scale = {} {}", options.gain_scale, reason);
  throw OptionError(kMomentum, "gains", options.gains.K, reason);
}

}  // namespace

MomentumObserver::MomentumObserver(const MomentumOptions& options, double dt) : coriolis_(options.coriolis) {
  const MomentumGains gains = checked_gains(options, dt);
  order_ = static_cast<int>(gains.K.size());
  std::copy(gains.K.begin(), gains.K.end(), K_.begin());
  gamma_.fill(Vec12::Zero());
}

void MomentumObserver::reset(const ModelTerms& /*now*/) noexcept {
  gamma_.fill(Vec12::Zero());
}

Estimate MomentumObserver::update(const ObserverInput& input) noexcept {
  const double dt = input.dt;
  const Vec12 F_hat = gamma_[order_ - 1];

  // (8) at the start of the interval, with the ground reaction forces of all feet
  Vec12 alpha = input.joint_torque + joint_torques(input.start, input.start.contact, input.foot_force);
  if (coriolis_ == Coriolis::kExact) alpha += input.start.CqT_qd;

  State next = gamma_;
  next[0] += K_[0] * (input.now.rho - input.start.rho - dt * (F_hat + alpha));     // (6)
  for (int i = 1; i < order_; ++i) next[i] += dt * K_[i] * (next[i - 1] - F_hat);  // (7)

  // Whatever is not finite in the input or in any gamma_i has reached the last gamma.
  const bool valid = dt > 0.0 && next[order_ - 1].allFinite();
  if (valid) gamma_ = next;
  Estimate estimate;
  estimate.has_legs = true;
  estimate.leg_torque = gamma_[order_ - 1];
  estimate.status = valid ? EstimateStatus::kOk : EstimateStatus::kInvalidInput;
  return estimate;
}

std::optional<LinearChannel> MomentumObserver::linear(Channel channel) const {
  if (channel != Channel::kLegTorque) return std::nullopt;
  const MomentumGains gains{{K_.begin(), K_.begin() + order_}};
  return LinearChannel{gains, dob::largest_stable_dt(gains)};
}

}  // namespace dob
