// The metrics of a trial that only the paper's claims ask for.
#pragma once

#include <optional>

#include "results/cell.h"
#include "results/pulse_response.h"
#include "results/step_response.h"
#include "results/tick_record.h"

namespace dob {

class ClaimMetrics {
 public:
  // `metric_leg`: the leg whose swing, stance and foot count; without it those metrics do not apply. Tick dt [s].
  ClaimMetrics(std::optional<Leg> metric_leg, double dt);

  void add(const TickRecord& tick) noexcept;

  // Sets the claims' own metrics of `metrics`, and no others.
  void write(CellMetrics& metrics) const noexcept;

 private:
  std::optional<Leg> metric_leg_;
  StepResponse step_;
  PulseResponse pulse_;
  std::optional<double> com_in_swing_, com_in_stance_;  // [m] largest errors, by what the metric leg does
  Vec12 error_sum_ = Vec12::Zero();                     // [N m] of F_hat minus the truth
  long error_ticks_ = 0;
};

}  // namespace dob
