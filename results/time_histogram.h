// How durations are distributed, on a scale on which microseconds and their outliers are seen alike.
#pragma once

#include <vector>

namespace dob {

// counts[i] durations within [edges_us[i], edges_us[i + 1]).
struct TimeHistogram {
  std::vector<double> edges_us;  // [us] one more than counts; both are empty when there is nothing
  std::vector<long> counts;

  friend bool operator==(const TimeHistogram&, const TimeHistogram&) = default;
};

// Twenty bins for each factor of ten, edges 10^(k/20) us, from the first bin that is not empty to the last one. What is
// below 0.01 us is in that bin. Throws std::invalid_argument for a duration that is not finite or negative.
TimeHistogram time_histogram(const std::vector<double>& durations_us);

}  // namespace dob
