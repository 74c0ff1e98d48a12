#include "results/table_shadow.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "results/table_cells.h"

namespace dob {
namespace {

using Cells = std::vector<const CellResult*>;

ShadowRow own_row(const CellKey& key, const Cells& cells) {
  ShadowRow row{key, key.observer, key.profile, true, static_cast<int>(cells.size()), {}};
  for (std::size_t i = 0; i < kEstimateMetrics.size(); ++i) {
    std::vector<double> samples;
    for (const CellResult* cell : cells) {
      if (const auto value = cell->metrics.*kEstimateMetrics[i].own) samples.push_back(*value);
    }
    row.metrics[i] = summarise(samples);
  }
  return row;
}

ShadowRow shadow_row(const CellKey& key, const ShadowResult& name, const Cells& cells) {
  ShadowRow row{key, name.observer, name.profile, false, 0, {}};
  std::array<std::vector<double>, kEstimateMetrics.size()> samples;
  for (const CellResult* cell : cells) {
    for (const ShadowResult& shadow : cell->shadows) {
      if (shadow.observer != name.observer || shadow.profile != name.profile) continue;
      ++row.runs;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        if (const auto value = shadow.*kEstimateMetrics[i].shadow) samples[i].push_back(*value);
      }
    }
  }
  std::transform(samples.begin(), samples.end(), row.metrics.begin(), summarise);
  return row;
}

}  // namespace

std::vector<ShadowRow> build_shadow_rows(const Run& run, TableOrder order) {
  std::map<CellKey, Cells> watched;
  for (const CellResult& cell : run.cells) {
    if (!cell.shadows.empty()) watched[without_seed(cell.key)].push_back(&cell);
  }
  std::vector<ShadowRow> rows;
  for (const TableRow& compared : build_rows(run, order)) {
    const auto found = watched.find(compared.key);
    if (found == watched.end()) continue;
    rows.push_back(own_row(compared.key, found->second));
    // All cells of a row were watched by the same observers: those of its first one name them.
    for (const ShadowResult& shadow : found->second.front()->shadows) {
      rows.push_back(shadow_row(compared.key, shadow, found->second));
    }
  }
  return rows;
}

std::vector<TableBlock> shadow_blocks(const std::vector<ShadowRow>& rows) {
  std::vector<TableBlock> blocks;
  for (const ShadowRow& row : rows) {
    if (row.in_loop) {
      const std::string title =
          fmt::format("{}, in the loop {}: {}", scenario_name(row.key), observer_name(row.key), set_name(row.key));
      blocks.push_back({on_one_line(title),
                        {{"observer", "", false},
                         {"profile", "", false},
                         {"runs"},
                         {"force", "N"},
                         {"joints", "N m"},
                         {"CoM force", "N"},
                         {"CoM moment", "N m"}}});
      blocks.back().rules = {1};
    }
    std::vector<std::string> cells{row.observer, row.profile, std::to_string(row.runs)};
    for (const MetricSummary& metric : row.metrics) cells.push_back(median_and_worst(metric, 1.0));
    blocks.back().rows.push_back(std::move(cells));
  }
  return blocks;
}

std::vector<std::string> shadow_legend() {
  return {
      "Root mean square errors of estimates on the trajectories of the observer in the loop, which stands above the "
      "rule; the shadows below saw the same and changed nothing. force: mapped back to the point where the only force "
      "acts. joints: of the joint torques that the forces amount to. CoM force, CoM moment: of the wrench about the "
      "CoM. a / b: median and worst over the seeds. -: not estimated, or nothing to judge it by. Definitions: "
      "docs/metrics.md."};
}

}  // namespace dob
