#include "scenarios/loader.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "controller/locomotion_controller.h"
#include "scenarios/data_directory.h"
#include "scenarios/document.h"
#include "scenarios/gains_name.h"
#include "scenarios/scenario_source.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

Node gain_set(const std::string& name) {
  Node sets = parse_file(gains_file());
  std::vector<std::string> known = names_of(table_of(sets, ""));
  known.insert(known.begin(), std::string(kOwnGains));
  require_known(name, known, {"--gains"});
  Node& set = *sets.find(name);
  erase(set, "source");
  erase(set, "remark");
  return set;
}

void lay_override(Node& document, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw InputError({"--set"}, text, "no '='; allowed: KEY=VALUE");
  const std::string key = text.substr(0, equals);
  set(document, key, parse_value(key, text.substr(equals + 1), {"--set"}));
}

// What the files say, before anything that the request lays over it.
Node written(const ScenarioSource& source, std::string_view variant) {
  Node document = parse_file(defaults_file());
  set(document, "gains", gain_set("paper"));
  lay(document, source.document);
  for (const Entry& e : source.variants) {
    if (e.key == variant) lay(document, e.node);
  }
  return document;
}

bool asks_for_gains(const ScenarioRequest& request) {
  return !request.gains.empty() && request.gains != kOwnGains;
}

Node merged(const ScenarioSource& source, const std::string& variant, const ScenarioRequest& request) {
  Node document = written(source, variant);
  if (asks_for_gains(request)) set(document, "gains", gain_set(request.gains));
  if (!request.planner.empty()) set(document, "planner.kind", {request.planner, {"--planner"}});
  for (const std::string& text : request.overrides) lay_override(document, text);
  return document;
}

// Ranges are checked where the values were written; what else their users refuse is refused here.
void check(const Scenario& s, const Place& place) {
  try {
    const LocomotionOptions options{s.gait, s.planner, s.controller, Routing{}};
    const LocomotionController controller(options, ReferencePath(s.path), s.sim.dt);
    s.sim.validate();
    s.terrain.validate();
    s.noise.validate();
    for (const Disturbance& disturbance : s.disturbances) disturbance.validate();
    for (const RandomPush& push : s.random_pushes) push.validate();
  } catch (const std::invalid_argument& error) {
    throw InputError(place, "", error.what());
  }
}

Scenario read_checked(const ScenarioSource& source, const std::string& variant, const Node& document) {
  Scenario scenario = read_scenario(document);
  check(scenario, document.place);
  scenario.name = source.name;
  scenario.variant = variant;
  return scenario;
}

struct Loaded {
  Node document;
  Scenario scenario;
};

Loaded read_variant(const ScenarioRequest& request, const std::string& variant) {
  const ScenarioSource source = read_source(request.name);
  require_known(variant, chosen_variants(source), {"variant"});
  Node document = merged(source, variant, request);
  Scenario scenario = read_checked(source, variant, document);
  return {std::move(document), std::move(scenario)};
}

}  // namespace

std::vector<ScenarioInfo> list_scenarios() {
  std::vector<ScenarioInfo> list;
  for (const std::string& name : scenario_names()) list.push_back(scenario_info(name));
  return list;
}

ScenarioInfo scenario_info(const std::string& request) {
  const ScenarioSource source = read_source(request);
  ScenarioInfo info = source.info;
  info.variants = names_of(source.variants);
  return info;
}

std::vector<std::string> list_profiles() {
  return profile_names();
}

std::vector<std::string> list_gain_sets() {
  const Node sets = parse_file(gains_file());
  return names_of(table_of(sets, ""));
}

std::string gains_name(const ScenarioRequest& request, std::string_view variant) {
  if (asks_for_gains(request)) return request.gains;
  const Node document = written(read_source(request.name), variant);
  const std::string own = to_toml(*document.find("gains"));
  for (const std::string& name : list_gain_sets()) {
    if (own == to_toml(gain_set(name))) return name;
  }
  return std::string(kOwnGains);
}

std::vector<Scenario> load_scenarios(const ScenarioRequest& request) {
  const ScenarioSource source = read_source(request.name);
  std::vector<Scenario> scenarios;
  for (const std::string& variant : chosen_variants(source))
    scenarios.push_back(read_checked(source, variant, merged(source, variant, request)));
  return scenarios;
}

std::vector<std::string> late_loads(const ScenarioRequest& request, std::string_view variant, bool shifted) {
  const auto [document, scenario] = read_variant(request, std::string(variant));
  return find_late_loads(document, scenario, shifted);
}

std::string resolved_toml(const ScenarioRequest& request, std::string_view variant) {
  auto [document, scenario] = read_variant(request, std::string(variant));
  set(document, "robot.urdf", {scenario.robot.urdf.string(), {}});
  const std::string name = variant.empty() ? scenario.name : fmt::format("{}/{}", scenario.name, variant);
  Table& table = std::get<Table>(document.value);
  table.insert(table.begin(), {kNameKey, {name, {}}});
  return to_toml(document);
}

}  // namespace dob
