// Super-twisting momentum observer (Garofalo, Mansfeld, Jankowski, Ott, "Sliding mode momentum observers for estimation
// of external torques and joint acceleration", 2019), component by component.
//
// Continuous form, e = p - p_hat:
//     p_hat_dot = known + d_hat + T_1 |e|^(1/2) sign(e) + T_2 e,    d_hat_dot = S_1 sign(e) + S_2 e
// with T_1 = 1.5 sqrt(R), S_1 = 1.1 R (Levant), T_2 = 2 w, S_2 = w^2. For |d_dot| <= R it finds d in finite time and
// follows it without lag; R is a bound on the disturbance's RATE, and w [rad/s] speeds up the way there from far away
// (0: the pure super-twisting algorithm).
//
// Discrete form: implicit Euler with the set-valued sign (Brogliato, Polyakov, Efimov, "The implicit discretization of
// the supertwisting sliding-mode control algorithm", 2020), whose equation is solved in closed form, with
// b = e + residual - dt d_hat:
//     |b| <= dt^2 S_1:  e = 0, d_hat += b / dt                     (sliding: sign(e) = b / (dt^2 S_1))
//     else:             (1 + dt T_2 + dt^2 S_2) |e| + dt T_1 |e|^(1/2) = |b| - dt^2 S_1,  sign(e) = sign(b)
// It does not chatter at all: once sliding, d_hat is the mean disturbance of the last interval to the last digit for as
// long as that changes by no more than dt S_1 from one tick to the next. Holds for all gains and ticks.
//
// Not linear: there is a bandwidth only at an amplitude (scaling R with it keeps the response). Small disturbances, and
// noise of up to dt S_1, pass unfiltered; large ones at high frequency come out rate-limited, as a triangle.
#pragma once

#include <cmath>

#include "observers/filter_observer.h"

namespace dob {

struct SlidingModeOptions {
  double rate = 200.0;  // [N m/s; of a force N/s] R
  double linear = 0.0;  // [rad/s] w
};

// Keys: rate (> 0), linear_rad_s (>= 0). Throws OptionError.
SlidingModeOptions read_sliding_mode_options(OptionReader& reader, const std::string& prefix);

template <int N>
class SuperTwistingFilter {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Options = SlidingModeOptions;

  static Options read(OptionReader& reader, const std::string& prefix) {
    return read_sliding_mode_options(reader, prefix);
  }
  SuperTwistingFilter(const Options& options, double /*dt*/)
      : T1_(1.5 * std::sqrt(options.rate)),
        S1_(1.1 * options.rate),
        T2_(2.0 * options.linear),
        S2_(options.linear * options.linear) {}

  void step(const Vector& residual, double dt) noexcept {
    const Vector b = e_ + residual - dt * d_hat_;
    const double sliding = dt * dt * S1_;
    const double slope = 1.0 + dt * T2_ + dt * dt * S2_;
    const double half = 0.5 * dt * T1_;
    for (int i = 0; i < N; ++i) {
      if (std::abs(b[i]) <= sliding) {
        e_[i] = 0.0;
        d_hat_[i] += b[i] / dt;
        continue;
      }
      // slope x^2 + 2 half x = beyond, x = |e|^(1/2); the form of the root in which nothing cancels
      const double beyond = std::abs(b[i]) - sliding;
      const double x = beyond / (half + std::sqrt(half * half + slope * beyond));
      e_[i] = std::copysign(x * x, b[i]);
      d_hat_[i] += dt * (std::copysign(S1_, b[i]) + S2_ * e_[i]);
    }
  }
  bool finite() const noexcept { return e_.allFinite() && d_hat_.allFinite(); }
  const Vector& estimate() const noexcept { return d_hat_; }

 private:
  double T1_, S1_, T2_, S2_;
  Vector e_ = Vector::Zero();  // [N s or N m s] p - p_hat
  Vector d_hat_ = Vector::Zero();
};

using SlidingModeObserver = LegFilterObserver<SuperTwistingFilter>;
using ComSlidingModeObserver = ComFilterObserver<SuperTwistingFilter>;

}  // namespace dob
