// Nonlinear disturbance observer on the legs' dynamics, not on their momentum: the paper's baseline [24] (Dini, Majd,
// "Sliding-mode tracking control of a walking quadruped robot with a push recovery algorithm using a nonlinear
// disturbance observer as a virtual force sensor", 2019; the observer itself: Chen, Ballance, Gawthrop, O'Reilly,
// "A nonlinear disturbance observer for robotic manipulators", 2000).
//
// On the last twelve rows of (1), M_q qdd + c_q = tau + J_j^T f + d:
//     z_dot = -L z + L (c_q - tau - J_j^T f - p),   d_hat = z + p(qd),   L = X M_q^-1,   p = X qd,
// so that, X taken as constant over a tick, d_hat_dot = L (d - d_hat). The paper says X = 10 I_12 without a unit, and
// there are two readings:
//     "bandwidth" (default): X = x M_q, L = x I. x [rad/s] is then the -3 dB bandwidth of every joint, whatever the
//         posture. With M_q put back under the derivative this would be the first-order momentum observer, and at equal
//         bandwidth it differs from that by terms of first order in the tick only.
//     "literal": X = x I, L = x M_q^-1, x in [kg m^2/s]. The bandwidth is a matrix, x times the eigenvalues of M_q^-1:
//         with x = 10 near 100 rad/s at the hips and beyond 1000 rad/s at the knees, and other in every posture. It
//         mixes the joints on the way to d, though not at rest.
//
// Discrete form, with the residual of the acceleration (residual.h; c_q, M_q at t - dt):
//     bandwidth:  d_hat += (1 - exp(-x dt)) (residual / dt - d_hat)       exact for d constant over a tick
//     literal:    d_hat += x (M_q + x dt I)^-1 (residual - dt d_hat)      implicit Euler of d_hat_dot = L (d - d_hat)
// Explicit Euler of the literal reading needs x dt < 2 times the smallest eigenvalue of M_q, which depends on the
// posture, so that no check at construction could promise it, and beyond which it chatters. The implicit form has its
// poles at 1 / (1 + dt eig(L)), inside (0, 1) for every positive definite M_q: nothing has to be checked or refused.
// In both readings d_hat is what z + p would be, but without an anchor p(0): it may start in motion.
//
// Accuracy: first order in dt. Differences of qd pass their noise times M_q / dt into the residual, as differences of
// the momentum do. What it cannot see: as momentum.h.
#pragma once

#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

struct NonlinearDobOptions {
  enum class Reading { kBandwidth, kLiteral };
  Reading reading = Reading::kBandwidth;
  double X = 10.0;  // [rad/s] or [kg m^2/s], by the reading; case study 2
};

// Keys: reading ("bandwidth" | "literal"), X. Throws OptionError.
NonlinearDobOptions read_nonlinear_dob_options(const ObserverOptions& options);

class NonlinearDobObserver final : public DisturbanceObserver {
 public:
  // Throws OptionError for a dt [s] that is none; all gains hold at all ticks.
  NonlinearDobObserver(const NonlinearDobOptions& options, double dt);

  std::string_view name() const noexcept override { return "nonlinear_dob"; }

  // d_hat to zero.
  void reset(const ModelTerms& now) noexcept override;

  // Non-finite input, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were.
  Estimate update(const ObserverInput& input) noexcept override;

 private:
  NonlinearDobOptions options_;
  Vec12 d_hat_ = Vec12::Zero();  // [N m]
};

}  // namespace dob
