#include "controller/locomotion_controller.h"

namespace dob {

LocomotionController::LocomotionController(const LocomotionOptions& o, const ReferencePath& path, double dt)
    : dt_(dt), gait_(o.gait), planner_(o.planner, o.gait, path), wbc_(o.wbc, o.routing) {}

void LocomotionController::reset(const ModelTerms& m, double initial_footstep_time,
                                 bool other_diagonal_first) noexcept {
  tick_ = 0;
  gait_.reset(initial_footstep_time, other_diagonal_first);
  planner_.reset(m);
  wbc_.reset();
}

const WbcTick& LocomotionController::update(const ModelTerms& m, const Vec12& foot_force,
                                            const DisturbanceEstimate& estimate) noexcept {
  const GaitState& gait = gait_.update(dt_, foot_force);
  for (int l = 0; l < kLegs; ++l) stance_[l] = gait.stands(l);
  const MotionReference& reference = planner_.update(static_cast<double>(tick_) * dt_, gait, m);
  wbc_tick_ = wbc_.update(tick_, dt_, m, stance_, reference, estimate);
  ++tick_;
  return wbc_tick_;
}

}  // namespace dob
