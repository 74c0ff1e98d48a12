#include "results/campaign_result.h"

#include <set>

#include "results/campaign_cells.h"
#include "results/campaign_factorial.h"
#include "results/campaign_levels.h"

namespace dob {
namespace {

// One for each level of the axis, those without trials too.
std::vector<LevelCount> level_counts(const CampaignAxis& axis, const std::vector<LevelResult>& levels) {
  std::vector<LevelCount> counts;
  for (const double level : axis.levels) counts.push_back({level});
  for (const LevelResult& level : levels) {
    LevelCount& count = counts[static_cast<std::size_t>(level.level[0])];
    count.trials = level.trials;
    count.falls = level.falls;
  }
  return counts;
}

// What only a curve over one axis has.
void add_thresholds(const CampaignAxis& axis, const std::vector<CurveCell>& cells, CurveResult& result) {
  result.non_monotone = non_monotone_seeds(cells, axis);
  if (result.trials == 0) return;
  const std::vector<LevelCount> counts = level_counts(axis, result.levels);
  result.half = fall_threshold(counts, axis.logarithmic, 0.5);
  result.twentieth = fall_threshold(counts, axis.logarithmic, 0.05);
}

CurveResult curve_result(const Campaign& campaign, const CampaignCurve& curve, const std::vector<CurveCell>& cells) {
  CurveResult result;
  result.curve = curve;
  result.levels = level_results(cells);
  for (const LevelResult& level : result.levels) {
    result.trials += level.trials;
    result.falls += level.falls;
    result.errors += level.errors;
  }
  std::set<int> seeds;
  for (const CurveCell& cell : cells) {
    if (survived(cell) || fell(cell)) seeds.insert(cell.seed);
  }
  result.seeds = static_cast<int>(seeds.size());
  if (curve.axes.size() == 1) {
    add_thresholds(campaign.axes[static_cast<std::size_t>(curve.axes[0])], cells, result);
  }
  return result;
}

}  // namespace

CampaignResult campaign_result(const Campaign& campaign, const Run& run) {
  const std::vector<std::vector<CurveCell>> cells = cells_of_curves(campaign, run);
  CampaignResult result;
  result.campaign = campaign;
  result.planned = campaign.cells.size();
  for (std::size_t i = 0; i < campaign.curves.size(); ++i) {
    result.curves.push_back(curve_result(campaign, campaign.curves[i], cells[i]));
  }
  if (campaign.kind == CampaignKind::kFactorial) result.factorial = factorial_results(campaign, cells);
  return result;
}

}  // namespace dob
