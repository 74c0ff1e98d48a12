#include "observers/com_wrench.h"

#include <fmt/format.h>

#include "observers/momentum_gains.h"
#include "observers/residual.h"

namespace dob {
namespace {

constexpr std::string_view kName = "com_wrench";
constexpr std::string_view kLinear = "linear_gain_rad_s";
constexpr std::string_view kAngular = "angular_gain_rad_s";

// The update is that of a momentum observer of order 1, so its stability is, too.
double checked_gain(std::string_view key, double gain, double dt) {
  const MomentumGains gains{{gain}};
  std::string reason = check_gains(gains);
  if (reason.empty()) reason = check_stability(gains, dt);
  if (reason.empty()) return gain;
  throw OptionError(kName, key, gain, reason);
}

}  // namespace

ComWrenchOptions read_com_wrench_options(const ObserverOptions& options) {
  OptionReader reader(kName, options);
  ComWrenchOptions result;
  result.linear_gain = reader.number(std::string(kLinear), result.linear_gain, kGainRange);
  result.angular_gain = reader.number(std::string(kAngular), result.angular_gain, kGainRange);
  reader.refuse_unknown();
  return result;
}

ComWrenchObserver::ComWrenchObserver(const ComWrenchOptions& options, double dt) {
  check_tick(kName, dt);
  G_.head<3>().setConstant(checked_gain(kLinear, options.linear_gain, dt));
  G_.tail<3>().setConstant(checked_gain(kAngular, options.angular_gain, dt));
}

void ComWrenchObserver::reset(const ModelTerms& /*now*/) noexcept {
  w_hat_.setZero();
}

Estimate ComWrenchObserver::update(const ObserverInput& input) noexcept {
  const double dt = input.dt;
  const Vec6 gained = com_momentum(input.now) - com_momentum(input.start);
  const Vec6 next = w_hat_ + G_.cwiseProduct(gained - dt * (w_hat_ + known_com_wrench(input)));

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
