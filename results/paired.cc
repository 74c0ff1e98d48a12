#include "results/paired.h"

#include <cmath>

namespace dob {

std::optional<std::pair<MetricsCheckpoint, MetricsCheckpoint>> on_common_time(const CellResult& a,
                                                                              const CellResult& b) {
  constexpr double kSameTime = 1e-9;  // [s]
  if (a.outcome == Outcome::kError || b.outcome == Outcome::kError) return std::nullopt;
  auto in_a = a.checkpoints.rbegin();
  auto in_b = b.checkpoints.rbegin();
  while (in_a != a.checkpoints.rend() && in_b != b.checkpoints.rend()) {
    if (std::abs(in_a->t - in_b->t) < kSameTime) return std::pair(*in_a, *in_b);
    if (in_a->t > in_b->t) {
      ++in_a;
    } else {
      ++in_b;
    }
  }
  return std::nullopt;
}

PairedDifference summarise_differences(const std::vector<double>& differences) {
  if (differences.empty()) return {};
  return {static_cast<int>(differences.size()), median(differences), bootstrap_median_interval(differences)};
}

}  // namespace dob
