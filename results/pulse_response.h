// What one pulse does to a walk: the errors before it and what follows.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "results/tick_record.h"

namespace dob {

// [m]; nullopt where there was no such tick, NaN where an error was not finite.
struct PulsePeaks {
  std::optional<double> com_before;  // largest in the last 0.5 to 1 s before the pulse
  // Within 1.5 s of the onset: the highest peak and the highest other one that is apart from it, in the order of time.
  // Apart: the error falls to half of the lower peak between them. Without a second peak the first is the highest.
  std::optional<double> com_first, com_second;
  std::optional<double> foot_push;  // largest of the metric leg in swing while the pulse acts
  std::optional<double> foot_rest;  // and at all other times
};

// A pulse is the only disturbance of its trial: it begins, does not change, and ends. Anything else has no peaks.
class PulseResponse {
 public:
  // Tick dt [s]. Memory is reserved here; add() stays off the heap.
  PulseResponse(std::optional<Leg> metric_leg, double dt);

  void add(const TickRecord& tick) noexcept;

  PulsePeaks finish() const noexcept;

 private:
  enum class Phase { kBefore, kActing, kAfter, kOther };

  void advance(const TickRecord& tick) noexcept;
  void add_com(double error) noexcept;
  void add_foot(const TickRecord& tick) noexcept;

  std::optional<Leg> metric_leg_;
  std::size_t block_ticks_, window_ticks_;
  Phase phase_ = Phase::kBefore;
  std::size_t ticks_ = 0;                     // of the present block
  std::optional<double> block_, last_block_;  // [m] largest CoM errors, half a second each
  std::vector<double> com_;                   // [m] CoM errors from the onset on
  PulsePeaks peaks_;
};

}  // namespace dob
