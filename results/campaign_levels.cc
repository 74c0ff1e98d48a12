#include "results/campaign_levels.h"

#include <algorithm>
#include <map>

#include "results/table_rows.h"

namespace dob {
namespace {

using Metric = std::optional<double> CellMetrics::*;

void count(const CurveCell& cell, LevelResult& level) {
  ++level.planned;
  level.trials += survived(cell) || fell(cell) ? 1 : 0;
  level.falls += fell(cell) ? 1 : 0;
  level.errors += has_error(cell) ? 1 : 0;
}

std::vector<double> of_survivors(const std::vector<CurveCell>& cells, Metric metric) {
  std::vector<double> samples;
  for (const CurveCell& cell : cells) {
    if (!survived(cell)) continue;
    if (const std::optional<double> value = cell.result->metrics.*metric) samples.push_back(*value);
  }
  return samples;
}

LevelResult level_result(const std::vector<CurveCell>& cells) {
  LevelResult level;
  level.level = cells.front().level;
  for (const CurveCell& cell : cells) count(cell, level);
  level.falls_ci = wilson_interval(level.falls, level.trials);
  const MetricSummary com = summarise(of_survivors(cells, &CellMetrics::com_error_max_m));
  const MetricSummary foot = summarise(of_survivors(cells, &CellMetrics::foot_error_max_m));
  level.com_error_m = com.median;
  level.com_error_ci = com.ci95;
  level.foot_error_m = foot.median;
  level.foot_error_ci = foot.ci95;
  return level;
}

}  // namespace

std::vector<LevelResult> level_results(const std::vector<CurveCell>& cells) {
  std::vector<LevelResult> levels;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto last =
        std::find_if(first, cells.end(), [&](const CurveCell& cell) { return cell.level != first->level; });
    levels.push_back(level_result({first, last}));
    first = last;
  }
  return levels;
}

std::vector<NonMonotoneSeed> non_monotone_seeds(const std::vector<CurveCell>& cells, const CampaignAxis& axis) {
  std::map<int, int> fell_at, survived_at;  // seed -> index of the level
  for (const CurveCell& cell : cells) {     // from the mildest to the hardest
    if (fell(cell)) fell_at.try_emplace(cell.seed, cell.level[0]);
    if (survived(cell)) survived_at[cell.seed] = cell.level[0];
  }
  std::vector<NonMonotoneSeed> seeds;
  for (const auto& [seed, level] : fell_at) {
    const auto harder = survived_at.find(seed);
    if (harder == survived_at.end() || harder->second <= level) continue;
    seeds.push_back(
        {seed, axis.levels[static_cast<std::size_t>(level)], axis.levels[static_cast<std::size_t>(harder->second)]});
  }
  return seeds;
}

}  // namespace dob
