#include "results/claims_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/data_values.h"

namespace dob {
namespace {

Json holds(Verdict verdict) {
  return verdict == Verdict::kNoData ? Json() : Json(verdict == Verdict::kYes);
}

Json to_json(const ContrastFinding& contrast) {
  return {{"name", contrast.name},
          {"recorded", contrast.recorded},
          {"holds", holds(contrast.finding.verdict)},
          {"measured", contrast.finding.measured},
          {"worst", number_or_null(contrast.finding.worst)}};
}

Json row_to_json(const ClaimRow& row) {
  const Claim& claim = *row.claim;
  const Finding& finding = row.finding;
  return {{"id", claim.id},
          {"case", claim.study},
          {"cells", row.cells},
          {"claim", claim.text},
          {"kind", claim.kind},
          {"source", claim.source},
          {"paper", claim.paper},
          {"observer", fmt::format("{}", fmt::join(claim.observers, "; "))},
          {"profile", text_or_null(row.setting.profile)},
          {"gains", text_or_null(row.setting.gains)},
          {"planner", text_or_null(row.setting.planner)},
          {"overrides", row.setting.overrides},
          {"runs", finding.runs},
          {"falls", finding.falls},
          {"fall_time_median_s", number_or_null(finding.fall_time_median_s)},
          {"measured", finding.measured},
          {"median", number_or_null(finding.median)},
          {"worst", number_or_null(finding.worst)},
          {"holds", holds(finding.verdict)},
          {"ours_measured", row.ours ? Json(row.ours->measured) : Json()},
          {"ours_holds", row.ours ? holds(row.ours->verdict) : Json()},
          {"note", row.note}};
}

}  // namespace

std::string claims_json(const std::vector<ClaimRow>& rows) {
  Json json = Json::array();
  for (const ClaimRow& row : rows) {
    json.push_back(row_to_json(row));
    Json contrasts = Json::array();
    for (const ContrastFinding& contrast : row.contrasts) contrasts.push_back(to_json(contrast));
    json.back()["contrasts"] = std::move(contrasts);
  }
  return json_text(json);
}

std::string claims_csv(const std::vector<ClaimRow>& rows) {
  const Claim no_claim;
  std::string csv = csv_heading(row_to_json({.claim = &no_claim}));
  for (const ClaimRow& row : rows) csv += csv_line(row_to_json(row));
  return csv;
}

}  // namespace dob
