// What one pulse does to a walk: the errors before it, while it acts, and in the second that follows.
#pragma once

#include <optional>

#include "results/tick_record.h"

namespace dob {

// [m]; nullopt where there was no such tick, NaN where an error was not finite.
struct PulsePeaks {
  std::optional<double> com_before;    // largest in the last 0.5 to 1 s before the pulse
  std::optional<double> com_push;      // largest while it acts
  std::optional<double> com_valley;    // smallest between the push's peak and the recovery's
  std::optional<double> com_recovery;  // largest in the 1 s after it
  std::optional<double> foot_push;     // largest of the metric leg in swing while it acts
  std::optional<double> foot_rest;     // and at all other times
};

// A pulse is the only disturbance of its trial: it begins, does not change, and ends. Anything else has no peaks.
class PulseResponse {
 public:
  PulseResponse(std::optional<Leg> metric_leg, double dt);  // [s]

  void add(const TickRecord& tick) noexcept;

  PulsePeaks finish() const noexcept;

 private:
  enum class Phase { kBefore, kActing, kAfter, kOther };

  void advance(const TickRecord& tick) noexcept;
  void add_com(double error) noexcept;
  void add_foot(const TickRecord& tick) noexcept;

  std::optional<Leg> metric_leg_;
  long block_ticks_, recovery_ticks_;
  Phase phase_ = Phase::kBefore;
  long ticks_ = 0;                            // of the present block, or since the end of the pulse
  std::optional<double> block_, last_block_;  // largest CoM errors, half a second each
  std::optional<double> since_peak_;          // smallest since the latest peak
  PulsePeaks peaks_;
};

}  // namespace dob
