#include "controller/locomotion_controller.h"

#include "controller/support_polygon.h"

namespace dob {
namespace {

// A crawl lifts a foot only when the CoM is over the triangle of the others.
bool is_balanced(const GaitState& gait, const ModelTerms& m) noexcept {
  if (gait.pattern.gait != Gait::kCrawl) return true;
  PerLeg<bool> stays{};
  PerLeg<Vec2> feet;
  for (int l = 0; l < kLegs; ++l) {
    stays[l] = gait.stands(l) && !gait.next_swing[l];
    feet[l] = m.contact[l].p.head<2>();
  }
  return support_polygon(stays, feet, 0.0).margin(m.p_com.head<2>()) > 0.0;
}

}  // namespace

LocomotionController::LocomotionController(const LocomotionOptions& o, const ReferencePath& path, double dt)
    : dt_(dt), gait_(o.gait), planner_(o.planner, o.gait, path), wbc_(o.wbc, o.routing) {}

void LocomotionController::reset(const ModelTerms& m, double initial_footstep_time, int first_step) noexcept {
  tick_ = 0;
  gait_.reset(initial_footstep_time, first_step);
  planner_.reset(m);
  wbc_.reset();
}

const WbcTick& LocomotionController::update(const ModelTerms& m, const Vec12& foot_force,
                                            const DisturbanceEstimate& estimate) noexcept {
  const GaitState& gait = gait_.update(dt_, foot_force, is_balanced(gait_.state(), m));
  for (int l = 0; l < kLegs; ++l) stance_[l] = gait.stands(l);
  const MotionReference& reference = planner_.update(static_cast<double>(tick_) * dt_, gait, m);
  wbc_tick_ = wbc_.update(tick_, dt_, m, stance_, reference, estimate);
  ++tick_;
  return wbc_tick_;
}

}  // namespace dob
