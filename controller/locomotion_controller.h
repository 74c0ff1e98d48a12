// The controller of the paper's Fig. 2: foot scheduler, motion planner, quadratic problem, torques.
#pragma once

#include <memory>
#include <utility>

#include "controller/gait_scheduler.h"
#include "controller/motion_planner.h"
#include "controller/whole_body_controller.h"

namespace dob {

struct LocomotionOptions {
  GaitOptions gait;
  PlannerOptions planner;
  WbcOptions wbc;
  Routing routing;
};

class LocomotionController {
 public:
  // Throws std::invalid_argument naming the option, its value and what is allowed.
  LocomotionController(const LocomotionOptions& options, const ReferencePath& path, double dt);

  // Another solver of the QP, from the next tick on; throws std::invalid_argument for none.
  void use_solver(std::unique_ptr<WbcQpSolver> solver) { wbc_.use_solver(std::move(solver)); }

  // Standing at `m`; see GaitScheduler::reset for the gait's phase.
  void reset(const ModelTerms& m, double initial_footstep_time = 0.0, int first_step = 0) noexcept;

  // One tick: the model at the present state, the foot forces measured over the last step [N], the observer's estimate.
  // Returns the torques [N m] for the next step.
  const WbcTick& update(const ModelTerms& m, const Vec12& foot_force, const DisturbanceEstimate& estimate) noexcept;

  // What the last update() used: schedule, stance set, references, zeta of (12), the reduced problem.
  const GaitState& gait() const noexcept { return gait_.state(); }
  const PerLeg<bool>& stance() const noexcept { return stance_; }
  const MotionReference& reference() const noexcept { return planner_.reference(); }
  const WbcSolution& solution() const noexcept { return wbc_.solution(); }
  const WbcProblem& last_problem() const noexcept { return wbc_.last_problem(); }
  const MotionPlanner& planner() const noexcept { return planner_; }

 private:
  double dt_;
  GaitScheduler gait_;
  MotionPlanner planner_;
  WholeBodyController wbc_;
  long tick_ = 0;
  PerLeg<bool> stance_{};
  WbcTick wbc_tick_;
};

}  // namespace dob
