// What campaigns have found, made by hand for the tests of pages and figures.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/campaign_result.h"
#include "test/results/run_samples.h"

namespace dob::test {

inline LevelResult level_result(std::array<int, 2> level, int trials, int falls,
                                std::optional<double> com_error_m = std::nullopt) {
  LevelResult result;
  result.level = level;
  result.planned = trials;
  result.trials = trials;
  result.falls = falls;
  result.falls_ci = wilson_interval(falls, trials);
  result.com_error_m = com_error_m;
  if (com_error_m && trials - falls >= 8) result.com_error_ci = Interval{0.8 * *com_error_m, 1.3 * *com_error_m};
  return result;
}

inline FallThreshold threshold(double estimate, double low, double high, bool below = false, bool above = false) {
  return {estimate, {low, high}, below, above};
}

// One curve over the campaign's first axis (and second one), its trials counted from its levels.
inline CurveResult curve_result(CellKey key, std::vector<int> axes, std::vector<LevelResult> levels) {
  CurveResult result;
  key.seed = 0;
  result.curve = {std::move(key), std::move(axes), {}};
  for (const LevelResult& level : levels) {
    result.trials += level.trials;
    result.falls += level.falls;
    result.errors += level.errors;
    result.seeds = std::max(result.seeds, level.trials);
  }
  result.levels = std::move(levels);
  return result;
}

inline CampaignResult campaign_of(CampaignKind kind, std::vector<CampaignAxis> axes, std::vector<CurveResult> curves) {
  CampaignResult result;
  result.campaign.kind = kind;
  result.campaign.name = "push";
  result.campaign.summary = "How hard a push may be";
  result.campaign.document = "kind = \"limit\"\n";
  result.campaign.axes = std::move(axes);
  for (const CurveResult& curve : curves) {
    result.campaign.curves.push_back(curve.curve);
    result.planned += static_cast<std::size_t>(curve.trials);
  }
  result.curves = std::move(curves);
  return result;
}

inline CampaignAxis amplitude() {
  return {"amplitude", "N", {20.0, 40.0, 80.0}, true};
}

// Two observers of case1/tip_lateral pushed with 20, 40 and 80 N, twelve seeds each; the second one never fell.
inline CampaignResult limit_result() {
  CurveResult momentum = curve_result(
      key("case1", "tip_lateral", "momentum", "tuned", 0), {0},
      {level_result({0, 0}, 12, 0, 0.01), level_result({1, 0}, 12, 6, 0.03), level_result({2, 0}, 12, 12)});
  momentum.half = threshold(40.0, 34.0, 47.0);
  momentum.twentieth = threshold(28.0, 19.0, 35.0, true);
  momentum.non_monotone = {{7, 40.0, 80.0}};
  CurveResult none = curve_result(key("case1", "tip_lateral", "none", "-", 0), {0},
                                  {level_result({0, 0}, 12, 0, 0.02), level_result({2, 0}, 12, 0, 0.05)});
  none.half = threshold(130.0, 90.0, 160.0, false, true);
  return campaign_of(CampaignKind::kLimit, {amplitude()}, {momentum, none});
}

// Delay against bandwidth; of the four pairs one was not run, and nothing survived in another.
inline CampaignResult map_result() {
  LevelResult open = level_result({1, 1}, 0, 0);
  open.planned = 12;
  const std::vector<LevelResult> levels{level_result({0, 0}, 12, 0, 0.004), level_result({0, 1}, 12, 3, 0.03),
                                        level_result({1, 0}, 12, 12), open};
  return campaign_of(CampaignKind::kMap,
                     {{"delay", "ms", {0.0, 4.0}, false}, {"bandwidth", "rad/s", {100.0, 10.0}, true}},
                     {curve_result(key("case1", "tip_lateral", "momentum", "tuned", 0), {0, 1}, levels)});
}

inline CampaignResult factorial_result() {
  CurveResult curve = curve_result(key("case1", "", "momentum", "tuned", 0), {}, {level_result({0, 0}, 12, 3, 0.02)});
  curve.curve.factors = {"case1", "momentum"};
  CampaignResult result = campaign_of(CampaignKind::kFactorial, {}, {curve});
  result.campaign.factors = {"scenario", "leg estimator"};
  result.factorial = {
      {"falls", 480, 20, {{"leg estimator", 4, 0.61, Interval{0.55, 0.66}}, {"residual", 0, 0.39, std::nullopt}}}};
  return result;
}

}  // namespace dob::test
