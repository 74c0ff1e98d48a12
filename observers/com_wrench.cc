#include "observers/com_wrench.h"

#include <cmath>

#include <fmt/format.h>

#include "observers/momentum_gains.h"

namespace dob {
namespace {

constexpr std::string_view kName = "com_wrench";
constexpr std::string_view kLinear = "linear_gain_rad_s";
constexpr std::string_view kAngular = "angular_gain_rad_s";
constexpr double kLargestGain = 1e6;  // [rad/s], far above what any tick holds

// The update is that of a momentum observer of order 1, so its stability is, too.
double checked_gain(std::string_view key, double gain, double dt) {
  const MomentumGains gains{{gain}};
  std::string reason = check_gains(gains);
  if (reason.empty()) reason = check_stability(gains, dt);
  if (reason.empty()) return gain;
  throw OptionError(kName, key, gain, reason);
}

// [m c_dot; L], about the CoM along W.
Vec6 momentum(const ModelTerms& m) noexcept {
  Vec6 p;
  p << m.mass * m.v_c.head<3>(), m.L;
  return p;
}

}  // namespace

ComWrenchOptions read_com_wrench_options(const ObserverOptions& options) {
  OptionReader reader(kName, options);
  const NumberRange allowed{.above = 0.0, .max = kLargestGain};
  ComWrenchOptions result;
  result.linear_gain = reader.number(std::string(kLinear), result.linear_gain, allowed);
  result.angular_gain = reader.number(std::string(kAngular), result.angular_gain, allowed);
  reader.refuse_unknown();
  return result;
}

ComWrenchObserver::ComWrenchObserver(const ComWrenchOptions& options, double dt) {
  if (!std::isfinite(dt) || dt <= 0.0) throw OptionError(kName, "dt", dt, "allowed is a finite tick > 0 s");
  G_.head<3>().setConstant(checked_gain(kLinear, options.linear_gain, dt));
  G_.tail<3>().setConstant(checked_gain(kAngular, options.angular_gain, dt));
}

void ComWrenchObserver::reset(const ModelTerms& /*now*/) noexcept {
  w_hat_.setZero();
}

Estimate ComWrenchObserver::update(const ObserverInput& input) noexcept {
  const double dt = input.dt;
  Vec6 known = com_wrench(input.start, input.start.contact, input.foot_force);
  known[2] -= input.start.mass * kGravity;
  const Vec6 gained = momentum(input.now) - momentum(input.start);
  const Vec6 next = w_hat_ + G_.cwiseProduct(gained - dt * (w_hat_ + known));

  const bool valid = dt > 0.0 && next.allFinite();
  if (valid) w_hat_ = next;
  Estimate estimate;
  estimate.has_com = true;
  estimate.com_wrench = w_hat_;
  estimate.status = valid ? EstimateStatus::kOk : EstimateStatus::kInvalidInput;
  return estimate;
}

// The update is that of a momentum observer of order 1.
std::optional<LinearChannel> ComWrenchObserver::linear(Channel channel) const {
  if (channel == Channel::kLegTorque) return std::nullopt;
  const MomentumGains gains{{channel == Channel::kComForce ? G_[0] : G_[3]}};
  return LinearChannel{gains, dob::largest_stable_dt(gains)};
}

}  // namespace dob
