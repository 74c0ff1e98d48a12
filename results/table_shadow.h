// The table of the shadow observers: how good estimates are on identical data, apart from what they do to the loop.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/table_blocks.h"
#include "results/table_rows.h"

namespace dob {

// The metrics of an estimate, as the cell's own observer and as a shadow has them.
struct EstimateMetric {
  std::string_view name;  // with its unit
  std::optional<double> CellMetrics::*own;
  std::optional<double> ShadowResult::*shadow;
};

inline constexpr std::array kEstimateMetrics{
    EstimateMetric{"estimate_rmse_N", &CellMetrics::estimate_rmse_N, &ShadowResult::estimate_rmse_N},
    EstimateMetric{"joint_estimate_rmse_Nm", &CellMetrics::joint_estimate_rmse_Nm,
                   &ShadowResult::joint_estimate_rmse_Nm},
    EstimateMetric{"com_force_rmse_N", &CellMetrics::com_force_rmse_N, &ShadowResult::com_force_rmse_N},
    EstimateMetric{"com_moment_rmse_Nm", &CellMetrics::com_moment_rmse_Nm, &ShadowResult::com_moment_rmse_Nm},
};

// One observer on the trajectories of one row of the comparison. All runs are in, up to the fall where they fell: what
// is compared saw the same.
struct ShadowRow {
  CellKey key;  // of the loop; its seed has no meaning
  std::string observer, profile;
  bool in_loop = false;
  int runs = 0;
  std::array<MetricSummary, kEstimateMetrics.size()> metrics;
};

// For every row with shadows, in the order of the comparison: the observer in the loop, then the shadows.
std::vector<ShadowRow> build_shadow_rows(const Run& run, TableOrder order);

std::vector<TableBlock> shadow_blocks(const std::vector<ShadowRow>& rows);
std::vector<std::string> shadow_legend();

}  // namespace dob
