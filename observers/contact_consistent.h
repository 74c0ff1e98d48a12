// Observer without force sensors in the feet: the stance forces are projected out of the momentum balance (the idea of
// contact-consistent disturbance observers, Lee et al. 2018; the basis below is ours).
//
// The whole robot's momentum obeys dp/dt = known + S^T tau + J_st^T f_st + d with f_st unknown. A matrix P with
// P J_st^T = 0 leaves P d, and nothing else is observable: P^T has to span the motions that the standing feet allow.
// Those are the six of the trunk, with each standing leg following, and the three joints of each swinging leg. In this
// basis P needs no mass matrix and no 18 x 18 factorization, one 3x3 inverse for each leg. Per leg l, with
// the residuals u of the CoM momentum and r of the legs' momentum, both WITHOUT foot forces (residual.h), A_c of (1):
//     g_l = J_q,l^-T (r + A_c^T u)_l       what must act on the foot of leg l to explain its three joints
//     standing: g_l is ground reaction force and disturbance in one, and leaves:   u -= J_com,l^T g_l
//     swinging: g_l is the disturbance at the tip:                                 F = J_j^T [g_l of swinging legs]
// After that u is the disturbance wrench about the CoM that moves the robot as d does. Both go through the exact
// first-order low-pass of momentum_exact.h, gain K [rad/s].
//
// What is unobservable: a force on a standing foot (the ground answers it, and the robot does not move); how a push on
// a standing leg divides between leg and trunk, so that it all appears as a wrench about the CoM, and the leg's own
// part of F_hat is zero. With no foot on the ground all is observable. Standing legs must not be stretched (J_q,l
// singular).
//
// Limits: believes the schedule (`stance`): a foot that slips, or that touches while scheduled to swing, is a
// disturbance; so is the impact of a touchdown. The points of the feet are those of level ground (model_terms.h).
#pragma once

#include "observers/momentum_exact.h"

namespace dob {

class ContactConsistentObserver final : public DisturbanceObserver {
 public:
  // Key: gain_rad_s. Throws OptionError.
  ContactConsistentObserver(const ObserverOptions& options, double dt);

  std::string_view name() const noexcept override { return "contact_consistent"; }

  // Both estimates to zero.
  void reset(const ModelTerms& now) noexcept override;

  // Non-finite input, a singular leg, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were.
  // Measured foot forces are not used, and may be anything.
  Estimate update(const ObserverInput& input) noexcept override;

 private:
  ExactFilter<kJoints> legs_;  // [N m] F_hat
  ExactFilter<6> com_;         // [N; N m] wrench about the CoM
  ExactFilter<kJoints> legs_at_rest_;
  ExactFilter<6> com_at_rest_;
};

}  // namespace dob
