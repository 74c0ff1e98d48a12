#include <fmt/format.h>

#include "results/store_json.h"
#include "results/table_formats.h"

namespace dob {
namespace {

Json number_or_null(const std::optional<double>& x) {
  return x ? Json(*x) : Json();
}

Json interval_or_null(const std::optional<Interval>& x) {
  return x ? Json::array({x->low, x->high}) : Json();
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

void add_timing(Json& json, const TableRow& row) {
  for (const char* name :
       {"tick_time_p50_us", "tick_time_p99_us", "tick_time_max_us", "qp_time_p50_us", "qp_time_p99_us"}) {
    json[name] = nullptr;  // measured by a serial pass only
  }
  json["real_time_factor"] = number_or_null(row.real_time_factor);
}

Json row_to_json(const TableRow& row, bool timing) {
  const CellKey& key = row.key;
  Json json{{"scenario", key.scenario},
            {"variant", key.variant},
            {"observer", key.observer},
            {"profile", key.profile},
            {"gains", key.gains},
            {"planner", key.planner},
            {"overrides", key.overrides},
            {"seeds", row.seeds},
            {"runs", row.runs},
            {"falls", row.falls},
            {"falls_ci95", interval_or_null(row.falls_ci95)},
            {"errors", row.errors},
            {"fall_time_median_s", number_or_null(row.fall_time_median_s)}};
  for (std::size_t i = 0; i < kMetricFields.size(); ++i) {
    const std::string name(kMetricFields[i].name);
    json[name] = number_or_null(row.metrics[i].median);
    json[name + "_worst"] = number_or_null(row.metrics[i].worst);
    json[name + "_ci95"] = interval_or_null(row.metrics[i].ci95);
  }
  json["fall_reason"] = text_or_null(row.fall_reason);
  json["error_reason"] = text_or_null(row.error_reason);
  if (timing) add_timing(json, row);
  return json;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string csv_value(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? quoted(value.get<std::string>()) : one_line(value);
}

bool is_interval(const std::string& name) {
  return name.ends_with("_ci95");
}

std::string csv_heading(const Json& row) {
  std::string line;
  for (const auto& [name, value] : row.items()) {
    line += is_interval(name) ? fmt::format("{0}_low,{0}_high,", name) : name + ",";
  }
  line.back() = '\n';
  return line;
}

std::string csv_line(const Json& row) {
  std::string line;
  for (const auto& [name, value] : row.items()) {
    if (!is_interval(name)) {
      line += csv_value(value) + ",";
    } else {
      line += value.is_null() ? ",," : fmt::format("{},{},", csv_value(value[0]), csv_value(value[1]));
    }
  }
  line.back() = '\n';
  return line;
}

}  // namespace

std::string table_json(const std::vector<TableRow>& rows, bool timing) {
  Json json = Json::array();
  for (const TableRow& row : rows) json.push_back(row_to_json(row, timing));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string table_csv(const std::vector<TableRow>& rows, bool timing) {
  std::string csv = csv_heading(row_to_json({}, timing));
  for (const TableRow& row : rows) csv += csv_line(row_to_json(row, timing));
  return csv;
}

}  // namespace dob
