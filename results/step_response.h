// How the estimate of a constant force gets to its value: overshoot and settling, as in the paper's order study.
#pragma once

#include <optional>

#include "results/tick_record.h"

namespace dob {

// Judges force_estimate, projected on the direction of force_true, over the size of force_true: 1 is the truth. A step
// is one force on a leg that begins, never changes along the world's axes, and lasts to the end of the trial;
// everything else, and an observer that does not estimate the legs, has no step response.
class StepResponse {
 public:
  explicit StepResponse(double dt) : dt_(dt) {}  // [s]

  void add(const TickRecord& tick) noexcept;

  // [-] The largest excess over the truth, 0 if there is none. NaN if an estimate was not finite.
  std::optional<double> overshoot() const noexcept;
  // [s] From the onset until the estimate stays within 5 % of the truth; nullopt if it never does.
  std::optional<double> settling_s() const noexcept;

 private:
  double dt_;
  Vec3 force_ = Vec3::Zero();  // [N]
  long ticks_ = 0;             // since the onset; tick n is n dt after it
  long last_outside_ = 0;      // the last tick that was not within the band
  std::optional<double> excess_;
  bool other_ = false;  // not a step
};

}  // namespace dob
