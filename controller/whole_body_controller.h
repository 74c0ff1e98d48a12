// Solves the whole-body QP when it is due and turns the held solution into joint torques at every tick.
#pragma once

#include <memory>

#include "controller/compensation.h"
#include "controller/motion_planner.h"
#include "controller/wbc_solver.h"
#include "controller/whole_body_qp.h"

namespace dob {

// What happened to the QP at a tick.
enum class QpEvent {
  kHeld,                 // not due: the last solution is held
  kSolved,               // optimal
  kAccelerationRelaxed,  // fallback 1: not optimal with the joint acceleration rows; solved without them
  kTorqueRelaxed,  // fallback 2: not optimal with the torque rows (24) either; solved without them, torques saturate
  kNotSolved,      // fallback 3: no usable solution, the previous one is held on
};

struct WbcTick {
  QpEvent event = QpEvent::kHeld;
  QpStatus qp_status = QpStatus::kOptimal;  // of the full problem, at ticks where it was solved
  int qp_iterations = 0;
  Vec12 torque =
      Vec12::Zero();  // [N m] within the torque limit, finite: what is not finite is not sent, the last one is
};

class WholeBodyController {
 public:
  // Throws std::invalid_argument naming the option, its value and what is allowed.
  WholeBodyController(const WbcOptions& options, const Routing& routing,
                      std::unique_ptr<WbcQpSolver> solver = make_wbc_solver());

  // Another solver from the next tick on; throws std::invalid_argument for none.
  void use_solver(std::unique_ptr<WbcQpSolver> solver);

  // Forgets the held solution and the active rows: the next update() solves.
  void reset() noexcept;

  // Tick number `k` since reset, of dt [s]. The QP runs at options.qp_rate on the grid of ticks (400 Hz at 1 ms: every
  // 3, 2, 3, 2 ... ticks), and at once when the stance set changes; each solve starts from the rows that were active in
  // the one before as long as the stance set is the same. Between solves (36) is evaluated with the held solution and
  // the present model and estimate, or its torque is held.
  WbcTick update(long k, double dt, const ModelTerms& m, const PerLeg<bool>& stance, const MotionReference& reference,
                 const DisturbanceEstimate& estimate) noexcept;

  // Of the last solve that counted; of the last one that was tried.
  const WbcSolution& solution() const noexcept { return solution_; }
  const WbcProblem& last_problem() const noexcept { return qp_.problem(); }

 private:
  QpEvent solve_with_fewer_rows() noexcept;
  bool due(long k, double dt, const PerLeg<bool>& stance) const noexcept;
  void solve(const ModelTerms& m, const MotionReference& reference, const Compensation& compensation,
             const PerLeg<LegPoint>& points, const TaskJacobian& J, WbcTick& tick) noexcept;

  WbcOptions options_;
  Routing routing_;
  WholeBodyQp qp_;
  std::unique_ptr<WbcQpSolver> solver_;
  WbcQpSolution qp_solution_;
  WbcActiveSet guess_;
  WbcSolution solution_;
  Vec12 torque_ = Vec12::Zero();  // [N m] of the last tick
  PerLeg<bool> stance_{};
  bool have_solution_ = false;
};

}  // namespace dob
