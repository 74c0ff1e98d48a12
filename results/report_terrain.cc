#include "results/report_terrain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "results/report_text.h"
#include "scenarios/laid_terrain.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

// Names of the scenarios that a batch runs which names none.
std::set<std::string> paper_set() {
  std::set<std::string> names;
  try {
    for (const ScenarioInfo& info : list_scenarios()) {
      if (info.set == ScenarioSet::kPaper) names.insert(info.name);
    }
  } catch (const InputError&) {  // somebody's own scenarios are not right; nothing depends on them here
    names.clear();
  }
  return names;
}

// The names of the resolved files, by scenario; those of the first setting.
std::map<std::size_t, std::string> files_of(const RunInfo& info, const ReportIndex& index) {
  std::map<std::size_t, std::string> files;
  for (std::size_t i = 0; i < std::min(info.cells.size(), info.sources.size()); ++i) {
    files.emplace(index.scenario(info.cells[i]), info.sources[i].scenario);
  }
  return files;
}

// A tenth of a millimetre, of a milliradian: keeps the page small.
double four_decimals(double x) {
  return std::round(1e4 * x) / 1e4;
}

Json rounded_vector(const Vec3& v) {
  return {four_decimals(v.x()), four_decimals(v.y()), four_decimals(v.z())};
}

Json boxes_json(const Terrain& terrain) {
  Json boxes = Json::array();
  for (const TerrainBox& box : terrain.boxes) {
    boxes.push_back({{"center", rounded_vector(box.center)},
                     {"size", rounded_vector(box.size)},
                     {"yaw", four_decimals(box.yaw_rad)},
                     {"friction", box.friction}});
  }
  return boxes;
}

std::string metric_leg(const Scenario& scenario) {
  return scenario.metric_leg ? std::string(kLegNames.at(static_cast<std::size_t>(*scenario.metric_leg))) : "all";
}

}  // namespace

std::vector<ReportScenario> load_report_scenarios(const fs::path& dir, const RunInfo& info, const ReportIndex& index,
                                                  std::vector<std::string>& missing) {
  const std::map<std::size_t, std::string> files = files_of(info, index);
  std::vector<ReportScenario> scenarios;
  for (std::size_t i = 0; i < index.scenarios().size(); ++i) {
    ReportScenario& scenario = scenarios.emplace_back(ReportScenario{index.scenarios()[i], std::nullopt});
    const std::string id = index.scenario_id(scenario.cell);
    const auto file = files.find(i);
    if (file == files.end()) {
      missing.push_back(
          fmt::format("The run does not say from which scenario file {} was made: no terrain for it.", id));
      continue;
    }
    try {
      scenario.scenario = load_scenarios({.name = (dir / "scenarios" / (file->second + ".toml")).string()}).front();
    } catch (const InputError& error) {
      missing.push_back(fmt::format("No terrain, duration and summary of {}: its resolved file cannot be loaded ({}).",
                                    id, without_directories(error.what())));
    }
  }
  return scenarios;
}

Json scenarios_json(const std::vector<ReportScenario>& scenarios, const ReportIndex& index) {
  const std::set<std::string> paper = paper_set();
  Json list = Json::array();
  for (const ReportScenario& entry : scenarios) {
    const std::string id = index.scenario_id(entry.cell);
    Json json{{"id", id}, {"scenario", entry.cell.scenario}, {"variant", entry.cell.variant}};
    const Scenario* s = entry.scenario ? &*entry.scenario : nullptr;
    json["summary"] = s != nullptr ? s->summary : "";
    json["duration_s"] = s != nullptr ? Json(s->duration) : Json();
    json["metric_leg"] = s != nullptr ? metric_leg(*s) : "all";
    json["set"] = paper.contains(entry.cell.scenario) ? "paper" : "extra";
    json["seed"] = entry.cell.seed;
    json["setting"] = index.setting(entry.cell);
    json["boxes"] = s != nullptr ? boxes_json(laid_terrain(*s, entry.cell.seed)) : Json::array();
    json["friction"] = s != nullptr ? Json(s->terrain.ground_friction) : Json();
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace dob
