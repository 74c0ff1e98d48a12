#include "results/campaign_data.h"

#include <algorithm>
#include <array>

#include "results/campaign_ranks.h"
#include "results/campaign_text.h"
#include "results/data_values.h"
#include "results/store_json.h"

namespace dob {
namespace {

// Name and unit of a curve's axes, null where it has none.
void add_axes(const CurveResult& curve, const Campaign& campaign, Json& json) {
  constexpr std::array<std::array<const char*, 2>, 2> kNames{{{"axis", "unit"}, {"axis_2", "unit_2"}}};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const bool has = i < curve.curve.axes.size();
    const CampaignAxis axis = has ? campaign.axes[static_cast<std::size_t>(curve.curve.axes[i])] : CampaignAxis{};
    json[kNames[i][0]] = has ? Json(axis.name) : Json();
    json[kNames[i][1]] = has ? Json(axis.unit) : Json();
  }
}

// "leg estimator" -> "factor_leg_estimator"
std::string factor_field(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return "factor_" + name;
}

void add_threshold(const std::string& name, const std::optional<FallThreshold>& threshold, Json& json) {
  json[name + "_level"] = threshold ? Json(threshold->estimate) : Json();
  json[name + "_level_ci95"] = interval_or_null(threshold ? std::optional(threshold->interval) : std::nullopt);
  json[name + "_below"] = threshold ? Json(threshold->below) : Json();
  json[name + "_above"] = threshold ? Json(threshold->above) : Json();
}

Json curve_to_json(const CurveResult& curve, const std::optional<int>& rank, const Campaign& campaign) {
  Json json = key_to_row(curve.curve.key);
  for (std::size_t i = 0; i < campaign.factors.size(); ++i) {
    json[factor_field(campaign.factors[i])] = i < curve.curve.factors.size() ? Json(curve.curve.factors[i]) : Json();
  }
  add_axes(curve, campaign, json);
  json["curve_seeds"] = curve.seeds;
  json["curve_trials"] = curve.trials;
  json["curve_falls"] = curve.falls;
  json["curve_errors"] = curve.errors;
  json["rank"] = rank ? Json(*rank) : Json();
  add_threshold("half", curve.half, json);
  add_threshold("twentieth", curve.twentieth, json);
  json["non_monotone_seeds"] = curve.non_monotone.size();
  return json;
}

Json level_to_json(const LevelResult& level, const CampaignCurve& curve, const Campaign& campaign) {
  const auto value = [&](std::size_t i) {
    if (i >= curve.axes.size()) return Json();
    return Json(
        campaign.axes[static_cast<std::size_t>(curve.axes[i])].levels[static_cast<std::size_t>(level.level[i])]);
  };
  return {{"level", value(0)},
          {"level_2", value(1)},
          {"planned", level.planned},
          {"trials", level.trials},
          {"falls", level.falls},
          {"falls_ci95", interval_or_null(level.falls_ci)},
          {"errors", level.errors},
          {"com_error_max_m", number_or_null(level.com_error_m)},
          {"com_error_max_m_ci95", interval_or_null(level.com_error_ci)},
          {"foot_error_max_m", number_or_null(level.foot_error_m)},
          {"foot_error_max_m_ci95", interval_or_null(level.foot_error_ci)}};
}

Json factorial_to_json(const FactorialResult& factorial) {
  Json shares = Json::array();
  for (const VarianceShare& share : factorial.shares) {
    shares.push_back({{"factor", share.factor},
                      {"levels", share.levels},
                      {"share", share.share},
                      {"share_ci95", interval_or_null(share.interval)}});
  }
  return {{"response", factorial.response},
          {"trials", factorial.trials},
          {"left_out", factorial.left_out},
          {"shares", std::move(shares)}};
}

// With what only JSON has room for.
Json nested_curve(const CurveResult& curve, const std::optional<int>& rank, const Campaign& campaign) {
  Json json = curve_to_json(curve, rank, campaign);
  json["non_monotone"] = Json::array();
  for (const NonMonotoneSeed& seed : curve.non_monotone) {
    json["non_monotone"].push_back({{"seed", seed.seed}, {"fell_at", seed.fell_at}, {"survived_at", seed.survived_at}});
  }
  json["levels"] = Json::array();
  for (const LevelResult& level : curve.levels) json["levels"].push_back(level_to_json(level, curve.curve, campaign));
  return json;
}

Json joined(Json a, const Json& b) {
  a.update(b);
  return a;
}

}  // namespace

std::string campaign_json(const CampaignResult& result) {
  const Campaign& campaign = result.campaign;
  const std::vector<std::optional<int>> ranks = campaign_ranks(result);
  Json json{{"kind", kind_name(campaign.kind)},
            {"name", campaign.name},
            {"summary", campaign.summary},
            {"planned", result.planned},
            {"factors", campaign.factors}};
  for (const char* name : {"axes", "curves", "factorial"}) json[name] = Json::array();
  for (const CampaignAxis& axis : campaign.axes) json["axes"].push_back(axis_to_json(axis));
  for (std::size_t i = 0; i < result.curves.size(); ++i) {
    json["curves"].push_back(nested_curve(result.curves[i], ranks[i], campaign));
  }
  for (const FactorialResult& factorial : result.factorial) json["factorial"].push_back(factorial_to_json(factorial));
  return json_text(json);
}

std::string campaign_csv(const CampaignResult& result) {
  const Campaign& campaign = result.campaign;
  const std::vector<std::optional<int>> ranks = campaign_ranks(result);
  std::string csv = csv_heading(joined(curve_to_json({}, {}, campaign), level_to_json({}, {}, campaign)));
  for (std::size_t i = 0; i < result.curves.size(); ++i) {
    const CurveResult& curve = result.curves[i];
    const Json head = curve_to_json(curve, ranks[i], campaign);
    for (const LevelResult& level : curve.levels) {
      csv += csv_line(joined(head, level_to_json(level, curve.curve, campaign)));
    }
  }
  return csv;
}

}  // namespace dob
