#include "results/campaign_cells.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

namespace dob {
namespace {

bool has_outcome(const CurveCell& cell, Outcome outcome) noexcept {
  return cell.result != nullptr && cell.result->outcome == outcome;
}

void check_axes(const Campaign& campaign) {
  for (const CampaignCurve& curve : campaign.curves) {
    if (curve.axes.size() > 2) {
      throw std::invalid_argument(fmt::format("campaign: a curve of {} axes, allowed: at most 2", curve.axes.size()));
    }
    for (const int axis : curve.axes) {
      if (axis >= 0 && static_cast<std::size_t>(axis) < campaign.axes.size()) continue;
      throw std::invalid_argument(fmt::format("campaign: a curve over axis {} of {}", axis, campaign.axes.size()));
    }
  }
}

void check_place(const Campaign& campaign, const CampaignCell& cell) {
  if (cell.curve >= campaign.curves.size()) {
    throw std::invalid_argument(fmt::format("campaign: a cell of curve {} of {}", cell.curve, campaign.curves.size()));
  }
  const std::vector<int>& axes = campaign.curves[cell.curve].axes;
  for (std::size_t i = 0; i < cell.level.size(); ++i) {
    const std::size_t levels = i < axes.size() ? campaign.axes[static_cast<std::size_t>(axes[i])].levels.size() : 1;
    if (cell.level[i] >= 0 && static_cast<std::size_t>(cell.level[i]) < levels) continue;
    throw std::invalid_argument(fmt::format("campaign: a cell at level {} of {}", cell.level[i], levels));
  }
}

}  // namespace

bool survived(const CurveCell& cell) noexcept {
  return has_outcome(cell, Outcome::kSurvived);
}

bool fell(const CurveCell& cell) noexcept {
  return has_outcome(cell, Outcome::kFell);
}

bool has_error(const CurveCell& cell) noexcept {
  return has_outcome(cell, Outcome::kError);
}

std::vector<std::vector<CurveCell>> cells_of_curves(const Campaign& campaign, const Run& run) {
  if (campaign.cells.size() != run.info.cells.size()) {
    throw std::invalid_argument(
        fmt::format("campaign: {} cells, but its run has {}", campaign.cells.size(), run.info.cells.size()));
  }
  check_axes(campaign);
  std::map<CellKey, const CellResult*> results;
  for (const CellResult& cell : run.cells) results[cell.key] = &cell;
  std::vector<std::vector<CurveCell>> curves(campaign.curves.size());
  for (std::size_t i = 0; i < campaign.cells.size(); ++i) {
    const CampaignCell& place = campaign.cells[i];
    check_place(campaign, place);
    const CellKey key = run.info.cells[i];
    const auto result = results.find(key);
    curves[place.curve].push_back({place.level, key.seed, result == results.end() ? nullptr : result->second});
  }
  for (std::vector<CurveCell>& cells : curves) {
    std::stable_sort(cells.begin(), cells.end(), [](const CurveCell& a, const CurveCell& b) {
      return std::tie(a.level, a.seed) < std::tie(b.level, b.seed);
    });
  }
  return curves;
}

}  // namespace dob
