// The direct estimate: what the equation of motion of the legs says after the accelerations are known, through a
// low-pass (a textbook method, the yardstick of what a momentum observer spares one).
//
//     d = M_q qdd + c_q - tau - J_j^T f,     qdd by the difference of qd over a tick (residual.h),
//     d_hat = w^2 / (s^2 + sqrt(2) w s + w^2) d:
// a second-order Butterworth filter, as is usual behind a differentiator; unit static gain, -3 dB bandwidth w [rad/s],
// lag sqrt(2)/w [s]. Discrete form exact for d constant over a tick, so it holds at every w and tick:
// with c = w / sqrt(2) and t = c dt, of the difference y = d_hat - d and its rate
//     y <- e^-t (cos t + sin t) y + e^-t sin t / c y',   y' <- -2 c e^-t sin t y + e^-t (cos t - sin t) y'.
//
// Limits: accuracy of first order in dt; noise of qd enters times M_q / dt, and is damped from w on with two orders.
// What it cannot see: as momentum.h.
#pragma once

#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

struct DirectOptions {
  double bandwidth = 25.0;  // [rad/s] w
};

// Key: bandwidth_rad_s. Throws OptionError.
DirectOptions read_direct_options(const ObserverOptions& options);

class DirectObserver final : public DisturbanceObserver {
 public:
  // Throws OptionError for a dt [s] that is none.
  DirectObserver(const DirectOptions& options, double dt);

  std::string_view name() const noexcept override { return "direct"; }

  // Estimate and its rate to zero.
  void reset(const ModelTerms& now) noexcept override;

  // Non-finite input, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were.
  Estimate update(const ObserverInput& input) noexcept override;

 private:
  double c_;                     // [rad/s] w / sqrt(2)
  Vec12 d_hat_ = Vec12::Zero();  // [N m]
  Vec12 rate_ = Vec12::Zero();   // [N m/s]
};

}  // namespace dob
