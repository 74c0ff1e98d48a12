#include <fmt/format.h>

#include "results/data_values.h"
#include "results/table_formats.h"

namespace dob {
namespace {

void add_metric(Json& json, std::string_view metric, const MetricSummary& summary) {
  const std::string name(metric);
  json[name] = number_or_null(summary.median);
  json[name + "_worst"] = number_or_null(summary.worst);
  json[name + "_ci95"] = interval_or_null(summary.ci95);
}

void add_pairs(Json& json, const TableRow& row) {
  json["reference"] = text_or_null(row.reference);
  json["paired_runs"] = row.reference.empty() ? Json() : Json(row.paired.front().pairs);
  for (std::size_t i = 0; i < kPairedMetrics.size(); ++i) {
    const std::string name = fmt::format("paired_{}", kPairedMetrics[i].name);
    json[name] = number_or_null(row.paired[i].median);
    json[name + "_ci95"] = interval_or_null(row.paired[i].ci95);
  }
}

void add_timing(Json& json, const std::optional<TimingSummary>& timing) {
  const auto add = [&](const char* name, double TimingSummary::*figure) {
    json[name] = timing ? Json(*timing.*figure) : Json();  // measured by a serial pass only
  };
  add("tick_time_p50_us", &TimingSummary::tick_p50_us);
  add("tick_time_p99_us", &TimingSummary::tick_p99_us);
  add("tick_time_max_us", &TimingSummary::tick_max_us);
  add("qp_time_p50_us", &TimingSummary::qp_p50_us);
  add("qp_time_p99_us", &TimingSummary::qp_p99_us);
  add("qp_time_max_us", &TimingSummary::qp_max_us);
  add("real_time_factor", &TimingSummary::real_time_factor);
}

Json row_to_json(const TableRow& row, bool timing) {
  Json json = key_to_row(row.key);
  json["seeds"] = row.seeds;
  json["runs"] = row.runs;
  json["falls"] = row.falls;
  json["falls_ci95"] = interval_or_null(row.falls_ci95);
  json["errors"] = row.errors;
  json["fall_time_median_s"] = number_or_null(row.fall_time_median_s);
  json["oracle"] = row.oracle;
  json["rank"] = row.rank ? Json(*row.rank) : Json();
  for (std::size_t i = 0; i < kMetricFields.size(); ++i) add_metric(json, kMetricFields[i].name, row.metrics[i]);
  add_pairs(json, row);
  json["fall_reason"] = text_or_null(row.fall_reason);
  json["error_reason"] = text_or_null(row.error_reason);
  if (timing) add_timing(json, row.timing);
  return json;
}

Json shadow_to_json(const ShadowRow& row) {
  Json json = key_to_row(row.key);
  json["shadow_observer"] = row.observer;
  json["shadow_profile"] = row.profile;
  json["in_loop"] = row.in_loop;
  json["runs"] = row.runs;
  for (std::size_t i = 0; i < kEstimateMetrics.size(); ++i) {
    add_metric(json, kEstimateMetrics[i].name, row.metrics[i]);
  }
  return json;
}

template <typename Rows, typename ToJson>
std::string json_array(const Rows& rows, ToJson to_json) {
  Json json = Json::array();
  for (const auto& row : rows) json.push_back(to_json(row));
  return json_text(json);
}

template <typename Row, typename ToJson>
std::string csv_table(const std::vector<Row>& rows, ToJson to_json) {
  std::string csv = csv_heading(to_json(Row{}));
  for (const Row& row : rows) csv += csv_line(to_json(row));
  return csv;
}

}  // namespace

std::string table_json(const std::vector<TableRow>& rows, bool timing) {
  return json_array(rows, [&](const TableRow& row) { return row_to_json(row, timing); });
}

std::string table_csv(const std::vector<TableRow>& rows, bool timing) {
  return csv_table(rows, [&](const TableRow& row) { return row_to_json(row, timing); });
}

std::string shadow_json(const std::vector<ShadowRow>& rows) {
  return json_array(rows, shadow_to_json);
}

std::string shadow_csv(const std::vector<ShadowRow>& rows) {
  return csv_table(rows, shadow_to_json);
}

}  // namespace dob
