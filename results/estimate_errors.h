// How far estimates are from the truth, over a trial. The same for the observer in the loop and for its shadows.
#pragma once

#include <optional>

#include "results/running_mean.h"
#include "results/tick_record.h"

namespace dob {

// Squared norms of an estimate's errors at one tick; nullopt where the estimate or what it is judged by is missing.
struct EstimateError {
  std::optional<double> force;       // [N^2] at the point where the only force acts
  std::optional<double> joint;       // [N^2 m^2] over the 12 joints
  std::optional<double> com_force;   // [N^2]
  std::optional<double> com_moment;  // [N^2 m^2] about the CoM
};

EstimateError estimate_error(const TickRecord& tick) noexcept;

// Roots of the means; nullopt without a tick that had the error, NaN if one was not finite.
struct EstimateRmse {
  std::optional<double> force_N, joint_Nm, com_force_N, com_moment_Nm;
};

class EstimateErrors {
 public:
  void add(const EstimateError& error) noexcept;
  EstimateRmse rmse() const noexcept;

 private:
  RunningMean force_, joint_, com_force_, com_moment_;
};

}  // namespace dob
