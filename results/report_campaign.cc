#include "results/report_campaign.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "results/report_data.h"
#include "results/report_index.h"
#include "results/report_text.h"

namespace dob {
namespace {

constexpr std::size_t kMostReasons = 20;

// Seven digits are more than any of it is good for.
Json rounded_json(double x) {
  return std::stod(fmt::format("{:.7g}", x));
}

Json rounded_json(const std::optional<double>& x) {
  return x ? rounded_json(*x) : Json();
}

Json interval_json(const std::optional<Interval>& interval) {
  return interval ? Json{rounded_json(interval->low), rounded_json(interval->high)} : Json();
}

Json axis_json(const CampaignAxis& axis) {
  return {{"name", axis.name}, {"unit", axis.unit}, {"levels", axis.levels}, {"logarithmic", axis.logarithmic}};
}

Json level_json(const LevelResult& level) {
  return {{"level", level.level},
          {"planned", level.planned},
          {"trials", level.trials},
          {"falls", level.falls},
          {"errors", level.errors},
          {"falls_ci95", interval_json(level.falls_ci)},
          {"com_error_m", rounded_json(level.com_error_m)},
          {"com_error_ci95", interval_json(level.com_error_ci)},
          {"foot_error_m", rounded_json(level.foot_error_m)},
          {"foot_error_ci95", interval_json(level.foot_error_ci)}};
}

Json threshold_json(const std::optional<FallThreshold>& threshold) {
  if (!threshold) return {};
  return {{"estimate", rounded_json(threshold->estimate)},
          {"ci95", interval_json(threshold->interval)},
          {"below", threshold->below},
          {"above", threshold->above}};
}

Json seed_json(const NonMonotoneSeed& seed) {
  return {{"seed", seed.seed}, {"fell_at", seed.fell_at}, {"survived_at", seed.survived_at}};
}

template <typename Value>
Json list_json(const std::vector<Value>& values, Json (*of)(const Value&)) {
  Json list = Json::array();
  for (const Value& value : values) list.push_back(of(value));
  return list;
}

Json curve_json(const CurveResult& result, const ReportIndex& index) {
  Json json = index.ids(result.curve.key);
  json["axes"] = result.curve.axes;
  json["factors"] = result.curve.factors;
  json["levels"] = list_json(result.levels, level_json);
  json["fall_50"] = threshold_json(result.half);
  json["fall_5"] = threshold_json(result.twentieth);
  json["non_monotone"] = list_json(result.non_monotone, seed_json);
  json["seeds"] = result.seeds;
  json["trials"] = result.trials;
  json["falls"] = result.falls;
  json["errors"] = result.errors;
  return json;
}

Json share_json(const VarianceShare& share) {
  return {{"factor", share.factor},
          {"levels", share.levels},
          {"share", rounded_json(share.share)},
          {"ci95", interval_json(share.interval)}};
}

Json factorial_json(const FactorialResult& result) {
  return {{"response", result.response},
          {"trials", result.trials},
          {"left_out", result.left_out},
          {"shares", list_json(result.shares, share_json)}};
}

// Why cells could not be run, the most frequent reason first.
Json reasons_json(const Run& run) {
  std::map<std::string, std::size_t> counts;
  for (const CellResult& cell : run.cells) {
    if (cell.outcome == Outcome::kError) ++counts[without_directories(cell.reason)];
  }
  std::vector<std::pair<std::string, std::size_t>> reasons(counts.begin(), counts.end());
  std::stable_sort(reasons.begin(), reasons.end(), [](auto& a, auto& b) { return a.second > b.second; });
  reasons.resize(std::min(reasons.size(), kMostReasons));
  Json list = Json::array();
  for (const auto& [reason, cells] : reasons) list.push_back({{"reason", reason}, {"cells", cells}});
  return list;
}

// The seed of a curve's key is 0, its overrides and observer may be none that a cell has: names of its own.
ReportIndex index_of_curves(const CampaignResult& result) {
  CellKeys keys;
  for (const CurveResult& curve : result.curves) keys.push_back(curve.curve.key);
  return ReportIndex(keys);
}

}  // namespace

Json campaign_json(const std::optional<CampaignResult>& result, const Run& run) {
  if (!result) return {};
  const Campaign& campaign = result->campaign;
  const ReportIndex index = index_of_curves(*result);
  constexpr std::array kKinds{"limit", "map", "breakdown", "factorial"};
  Json json{{"kind", kKinds.at(static_cast<std::size_t>(campaign.kind))},
            {"name", campaign.name},
            {"summary", campaign.summary},
            {"document", without_directories(campaign.document)},
            {"axes", list_json(campaign.axes, axis_json)},
            {"factors", campaign.factors},
            {"planned", result->planned},
            {"finished", run.cells.size()},
            {"observers", observers_json(index)},
            {"settings", settings_json(index)}};
  json["curves"] = Json::array();
  for (const CurveResult& curve : result->curves) json["curves"].push_back(curve_json(curve, index));
  json["factorial"] = list_json(result->factorial, factorial_json);
  json["reasons"] = reasons_json(run);
  return json;
}

Run run_with_series(const Run& run, const Campaign& campaign) {
  std::map<CellKey, const CellResult*> with_series;
  for (const CellResult& cell : run.cells) {
    if (!cell.trace.empty()) with_series[cell.key] = &cell;
  }
  Run part;
  part.info = run.info;
  part.info.cells.clear();
  part.info.sources.clear();
  std::set<std::tuple<std::size_t, int, int>> taken;  // curve and levels
  for (std::size_t i = 0; i < std::min(run.info.cells.size(), campaign.cells.size()); ++i) {
    const auto found = with_series.find(run.info.cells[i]);
    const auto& [curve, level] = campaign.cells[i];
    if (found == with_series.end() || !taken.emplace(curve, level[0], level[1]).second) continue;
    part.info.cells.push_back(found->first);
    if (i < run.info.sources.size()) part.info.sources.push_back(run.info.sources[i]);
    part.cells.push_back(*found->second);
  }
  const std::set<CellKey> keys(part.info.cells.begin(), part.info.cells.end());
  for (const CellTiming& timing : run.timings) {
    if (keys.contains(timing.key)) part.timings.push_back(timing);
  }
  return part;
}

}  // namespace dob
