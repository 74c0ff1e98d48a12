// One axis of one channel of an observer on the frozen robot: a signal in, the estimate of it out.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "observers/linear_observer.h"
#include "observers/observer.h"

namespace dob {

// A robot at rest in `pose` whose one channel is disturbed: [N m] of a joint, [N] or [N m] of an axis of the CoM. dt
// [s] is the tick. `pose` has to outlive it.
class Probe {
 public:
  Probe(const ModelTerms& pose, Channel channel, double dt) : pose_(pose), channel_(channel), dt_(dt) {}

  // Estimates y_k after a reset, from the disturbance u(k) over tick k = 0 ... ticks - 1. Ends early, with NaN, when
  // the observer refuses its input or the estimate exceeds `limit`.
  std::vector<double> answer(DisturbanceObserver& observer, long ticks, double limit,
                             const std::function<double(long)>& u) const;

  double dt() const noexcept { return dt_; }

 private:
  const ModelTerms& pose_;
  Channel channel_;
  double dt_;
};

// The answer to a step of `amplitude` [unit of the channel] that has settled.
struct StepResponse {
  std::vector<double> y;  // estimate over amplitude, at the end of every tick
  double final_value;     // mean over the second half
};

// Twice as long a run each time until the second half stays within 1e-5 of its mean; after 2^16 ticks (65 s of 1 ms)
// within 5 % must do, for an observer that chatters. nullopt when it does not: the observer oscillates or diverges.
std::optional<StepResponse> step_response(const Probe& probe, DisturbanceObserver& observer, double amplitude);

}  // namespace dob
