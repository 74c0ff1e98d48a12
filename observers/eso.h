// Linear extended-state observer on a momentum, with all poles at one bandwidth (Gao, "Scaling and bandwidth-
// parameterization based controller tuning", 2003; discrete form: Miklosovic, Radke, Gao, "Discrete implementation and
// generalization of the extended state observer", 2006).
//
// Continuous form, the disturbance d being the extended state z_2:
//     z_1_dot = known + z_2 + 2 w_o (p - z_1),    z_2_dot = w_o^2 (p - z_1),    d_hat = z_2,
// hence d_hat = w_o^2 / (s + w_o)^2 d: unit static gain, bandwidth (-3 dB) w_o sqrt(sqrt(2) - 1) = 0.6436 w_o [rad/s],
// lag 2/w_o [s]. That is the momentum observer of order 2 with K = (w_o / 2, 2 w_o): the method is the parametrisation.
//
// Discrete form, exact for a disturbance constant over a tick, both poles at b = exp(-w_o dt), with e = p - z_1:
//     nu = e + residual - dt d_hat,    e = b^2 nu,    d_hat += (1 - b)^2 / dt nu.
// It holds at every bandwidth and tick. Step response after k ticks: 1 - b^k (1 + k (1 - b)).
#pragma once

#include <cmath>

#include "observers/filter_observer.h"

namespace dob {

struct EsoOptions {
  double bandwidth = 50.0;  // [rad/s] w_o
};

// Key: bandwidth_rad_s, w_o; not the -3 dB bandwidth. Throws OptionError.
EsoOptions read_eso_options(OptionReader& reader, const std::string& prefix);

template <int N>
class EsoFilter {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Options = EsoOptions;

  static Options read(OptionReader& reader, const std::string& prefix) { return read_eso_options(reader, prefix); }
  EsoFilter(const Options& options, double /*dt*/) : bandwidth_(options.bandwidth) {}

  void step(const Vector& residual, double dt) noexcept {
    const double b = std::exp(-bandwidth_ * dt);
    const Vector nu = e_ + residual - dt * d_hat_;
    e_ = b * b * nu;
    d_hat_ += (1.0 - b) * (1.0 - b) / dt * nu;
  }
  bool finite() const noexcept { return e_.allFinite() && d_hat_.allFinite(); }
  const Vector& estimate() const noexcept { return d_hat_; }

 private:
  double bandwidth_;
  Vector e_ = Vector::Zero();  // [N s or N m s] p - z_1
  Vector d_hat_ = Vector::Zero();
};

using EsoObserver = LegFilterObserver<EsoFilter>;
using ComEsoObserver = ComFilterObserver<EsoFilter>;

}  // namespace dob
