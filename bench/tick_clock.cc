#include "bench/tick_clock.h"

#include <utility>

namespace dob {

class TickClock::TimedSolver final : public WbcQpSolver {
 public:
  TimedSolver(std::unique_ptr<WbcQpSolver> solver, TickClock& clock) : solver_(std::move(solver)), clock_(clock) {}

  QpStatus solve(const WbcProblem& problem, const WbcActiveSet& guess, WbcQpSolution& solution) noexcept override {
    const auto begin = Clock::now();
    const QpStatus status = solver_->solve(problem, guess, solution);
    clock_.qp_ += Clock::now() - begin;
    clock_.qp_solved_ = true;
    return status;
  }

 private:
  std::unique_ptr<WbcQpSolver> solver_;
  TickClock& clock_;
};

void TickClock::end_tick() {
  stop();
  using Microseconds = std::chrono::duration<double, std::micro>;
  tick_us_.push_back(Microseconds(tick_).count());
  if (qp_solved_) qp_us_.push_back(Microseconds(qp_).count());
  tick_ = qp_ = {};
  qp_solved_ = false;
}

std::unique_ptr<WbcQpSolver> TickClock::timed(std::unique_ptr<WbcQpSolver> solver) {
  return std::make_unique<TimedSolver>(std::move(solver), *this);
}

}  // namespace dob
