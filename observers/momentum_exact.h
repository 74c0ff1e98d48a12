// First-order momentum observer in its exact discrete form (De Luca, Albu-Schaeffer, Haddadin, Hirzinger, "Collision
// detection and safe reaction with the DLR-III lightweight manipulator arm", 2006; Haddadin, De Luca, Albu-Schaeffer,
// "Robot collisions: a survey on detection, isolation, and identification", 2017).
//
// Continuous form: d_hat = K (p - p(0) - integral of (d_hat + known)), hence d_hat = K / (s + K) d: bandwidth K [rad/s]
// (-3 dB), lag 1/K [s], unit static gain. A disturbance that is constant over a tick is filtered exactly by
//     d_hat += (1 - a) (residual / dt - d_hat),    a = exp(-K dt),
// which holds at every gain and tick: forward Euler (momentum.h with r = 1, com_wrench.h) needs K dt < 2.
#pragma once

#include <cmath>

#include "observers/filter_observer.h"

namespace dob {

struct ExactFilterOptions {
  double gain = 25.0;  // [rad/s] K
};

// Key: gain_rad_s. Throws OptionError.
ExactFilterOptions read_exact_filter_options(OptionReader& reader, const std::string& prefix);

template <int N>
class ExactFilter {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Options = ExactFilterOptions;

  static Options read(OptionReader& reader, const std::string& prefix) {
    return read_exact_filter_options(reader, prefix);
  }
  ExactFilter(const Options& options, double /*dt*/) : gain_(options.gain) {}

  void step(const Vector& residual, double dt) noexcept {
    d_hat_ -= std::expm1(-gain_ * dt) * (residual / dt - d_hat_);
  }
  bool finite() const noexcept { return d_hat_.allFinite(); }
  const Vector& estimate() const noexcept { return d_hat_; }

 private:
  double gain_;
  Vector d_hat_ = Vector::Zero();
};

using MomentumExactObserver = LegFilterObserver<ExactFilter>;
using ComMomentumExactObserver = ComFilterObserver<ExactFilter>;

}  // namespace dob
