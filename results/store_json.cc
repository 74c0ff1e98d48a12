#include "results/store_json.h"

#include <array>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "results/metric_fields.h"

namespace dob {
namespace {

constexpr int kFormat = 1;
constexpr std::array<std::string_view, 3> kOutcomes{"survived", "fell", "error"};

Json key_to_json(const CellKey& key) {
  return {{"scenario", key.scenario}, {"variant", key.variant},    {"observer", key.observer},
          {"profile", key.profile},   {"gains", key.gains},        {"planner", key.planner},
          {"seed", key.seed},         {"overrides", key.overrides}};
}

Outcome outcome_from(const std::string& name) {
  for (std::size_t i = 0; i < kOutcomes.size(); ++i) {
    if (kOutcomes[i] == name) return static_cast<Outcome>(i);
  }
  throw std::invalid_argument(fmt::format("outcome '{}', allowed: survived, fell, error", name));
}

std::uint64_t hash_from(const std::string& hex) {
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), hash, 16);
  if (hex.size() != 16 || error != std::errc{} || end != hex.data() + hex.size()) {
    throw std::invalid_argument(fmt::format("state_hash '{}', allowed: 16 hexadecimal digits", hex));
  }
  return hash;
}

}  // namespace

Json to_json(const RunInfo& info) {
  Json cells = Json::array();
  for (const CellKey& key : info.cells) cells.push_back(key_to_json(key));
  return {{"format", kFormat},
          {"command_line", info.command_line},
          {"version", info.version},
          {"commit", info.commit},
          {"build", info.build},
          {"compiler", info.compiler},
          {"flags", info.flags},
          {"machine", {{"cpu", info.machine.cpu}, {"cores", info.machine.cores}, {"os", info.machine.os}}},
          {"date", info.date},
          {"cells", std::move(cells)}};
}

RunInfo run_info_from_json(const Json& json) {
  if (const int format = json.at("format").get<int>(); format != kFormat) {
    throw std::invalid_argument(fmt::format("run directory of format {}, this program reads {}", format, kFormat));
  }
  RunInfo info;
  json.at("command_line").get_to(info.command_line);
  json.at("version").get_to(info.version);
  json.at("commit").get_to(info.commit);
  json.at("build").get_to(info.build);
  json.at("compiler").get_to(info.compiler);
  json.at("flags").get_to(info.flags);
  json.at("machine").at("cpu").get_to(info.machine.cpu);
  json.at("machine").at("cores").get_to(info.machine.cores);
  json.at("machine").at("os").get_to(info.machine.os);
  json.at("date").get_to(info.date);
  for (const Json& key : json.at("cells")) info.cells.push_back(key_from_json(key));
  return info;
}

Json to_json(const CellResult& cell) {
  Json json = key_to_json(cell.key);
  json["outcome"] = kOutcomes.at(static_cast<std::size_t>(cell.outcome));
  json["reason"] = cell.reason;
  json["simulated_s"] = cell.simulated_s;
  json["state_hash"] = fmt::format("{:016x}", cell.state_hash);
  for (const MetricField& field : kMetricFields) {
    if (field.value == nullptr) continue;
    const std::optional<double>& value = cell.metrics.*field.value;
    json[std::string(field.name)] = value ? Json(*value) : Json();  // what is not finite is written as null
  }
  json["qp_solves"] = cell.metrics.qp_solves;
  json["qp_failures"] = cell.metrics.qp_failures;
  json["planner_failures"] = cell.metrics.planner_failures;
  return json;
}

Json timing_to_json(const CellResult& cell) {
  Json json = key_to_json(cell.key);
  json["wall_s"] = cell.wall_s;
  return json;
}

CellKey key_from_json(const Json& json) {
  CellKey key;
  json.at("scenario").get_to(key.scenario);
  json.at("variant").get_to(key.variant);
  json.at("observer").get_to(key.observer);
  json.at("profile").get_to(key.profile);
  json.at("gains").get_to(key.gains);
  json.at("planner").get_to(key.planner);
  json.at("seed").get_to(key.seed);
  json.at("overrides").get_to(key.overrides);
  return key;
}

CellResult cell_from_json(const Json& json) {
  CellResult cell;
  cell.key = key_from_json(json);
  cell.outcome = outcome_from(json.at("outcome").get<std::string>());
  json.at("reason").get_to(cell.reason);
  json.at("simulated_s").get_to(cell.simulated_s);
  cell.state_hash = hash_from(json.at("state_hash").get<std::string>());
  for (const MetricField& field : kMetricFields) {
    if (field.value == nullptr) continue;
    const Json& value = json.at(std::string(field.name));
    if (!value.is_null()) cell.metrics.*field.value = value.get<double>();
  }
  json.at("qp_solves").get_to(cell.metrics.qp_solves);
  json.at("qp_failures").get_to(cell.metrics.qp_failures);
  json.at("planner_failures").get_to(cell.metrics.planner_failures);
  return cell;
}

std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string cell_to_line(const CellResult& cell) {
  Json json = to_json(cell);
  json["wall_s"] = cell.wall_s;
  return one_line(json);
}

CellResult cell_from_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    CellResult cell = cell_from_json(json);
    json.at("wall_s").get_to(cell.wall_s);
    return cell;
  } catch (const std::exception& error) {
    throw StoreError(fmt::format("a cell's line cannot be read: {}", error.what()));
  }
}

}  // namespace dob
