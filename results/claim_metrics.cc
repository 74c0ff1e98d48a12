#include "results/claim_metrics.h"

#include "results/foot_errors.h"
#include "results/running_mean.h"

namespace dob {
ClaimMetrics::ClaimMetrics(std::optional<Leg> metric_leg, double dt)
    : metric_leg_(metric_leg), step_(dt), pulse_(metric_leg, dt) {}

void ClaimMetrics::add(const TickRecord& tick) noexcept {
  step_.add(tick);
  pulse_.add(tick);
  if (metric_leg_) {
    std::optional<double>& com = tick.stance[static_cast<std::size_t>(*metric_leg_)] ? com_in_stance_ : com_in_swing_;
    com = larger(com, (tick.com - tick.com_reference).norm());
  }
  if (tick.has_leg_estimate) {
    error_sum_ += tick.leg_torque_estimate - tick.leg_torque_true;
    ++error_ticks_;
  }
}

void ClaimMetrics::write(CellMetrics& metrics) const noexcept {
  metrics.estimate_overshoot = finite(step_.overshoot());
  metrics.estimate_settling_s = finite(step_.settling_s());
  const PulsePeaks peaks = pulse_.finish();
  metrics.com_peak_before_m = finite(peaks.com_before);
  metrics.com_peak_push_m = finite(peaks.com_first);
  metrics.com_peak_recovery_m = finite(peaks.com_second);
  metrics.foot_peak_push_m = finite(peaks.foot_push);
  metrics.foot_peak_rest_m = finite(peaks.foot_rest);
  metrics.com_error_swing_max_m = finite(com_in_swing_);
  metrics.com_error_stance_max_m = finite(com_in_stance_);
  if (error_ticks_ > 0) {
    metrics.estimate_offset_Nm = finite((error_sum_ / static_cast<double>(error_ticks_)).norm());
  }
}

}  // namespace dob
