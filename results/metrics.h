// From the ticks of one trial to its metrics. Definitions: docs/metrics.md.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "results/cell.h"
#include "results/claim_metrics.h"
#include "results/foot_errors.h"
#include "results/tick_record.h"

namespace dob {

// Mean of what was added; nullopt if nothing was.
class RunningMean {
 public:
  void add(double x) noexcept {
    sum_ += x;
    ++count_;
  }
  std::optional<double> value() const noexcept {
    return count_ == 0 ? std::nullopt : std::optional(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0.0;
  long count_ = 0;
};

// A metric that has met a value that is not finite ends as nullopt, never as the figure of the other ticks. The
// record of the tick at which a trial ends because its state is not finite must therefore not be added.
class MetricsAccumulator {
 public:
  // `metric_leg`: the leg whose foot and force errors count; without it the worst of four (foot) or all (force).
  // Tick dt [s]; expected duration [s], for which memory is reserved. Throws std::invalid_argument unless
  // dt > 0 and duration >= 0, both finite.
  MetricsAccumulator(std::optional<Leg> metric_leg, double dt, double duration);

  // Never throws and stays off the heap for the expected duration; a longer trial makes it grow.
  void add(const TickRecord& tick) noexcept;

  CellMetrics finish() const;

 private:
  void add_force_errors(const TickRecord& tick) noexcept;
  void add_estimate_errors(const TickRecord& tick) noexcept;
  void add_slip(const TickRecord& tick) noexcept;

  std::optional<Leg> metric_leg_;
  std::vector<double> com_error_;  // [m] one per tick
  std::vector<FootErrors> feet_;   // of metric_leg_ or of all legs
  std::optional<double> path_error_max_, orientation_error_max_, slip_max_;
  RunningMean grf_error_, estimate_square_, joint_estimate_square_, saturated_joints_;
  PerLeg<Vec3> slip_;  // [m] of the present stance
  long qp_solves_ = 0;
  long qp_failures_ = 0;
  long planner_failures_ = 0;
  ClaimMetrics claim_metrics_;
};

}  // namespace dob
