#include "results/figure_campaign.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/campaign_blocks.h"
#include "results/figure_campaign_parts.h"

namespace dob {
namespace {

bool asked_for(const CellKey& key, const FigureRequest& request) {
  const auto fits = [](const std::string& wish, const std::string& value) { return wish.empty() || wish == value; };
  const std::vector<std::string>& observers = request.observers;
  return (fits(request.profile, key.profile) || key.profile == "-") && fits(request.gains, key.gains) &&
         fits(request.planner, key.planner) &&
         (observers.empty() || std::find(observers.begin(), observers.end(), key.observer) != observers.end());
}

// The blocks with the curves that are asked for, without those that have none left.
std::vector<CampaignBlock> blocks_of(const CampaignResult& result, const FigureRequest& request) {
  std::vector<CampaignBlock> blocks = campaign_blocks(result);
  for (CampaignBlock& block : blocks) {
    std::erase_if(block.curves, [&](const CurveResult* c) { return !asked_for(c->curve.key, request); });
  }
  std::erase_if(blocks, [](const CampaignBlock& block) { return block.curves.empty(); });
  return blocks;
}

CampaignFigure described(const std::string& id, const std::string& caption, Figure figure) {
  CampaignFigure made;
  made.spec.id = figure.id = id;
  made.spec.caption = caption;
  made.figure = std::move(figure);
  return made;
}

void add_block(const CampaignResult& result, const CampaignBlock& block, std::size_t number,
               std::vector<CampaignFigure>& figures) {
  const Campaign& campaign = result.campaign;
  const std::string name = block_name(block, campaign);
  if (campaign.kind == CampaignKind::kMap) {
    const std::string id = fmt::format("map{:02}", number);
    figures.push_back(described(id, "Share of falls, " + name, heat_map_figure(campaign, block, HeatMapValue::kFalls)));
    figures.push_back(
        described(id + "_com", "Median CoM error, " + name, heat_map_figure(campaign, block, HeatMapValue::kComError)));
    return;
  }
  const char* kind = campaign.kind == CampaignKind::kLimit ? "limit" : "breakdown";
  figures.push_back(described(fmt::format("{}{:02}", kind, number), "Falls and CoM error over the level, " + name,
                              fall_curves_figure(campaign, block)));
}

}  // namespace

std::vector<CampaignFigure> campaign_figures(const CampaignResult& result, const FigureRequest& request) {
  std::vector<CampaignFigure> figures;
  if (result.campaign.kind == CampaignKind::kFactorial) {
    if (result.factorial.empty()) throw StoreError("the campaign has no shares of variance yet");
    figures.push_back(
        described("factorial", "Shares of the variance, " + result.campaign.name, variance_figure(result)));
    return figures;
  }
  std::size_t number = 0;
  for (const CampaignBlock& block : blocks_of(result, request)) add_block(result, block, ++number, figures);
  if (figures.empty()) throw StoreError("the campaign has no curve of these observers, profile, gains and planner");
  return figures;
}

std::vector<CurveLook> curve_looks(const CampaignBlock& block) {
  std::vector<std::string> observers;
  for (const CurveResult* curve : block.curves) observers.push_back(curve->curve.key.observer);
  const std::map<std::string, FigureLook> looks = observer_looks(observers);
  std::vector<CurveLook> list;
  for (std::size_t i = 0; i < block.curves.size(); ++i) {
    const CellKey& key = block.curves[i]->curve.key;
    const auto before = std::count(observers.begin(), observers.begin() + static_cast<std::ptrdiff_t>(i), key.observer);
    CurveLook look{key.observer, looks.at(key.observer)};
    if (std::count(observers.begin(), observers.end(), key.observer) > 1) look.label += "@" + key.profile;
    if (before > 0) look.look.dash = {2.0 / static_cast<double>(before), 2.0};  // another profile
    list.push_back(std::move(look));
  }
  return list;
}

}  // namespace dob
