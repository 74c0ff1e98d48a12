// From the ticks of one trial to its metrics. Definitions: docs/metrics.md.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "results/cell.h"
#include "results/claim_metrics.h"
#include "results/estimate_errors.h"
#include "results/foot_errors.h"
#include "results/running_mean.h"
#include "results/tick_record.h"

namespace dob {

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

  // Name of the first metric that has met a value that is not finite; empty if there is none. What only the claims ask
  // for is left out: ratios among it have no value where there is nothing to compare with.
  std::string_view not_finite() const;

  // One every 0.5 s and one at the end: each is, bit for bit, what finish() would have said had the trial ended there.
  // So a swing under way counts as what it has been so far; it leaves foot_error_max_m again, which may then become
  // smaller, if a disturbance's onset in its first 20 ms makes it an onset swing.
  std::vector<MetricsCheckpoint> checkpoints() const;

 private:
  CellMetrics as_measured() const;
  void add_force_errors(const TickRecord& tick) noexcept;
  void add_slip(const TickRecord& tick) noexcept;
  std::optional<double> foot_error_max() const noexcept;
  MetricsCheckpoint checkpoint() const noexcept;

  std::optional<Leg> metric_leg_;
  std::vector<double> com_error_;  // [m] one per tick
  std::vector<FootErrors> feet_;   // of metric_leg_ or of all legs
  std::optional<double> com_error_max_, path_error_max_, orientation_error_max_, slip_max_;
  RunningMean com_error_square_, grf_error_, saturated_joints_;
  EstimateErrors estimate_errors_;
  PerLeg<Vec3> slip_;  // [m] of the present stance
  double dt_;          // [s]
  long ticks_ = 0;
  long ticks_per_checkpoint_ = 1;
  std::vector<MetricsCheckpoint> checkpoints_;
  long qp_solves_ = 0;
  long qp_failures_ = 0;
  long planner_failures_ = 0;
  ClaimMetrics claim_metrics_;
};

}  // namespace dob
