// Kalman filter on a momentum and the disturbance behind it (Wahrburg, Boes, Listmann, Dai, Matthias, Ding, "Motor-
// current-based estimation of Cartesian contact forces and torques for robotic manipulators and its application to
// force control", 2018), one component at a time.
//
//     p_dot = known + d + w_p,    d_dot = -decay d + w_d,    measured: p + v,
// with white noise: w_d of spectral density walk^2, w_p of process^2, v of standard deviation `noise` at each
// measurement. With decay = 0 unit static gain; else walk, noise and decay decide how much of a constant disturbance is
// found. Without process noise, decay = 0 and as dt -> 0:
//     d_hat = w^2 / (s^2 + sqrt(2) w s + w^2) d,    w = (walk / (noise sqrt(dt)))^(1/2)  [rad/s],
// a Butterworth filter whose -3 dB bandwidth is w. It is the noise per tick that is given, so w depends on the tick.
//
// Each step, with e = p - p_hat, phi = exp(-decay dt) and its integral s over the tick (dt for decay = 0):
//     nu = e + residual - s d_hat,    e = (1 - L_p) nu,    d_hat = phi d_hat + L_d nu,
// L_p, L_d from the covariance, which is carried along with the tick given (a tick that changes is handled), starting
// from its steady state at the tick of the construction: so the filter is time-invariant there, and there is no wrong
// prior to wear off. All components share one covariance, as they share their noise. Stable for any values.
//
// Limits: it is optimal for the noise as stated. A push is a step and no random walk, and the ground reaction forces'
// errors at touchdown are not white: read walk / noise as the tuning of the bandwidth.
#pragma once

#include "observers/filter_observer.h"

namespace dob {

// Units are those of a joint or a moment; of a force N in place of N m.
struct KalmanOptions {
  double walk = 0.0625;  // [N m / sqrt(s)] of the disturbance
  double process = 0.0;  // [N m sqrt(s)] of the momentum's rate: torque noise
  double noise = 1e-3;   // [N m s] of each measurement of the momentum
  double decay = 0.0;    // [rad/s]
};

// Keys: walk, process, noise, decay_rad_s; walk and noise > 0, the others >= 0. Throws OptionError.
KalmanOptions read_kalman_options(OptionReader& reader, const std::string& prefix);

// Covariance of the errors of (p_hat, d_hat), after the measurement, and the gains of the step that led there.
class KalmanCovariance {
 public:
  // At the steady state of steps of dt [s].
  KalmanCovariance(const KalmanOptions& options, double dt);

  // Prediction over dt [s] and measurement; `phi` and `s` of above are left for the state.
  void step(double dt) noexcept;

  double pp = 0.0, pd = 0.0, dd = 0.0;  // [(N m s)^2], [(N m)^2 s], [(N m)^2]
  double L_p = 0.0, L_d = 0.0;          // [-], [1/s] for one step: w^2 dt in continuous time
  double phi = 1.0, s = 0.0;            // [-], [s]

 private:
  KalmanOptions options_;
};

template <int N>
class KalmanFilter {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Options = KalmanOptions;

  static Options read(OptionReader& reader, const std::string& prefix) { return read_kalman_options(reader, prefix); }
  KalmanFilter(const Options& options, double dt) : covariance_(options, dt) {}

  void step(const Vector& residual, double dt) noexcept {
    covariance_.step(dt);
    const Vector nu = e_ + residual - covariance_.s * d_hat_;
    e_ = (1.0 - covariance_.L_p) * nu;
    d_hat_ = covariance_.phi * d_hat_ + covariance_.L_d * nu;
  }
  bool finite() const noexcept { return e_.allFinite() && d_hat_.allFinite(); }
  const Vector& estimate() const noexcept { return d_hat_; }

  // Of each component's error, as the filter believes it to be.
  const KalmanCovariance& covariance() const noexcept { return covariance_; }

 private:
  KalmanCovariance covariance_;
  Vector e_ = Vector::Zero();  // [N s or N m s] p - p_hat
  Vector d_hat_ = Vector::Zero();
};

using KalmanObserver = LegFilterObserver<KalmanFilter>;
using ComKalmanObserver = ComFilterObserver<KalmanFilter>;

}  // namespace dob
