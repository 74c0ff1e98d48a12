#include "scenarios/loader.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "controller/locomotion_controller.h"
#include "scenarios/data_directory.h"
#include "scenarios/document.h"
#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

constexpr std::string_view kExtension = ".toml";

// A scenario's file, parsed, and which of its variants is meant.
struct Source {
  std::string name;
  std::filesystem::path path;
  Node document;  // without name and variants
  std::vector<Entry> variants;
  std::optional<std::string> asked;  // the variant in the request
  std::string variant;               // that a resolved document is, by its name
};

// "head/tail" at the first slash from `from` on; without one there is no tail.
std::pair<std::string, std::optional<std::string>> split(const std::string& text, std::size_t from = 0) {
  const std::size_t slash = text.find('/', from);
  if (slash == std::string::npos) return {text, std::nullopt};
  return {text.substr(0, slash), text.substr(slash + 1)};
}

void require_known(const std::string& name, const std::vector<std::string>& names, const char* option) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InputError({option}, "", fmt::format("there is no '{}'; there are: {}", name, fmt::join(names, ", ")));
}

// Fills name, path and the variant that was asked for.
Source locate(const std::string& request) {
  const std::size_t extension = request.rfind(kExtension);
  const std::size_t end = extension == std::string::npos ? 0 : extension + kExtension.size();
  const bool is_path = end != 0 && (end == request.size() || request[end] == '/');
  auto [head, variant] = split(request, is_path ? end : 0);
  if (is_path) return {std::filesystem::path(head).stem().string(), head, {}, {}, variant, ""};
  require_known(head, scenario_names(), "scenario");
  return {head, scenario_file(head), {}, {}, variant, ""};
}

// Variants and a name written in the file leave the document: they are not part of the schema.
void take_variants(Source& source) {
  const Node* node = source.document.find(kVariantsKey);
  if (node == nullptr) return;
  source.variants = table_of(*node, kVariantsKey);
  if (source.variants.empty()) throw InputError(node->place, kVariantsKey, "empty; allowed: tables [variant.NAME]");
  for (const Entry& e : source.variants) {
    const std::string key = fmt::format("{}.{}", kVariantsKey, e.key);
    if (!is_bare_key(e.key)) throw InputError(e.node.place, key, "allowed in a name: letters, digits, _ and -");
    table_of(e.node, key);
  }
  erase(source.document, kVariantsKey);
}

void take_name(Source& source) {
  const Node* node = source.document.find(kNameKey);
  if (node == nullptr) return;
  const auto* text = std::get_if<std::string>(&node->value);
  const auto [name, variant] = split(text == nullptr ? "" : *text);
  const bool both = variant && !source.variants.empty();
  if (!is_bare_key(name) || (variant && !is_bare_key(*variant)) || both) {
    throw InputError(node->place, kNameKey,
                     describe(*node) + "; allowed: \"NAME\", or \"NAME/VARIANT\" in a file without variants");
  }
  source.name = name;
  source.variant = variant.value_or("");
  erase(source.document, kNameKey);
}

Source read_source(const std::string& request) {
  Source source = locate(request);
  source.document = parse_file(source.path);
  take_variants(source);
  take_name(source);
  if (!is_bare_key(source.name)) {
    throw InputError(
        {source.path.string()}, "",
        fmt::format("'{}' is no name; allowed: letters, digits, _ and -, in the file's name or as name = \"NAME\"",
                    source.name));
  }
  return source;
}

std::vector<std::string> names_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const Entry& e : entries) names.push_back(e.key);
  return names;
}

// The variants that a request means.
std::vector<std::string> chosen_variants(const Source& source) {
  if (source.variants.empty()) {
    if (source.asked)
      throw InputError({source.path.string()}, "",
                       fmt::format("there is no variant '{}'; the scenario has none", *source.asked));
    return {source.variant};
  }
  std::vector<std::string> names = names_of(source.variants);
  if (!source.asked) return names;
  require_known(*source.asked, names, "variant");
  return {*source.asked};
}

Node gain_set(const std::string& name) {
  Node sets = parse_file(gains_file());
  require_known(name, names_of(table_of(sets, "")), "--gains");
  Node& set = *sets.find(name);
  erase(set, "source");
  erase(set, "remark");
  return set;
}

// A posture names the joints of one robot.
void lay(Node& document, const Node& layer) {
  const Node* robot = layer.find("robot");
  if (robot != nullptr && robot->find("urdf") != nullptr) {
    if (Node* below = document.find("robot")) erase(*below, "posture_rad");
  }
  merge(document, layer);
}

void lay_override(Node& document, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw InputError({"--set"}, text, "no '='; allowed: KEY=VALUE");
  const std::string key = text.substr(0, equals);
  set(document, key, parse_value(key, text.substr(equals + 1), {"--set"}));
}

Node merged(const Source& source, const std::string& variant, const ScenarioRequest& request) {
  Node document = parse_file(defaults_file());
  const auto lay_gains = [&](const std::string& name) { set(document, "gains", gain_set(name)); };
  lay_gains("paper");
  lay(document, source.document);
  for (const Entry& e : source.variants) {
    if (e.key == variant) lay(document, e.node);
  }
  if (!request.gains.empty()) lay_gains(request.gains);
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

Scenario read_checked(const Source& source, const std::string& variant, const Node& document) {
  Scenario scenario = read_scenario(document);
  check(scenario, document.place);
  scenario.name = source.name;
  scenario.variant = variant;
  return scenario;
}

}  // namespace

std::vector<ScenarioInfo> list_scenarios() {
  std::vector<ScenarioInfo> list;
  for (const std::string& name : scenario_names()) {
    const Source source = read_source(name);
    const Node* summary = source.document.find("summary");
    const auto* text = summary == nullptr ? nullptr : std::get_if<std::string>(&summary->value);
    list.push_back({name, names_of(source.variants), text == nullptr ? "" : *text, source.path});
  }
  return list;
}

std::vector<std::string> list_profiles() {
  return profile_names();
}

std::vector<std::string> list_gain_sets() {
  const Node sets = parse_file(gains_file());
  return names_of(table_of(sets, ""));
}

std::vector<Scenario> load_scenarios(const ScenarioRequest& request) {
  const Source source = read_source(request.name);
  std::vector<Scenario> scenarios;
  for (const std::string& variant : chosen_variants(source))
    scenarios.push_back(read_checked(source, variant, merged(source, variant, request)));
  return scenarios;
}

std::string resolved_toml(const ScenarioRequest& request, std::string_view variant) {
  const Source source = read_source(request.name);
  const std::vector<std::string> variants = chosen_variants(source);
  require_known(std::string(variant), variants, "variant");
  Node document = merged(source, std::string(variant), request);
  const Scenario scenario = read_checked(source, std::string(variant), document);
  set(document, "robot.urdf", {scenario.robot.urdf.string(), {}});
  const std::string name = variant.empty() ? scenario.name : fmt::format("{}/{}", scenario.name, variant);
  Table& table = std::get<Table>(document.value);
  table.insert(table.begin(), {kNameKey, {name, {}}});
  return to_toml(document);
}

}  // namespace dob
