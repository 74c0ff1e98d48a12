#include "results/data_values.h"

#include <fmt/format.h>

namespace dob {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

bool is_interval(const std::string& name) {
  return name.ends_with("_ci95");
}

}  // namespace

Json key_to_row(const CellKey& key) {
  return {{"scenario", key.scenario}, {"variant", key.variant}, {"observer", key.observer},  {"profile", key.profile},
          {"gains", key.gains},       {"planner", key.planner}, {"overrides", key.overrides}};
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string csv_value(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? quoted(value.get<std::string>()) : one_line(value);
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

}  // namespace dob
