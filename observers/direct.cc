#include "observers/direct.h"

#include <cmath>
#include <numbers>

#include "observers/residual.h"

namespace dob {
namespace {

constexpr std::string_view kDirect = "direct";

}  // namespace

DirectOptions read_direct_options(const ObserverOptions& options) {
  OptionReader reader(kDirect, options);
  DirectOptions result;
  result.bandwidth = reader.number("bandwidth_rad_s", result.bandwidth, kGainRange);
  reader.refuse_unknown();
  return result;
}

DirectObserver::DirectObserver(const DirectOptions& options, double dt) : c_(options.bandwidth / std::numbers::sqrt2) {
  check_tick(kDirect, dt);
}

void DirectObserver::reset(const ModelTerms& /*now*/) noexcept {
  d_hat_.setZero();
  rate_.setZero();
}

Estimate DirectObserver::update(const ObserverInput& input) noexcept {
  const double t = c_ * input.dt;
  const double cosine = std::exp(-t) * std::cos(t);
  const double sine = std::exp(-t) * std::sin(t);
  const Vec12 d = acceleration_residual(input) / input.dt;
  const Vec12 y = d_hat_ - d;
  const Vec12 next = d + (cosine + sine) * y + sine / c_ * rate_;
  const Vec12 next_rate = -2.0 * c_ * sine * y + (cosine - sine) * rate_;

  const bool valid = input.dt > 0.0 && next.allFinite() && next_rate.allFinite();
  if (valid) {
    d_hat_ = next;
    rate_ = next_rate;
  }
  return leg_estimate(d_hat_, valid);
}

}  // namespace dob
