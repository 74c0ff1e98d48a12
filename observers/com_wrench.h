// First-order observer of the disturbance wrench about the CoM, from the momentum of the whole robot: the paper's
// baseline [2] (Focchi et al., "Heuristic planning for rough terrain locomotion in presence of external disturbances
// and variable perception quality", 2020), on the first six rows of (1).
//
// With P = m c_dot and L the angular momentum about the CoM, axes of W, sums over all feet,
//     dP/dt = -m g e_z + sum f_i + f_d,      dL/dt = sum (p_i - c) x f_i + m_d;
// the second holds exactly about the moving CoM, so that L itself is differenced and no rate of I_c is needed.
// Continuous form: w_hat = G ([P; L] - integral of (w_hat + known)), hence w_hat = G / (s + G) [f_d; m_d]: bandwidth
// G [rad/s] (-3 dB), lag 1/G [s], unit static gain.
// Update at time t, in the order of momentum.h:
//     1. known wrench at t - dt, where the measured forces acted
//     2. w_hat += G ([P; L](t) - [P; L](t - dt) - dt (w_hat + known)).
// No anchor is needed: the observer may start in motion, and an interval that was lost does not come back later as a
// jump. Forward Euler in w_hat holds for G dt < 2; faster gains are refused. Accuracy: first order in dt.
//
// What it cannot see: on which leg, or at which point, the disturbance acts. A wrong mass m (1 + e) is read as a force
// e m (c_dd + g e_z), which is m g e upwards while standing; a wrong CoM as the moment of the weight about it. It
// trusts the measured ground reaction forces of ALL feet at the contact points of level ground (model_terms.h).
#pragma once

#include "observers/linear_observer.h"
#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

struct ComWrenchOptions {
  double linear_gain = 25.0;   // [rad/s] of the force; section 5.1
  double angular_gain = 10.0;  // [rad/s] of the moment; section 5.1
};

// Keys: linear_gain_rad_s, angular_gain_rad_s. Throws OptionError.
ComWrenchOptions read_com_wrench_options(const ObserverOptions& options);

class ComWrenchObserver final : public DisturbanceObserver, public LinearObserver {
 public:
  // dt [s] is the tick at which stability is checked. Throws OptionError with the reason: gains that are none, or
  // unstable at the tick.
  ComWrenchObserver(const ComWrenchOptions& options, double dt);

  std::string_view name() const noexcept override { return "com_wrench"; }

  // w_hat to zero.
  void reset(const ModelTerms& now) noexcept override;

  // Non-finite input, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were. Joint torques are not
  // used, and may be anything.
  Estimate update(const ObserverInput& input) noexcept override;

  std::optional<LinearChannel> linear(Channel channel) const override;

 private:
  Vec6 G_;                     // [rad/s]
  Vec6 w_hat_ = Vec6::Zero();  // [N; N m]
};

}  // namespace dob
