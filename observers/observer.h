// The plugin seam: a disturbance observer sees what a real robot could measure or compute, never simulator truth.
#pragma once

#include <string_view>

#include "robot/model_terms.h"

namespace dob {

// What happened in one control interval [t - dt, t].
struct ObserverInput {
  const ModelTerms& start;  // model at t - dt, where the torques and contact forces below were applied
  const ModelTerms& now;    // model at t
  Vec12 joint_torque;       // [N m] measured (applied after saturation, with sensor noise)
  Vec12 foot_force;         // [N] measured ground reaction forces of ALL feet at their contact points, along W
  PerLeg<bool> stance;      // feet scheduled on the ground during the interval
  double dt;                // [s]
};

enum class EstimateStatus {
  kOk,
  kInvalidInput,  // NaN or infinity came in: the input was ignored, the estimate is the last good one
};

// What the controller consumes. A part that the observer does not estimate is flagged absent and zero.
struct Estimate {
  bool has_legs = false;
  Vec12 leg_torque = Vec12::Zero();  // [N m] F_hat = J_j^T f_hat: leg-tip disturbance forces f_hat, seen at the joints,
                                     // eq (4); footnote 1 maps back to f_hat [N]
  bool has_com = false;
  Vec6 com_wrench = Vec6::Zero();  // [N; N m] disturbance wrench about the CoM, along W
  EstimateStatus status = EstimateStatus::kOk;
};

// update() and reset() are noexcept, allocate nothing and are deterministic. reset() may be called in motion.
class DisturbanceObserver {
 public:
  virtual ~DisturbanceObserver() = default;
  virtual std::string_view name() const noexcept = 0;
  virtual void reset(const ModelTerms& now) noexcept = 0;
  virtual Estimate update(const ObserverInput& input) noexcept = 0;
};

}  // namespace dob
