// Two runs of the same scenario and seed compared on the stretch of time that both have stood.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "results/cell.h"
#include "results/metric_fields.h"
#include "results/statistics.h"

namespace dob {

// The metrics that checkpoints hold.
struct PairedMetric {
  std::string_view name;  // of the metric, with its unit
  std::optional<double> MetricsCheckpoint::*value;
};

inline constexpr std::array kPairedMetrics{
    PairedMetric{"com_error_max_m", &MetricsCheckpoint::com_error_max_m},
    PairedMetric{"com_error_rms_m", &MetricsCheckpoint::com_error_rms_m},
    PairedMetric{"path_error_max_m", &MetricsCheckpoint::path_error_max_m},
    PairedMetric{"foot_error_max_m", &MetricsCheckpoint::foot_error_max_m},
    PairedMetric{"grf_error_mean_N", &MetricsCheckpoint::grf_error_mean_N},
};

// The checkpoints of both at the latest moment at which both have one: the end when both lasted the whole trial, else
// the last whole 0.5 s before the first of them fell, so that the fall itself, which one of them did not have, stays
// out. Nothing is interpolated. nullopt when there is no such moment, or one of them could not be run.
std::optional<std::pair<MetricsCheckpoint, MetricsCheckpoint>> on_common_time(const CellResult& a, const CellResult& b);

// A metric of two runs that compare.
struct FigurePair {
  double a, b;
  double t;  // [s] up to when
};

// On the common time for a metric that checkpoints hold, for any other one where both survived; nullopt: they do not
// compare.
std::optional<FigurePair> paired_figures(const CellResult& a, const CellResult& b, const MetricField& metric);

// Of b - a over pairs.
struct PairedDifference {
  int pairs = 0;
  std::optional<double> median;
  std::optional<Interval> ci95;  // bootstrap, of the median; nullopt below kMinSamplesForInterval pairs
};

PairedDifference summarise_differences(const std::vector<double>& differences);

}  // namespace dob
