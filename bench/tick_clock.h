// How long the ticks of a trial take: model, observer, controller; of that, the QP.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "controller/wbc_solver.h"

namespace dob {

// A tick's work comes in spans start() ... stop(); end_tick() is the last stop().
class TickClock {
 public:
  // Room for `ticks` of them.
  explicit TickClock(std::size_t ticks) {
    tick_us_.reserve(ticks);
    qp_us_.reserve(ticks);
  }

  void start() noexcept { begin_ = Clock::now(); }
  void stop() noexcept { tick_ += Clock::now() - begin_; }
  void end_tick();

  // `solver` with every solve on this clock.
  std::unique_ptr<WbcQpSolver> timed(std::unique_ptr<WbcQpSolver> solver);

  const std::vector<double>& tick_us() const noexcept { return tick_us_; }  // [us] one per tick
  const std::vector<double>& qp_us() const noexcept { return qp_us_; }      // [us] one per tick that solved a QP

 private:
  class TimedSolver;
  using Clock = std::chrono::steady_clock;

  Clock::time_point begin_;
  Clock::duration tick_{}, qp_{};  // of the present tick
  bool qp_solved_ = false;
  std::vector<double> tick_us_, qp_us_;
};

}  // namespace dob
