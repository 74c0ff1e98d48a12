#include "results/paired.h"

#include <algorithm>
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

std::optional<FigurePair> paired_figures(const CellResult& a, const CellResult& b, const MetricField& metric) {
  const auto checkpoint = std::find_if(kPairedMetrics.begin(), kPairedMetrics.end(),
                                       [&](const PairedMetric& paired) { return paired.name == metric.name; });
  std::optional<double> in_a, in_b;
  double t = std::min(a.simulated_s, b.simulated_s);
  if (checkpoint != kPairedMetrics.end()) {
    if (const auto both = on_common_time(a, b)) {
      in_a = both->first.*checkpoint->value;
      in_b = both->second.*checkpoint->value;
      t = both->first.t;
    }
  } else if (a.outcome == Outcome::kSurvived && b.outcome == Outcome::kSurvived) {
    in_a = metric.of(a.metrics);
    in_b = metric.of(b.metrics);
  }
  return in_a && in_b ? std::optional(FigurePair{*in_a, *in_b, t}) : std::nullopt;
}

PairedDifference summarise_differences(const std::vector<double>& differences) {
  if (differences.empty()) return {};
  return {static_cast<int>(differences.size()), median(differences), bootstrap_median_interval(differences)};
}

}  // namespace dob
