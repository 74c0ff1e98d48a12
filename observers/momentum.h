// Observer of leg-tip disturbances from the legs' generalized momentum, any order r: section 3.2, eqs
// (2)-(9).
//
// Continuous form, each joint of the 12 (alpha as in (8), F_hat = gamma_r):
//     gamma_1 = K_1 (rho - rho_0 - integral of (F_hat + alpha)),  gamma_i = K_i integral of (gamma_(i-1) -
//     F_hat).
// Order of the update at time t, which decides how fast the gains may be at a given tick:
//     1. alpha at t - dt, where the measured torques and forces acted;  F_hat is the previous estimate
//     2. gamma_1 += K_1 (rho(t) - rho(t - dt) - dt (F_hat + alpha))
//     3. for i = 2 ... r in turn: gamma_i += dt K_i (gamma_(i-1) - F_hat), with gamma_(i-1) as just updated
//     4. the new estimate is gamma_r.
// Step 2 is (6) differenced over one interval. It needs no anchor rho_0: the observer may start in motion,
// and an interval that was lost does not appear later as a jump of momentum. `start` of an update has to be
// the same values as `now` of the one before, or their noise does not telescope. Accuracy: first order in dt.
//
// What it cannot see: mass errors and forces on the trunk, except through the legs' coupling (gravity cancels
// in the joint rows of (1)); a disturbance's direct effect on the CoM.
#pragma once

#include <array>

#include "observers/linear_observer.h"
#include "observers/momentum_gains.h"
#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

// The term C_q^T qd of (3) and (8): the exact d/dt(M_q qd) at zero force, or left out, to measure what it
// matters.
enum class Coriolis { kExact, kNeglected };

struct MomentumOptions {
  MomentumGains gains{{2.25, 6.28, 17.5}};  // [rad/s] section 5.1 in the stable order
  double gain_scale = 1.0;                  // multiplies all K, hence the bandwidth
  Coriolis coriolis = Coriolis::kExact;
  bool allow_unstable = false;  // use the gains even if check_stability() refuses them
};

// The ways to give the gains, of which an observer takes one.
inline constexpr std::array<std::string_view, 3> kMomentumGainKeys{"gains", "coefficients", "family"};

// Keys: coriolis ("exact" | "neglected"), allow_unstable (bool), and for the gains ONE of
//     gains            K_1;...;K_r [rad/s] (the default's, if nothing is said)
//     coefficients     c_0;...;c_(r-1) of (5) [(rad/s)^(r-j)]; unit static gain needs k_0 = c_0, so k_0 is not asked
//     for family           "bessel" | "butterworth" | "binomial", with order and bandwidth_rad_s (-3 dB)
// order (whole number) may stand beside gains and coefficients and must agree with them; gain_scale multiplies all K of
// either. Throws OptionError.
MomentumOptions read_momentum_options(const ObserverOptions& options);

class MomentumObserver final : public DisturbanceObserver, public LinearObserver {
 public:
  // dt [s] is the tick at which stability is checked. Throws OptionError with the reason: gains that are
  // none, or unstable (continuous, or at the tick) unless allowed.
  MomentumObserver(const MomentumOptions& options, double dt);

  std::string_view name() const noexcept override { return "momentum"; }

  // All gamma_i to zero.
  void reset(const ModelTerms& now) noexcept override;

  // Non-finite input, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were.
  Estimate update(const ObserverInput& input) noexcept override;

  std::optional<LinearChannel> linear(Channel channel) const override;

 private:
  using State = std::array<Vec12, kMaxMomentumOrder>;  // gamma_1 ... gamma_r [N m]; the rest stays zero

  int order_;
  std::array<double, kMaxMomentumOrder> K_{};
  Coriolis coriolis_;
  State gamma_;
};

}  // namespace dob
