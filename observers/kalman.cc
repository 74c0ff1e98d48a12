#include "observers/kalman.h"

#include <cmath>

namespace dob {

KalmanOptions read_kalman_options(OptionReader& reader, const std::string& prefix) {
  const NumberRange positive{.above = 0.0, .max = 1e9};
  const NumberRange not_negative{.max = 1e9, .min = 0.0};
  KalmanOptions options;
  options.walk = reader.number(prefix + "walk", options.walk, positive);
  options.process = reader.number(prefix + "process", options.process, not_negative);
  options.noise = reader.number(prefix + "noise", options.noise, positive);
  options.decay = reader.number(prefix + "decay_rad_s", options.decay, not_negative);
  return options;
}

KalmanCovariance::KalmanCovariance(const KalmanOptions& options, double dt)
    : pp(options.noise * options.noise), options_(options) {
  constexpr int kMost = 1'000'000;
  constexpr double kSettled = 1e-14;  // relative change per step
  for (int i = 0; i < kMost; ++i) {
    const double before_p = L_p;
    const double before_d = L_d;
    step(dt);
    if (std::abs(L_p - before_p) <= kSettled * L_p && std::abs(L_d - before_d) <= kSettled * L_d) break;
  }
}

void KalmanCovariance::step(double dt) noexcept {
  phi = std::exp(-options_.decay * dt);
  s = options_.decay > 0.0 ? -std::expm1(-options_.decay * dt) / options_.decay : dt;
  // Noise over the tick, of an undamped walk: decay dt is small, or the walk does not matter.
  const double q = options_.walk * options_.walk * dt;
  const double pp_next = pp + 2.0 * s * pd + s * s * dd + q * dt * dt / 3.0 + options_.process * options_.process * dt;
  const double pd_next = phi * (pd + s * dd) + 0.5 * q * dt;
  const double dd_next = phi * phi * dd + q;
  const double innovation = pp_next + options_.noise * options_.noise;
  L_p = pp_next / innovation;
  L_d = pd_next / innovation;
  pp = (1.0 - L_p) * pp_next;
  pd = (1.0 - L_p) * pd_next;
  dd = dd_next - L_d * pd_next;
}

}  // namespace dob
