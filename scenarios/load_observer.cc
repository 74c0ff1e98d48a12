// Observers from profiles and from the command line.
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "observers/factory.h"
#include "observers/pair.h"
#include "observers/plugin.h"
#include "scenarios/data_directory.h"
#include "scenarios/document.h"
#include "scenarios/gain_keys.h"
#include "scenarios/loader.h"
#include "scenarios/observer_tables.h"
#include "scenarios/plugin_files.h"
#include "scenarios/profile_kinds.h"

namespace dob {
namespace {

constexpr const char* kPlugins = "plugin";

ObserverInfo find_observer(std::string_view name, const Place& place) {
  if (is_plugin_path(name) && place.line > 0) {
    throw InputError(place, "",
                     fmt::format("'{}' is the file of a plugin, code that would run here; allowed in a file: "
                                 "observers' names; --observer and --shadow may name a plugin",
                                 name));
  }
  try {
    if (is_plugin_path(name)) return load_plugin(name);
  } catch (const OptionError& error) {
    throw InputError(place, "", error.what());
  }
  if (const ObserverInfo* info = find_built_in_observer(name)) return *info;
  std::vector<std::string_view> names;
  for (const ObserverInfo& info : built_in_observers()) names.push_back(info.name);
  throw InputError(place, "", fmt::format("there is no observer '{}'; there are: {}", name, fmt::join(names, ", ")));
}

bool estimates(const ObserverInfo& info) {
  return info.estimates_legs || info.estimates_com;
}

struct NodeMaker {
  template <typename T>
  Node operator()(const T& value) const {
    return {value, place};
  }
  Node operator()(const std::vector<double>& list) const {
    Array array;
    for (const double number : list) array.push_back({number, place});
    return {std::move(array), place};
  }
  const Place& place;
};

// `key=value,key=value` as the document that a profile would hold.
Node parse_specification(std::string_view text, const Place& place) {
  Node document{Table{}, place};
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos)
      throw InputError(place, "", fmt::format("'{}'; allowed: KEY=VALUE, several with commas between them", item));
    set(document, std::string(item.substr(0, equals)),
        std::visit(NodeMaker{place}, parse_option_value(item.substr(equals + 1))));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return document;
}

const char* kind_of(const ObserverInfo& info) {
  if (info.estimates_legs && info.estimates_com) return kOfBoth;
  return info.estimates_legs ? kOfLegs : kOfCom;
}

void check_kind(const Node& kind, const std::string& key) {
  for (const Entry& e : table_of(kind, key)) {
    if (e.key != kRouting) throw InputError(e.node.place, fmt::format("{}.{}", key, e.key), "allowed: routing only");
  }
}

// Every table of a profile has to be an observer's or a kind's.
void check_profile(const Node& profile) {
  for (const Entry& e : table_of(profile, "")) {
    table_of(e.node, e.key);
    if (e.key == kPlugins) continue;
    if (is_plugin_path(e.key)) {
      throw InputError(e.node.place, e.key, "a plugin's table is [plugin.NAME]; a profile may not name its file");
    }
    if (std::find(kRoutedKinds.begin(), kRoutedKinds.end(), e.key) != kRoutedKinds.end()) {
      check_kind(e.node, e.key);
    } else if (!estimates(find_observer(e.key, e.node.place))) {
      throw InputError(e.node.place, e.key, "this observer estimates nothing; a profile has nothing to say about it");
    }
  }
}

// [NAME], or [plugin.NAME].
const Node* own_table(const Node& profile, const ObserverInfo& info, bool plugin) {
  if (!plugin) return profile.find(info.name);
  const Node* plugins = profile.find(kPlugins);
  return plugins == nullptr ? nullptr : plugins->find(info.name);
}

// What the profile says of an observer: its own table, or those of a pair's parts, over the routing of its kind. Empty
// when it says nothing.
Node profile_table(const Node& profile, const ObserverInfo& info, bool plugin, const Place& place) {
  Node table{Table{}, place};
  if (!estimates(info)) return table;
  if (plugin && own_table(profile, info, plugin) == nullptr) return table;  // its author's gains and default routing
  if (const Node* kind = profile.find(kind_of(info))) table.value = kind->value;
  if (const auto pair = parse_pair_name(info.name)) {
    for (const auto& [part, name] : {std::pair(kOfLegs, pair->legs), std::pair(kOfCom, pair->com)}) {
      const Node* own = profile.find(name);
      if (own == nullptr) continue;
      Node options = *own;
      erase(options, kRouting);
      if (!table_of(options, part).empty()) set(table, part, options);
    }
  } else if (const Node* own = own_table(profile, info, plugin)) {
    merge(table, *own);
    table.place = own->place;
  }
  return table;
}

// `NAME:options` or `legs=NAME,com=NAME,options`, split into name and options.
std::pair<std::string_view, std::string_view> split(std::string_view specification) {
  const bool pair = specification.starts_with(fmt::format("{}=", kOfLegs));
  std::size_t end = specification.find(pair ? ',' : ':');
  if (pair && end != std::string_view::npos) end = specification.find(',', end + 1);
  if (end == std::string_view::npos) return {specification, {}};
  return {specification.substr(0, end), specification.substr(end + 1)};
}

ObserverInfo find_observer_or_pair(std::string_view name, const Place& place) {
  const auto pair = parse_pair_name(name);
  if (!pair) return find_observer(name, place);
  find_observer(pair->legs, place);
  find_observer(pair->com, place);
  return {.name = name, .estimates_legs = true, .estimates_com = true};
}

// The option of the table that an OptionError is about, by what it says: an error of a plugin is nothing but its text.
// nullptr: none of them.
const Node* named_by(const std::string& error, const Node& table, const std::string& path = "") {
  const auto says = [&error](const std::string& text) { return error.find(text) != std::string::npos; };
  // The first one: what follows may repeat a value, and that may be any text.
  const std::size_t named = error.find(": option ");
  const auto names = [&error, named](const std::string& key) {
    return named != std::string::npos && error.substr(named).starts_with(fmt::format(": option {} = ", key));
  };
  for (const Entry& e : std::get<Table>(table.value)) {
    if (std::holds_alternative<Table>(e.node.value)) {
      const bool other_part = says(", part ") && !says(fmt::format(", part {}: ", e.key));
      const Node* found = other_part ? nullptr : named_by(error, e.node, fmt::format("{}{}.", path, e.key));
      if (found != nullptr) return found;
    } else if (names(e.key) || names(path + e.key)) {
      return &e.node;
    }
  }
  return nullptr;
}

// With what the profile says, under the name it has in the tables.
ObserverConfig configure(std::string_view specification, const Node& document, const std::string& profile, double dt,
                         const Place& place) {
  const auto [name, overrides] = split(specification);
  const bool plugin = !parse_pair_name(name) && is_plugin_path(name);
  const ObserverInfo info = find_observer_or_pair(name, place);
  Node table = profile_table(document, info, plugin, place);
  // An oracle has no gains, and its kind's routing is the same in every profile: one row, not one for each.
  const bool in_profile = !table_of(table, "").empty() && !(info.oracle && document.find(info.name) == nullptr);
  if (!overrides.empty()) {
    const Node overlay = parse_specification(overrides, place);
    drop_replaced_gains(table, overlay);
    merge(table, overlay);
  }

  ObserverConfig config{std::string(info.name), in_profile ? profile : "-", {}, {}, std::string(info.name)};
  config.label += specification.substr(name.size());
  for (const Entry& e : table_of(table, config.observer)) {
    const std::string key = fmt::format("{}.{}", config.observer, e.key);
    if (e.key != kRouting) {
      read_option(e.node, config.observer, e.key, config.options);
    } else if (estimates(info)) {
      config.routing = read_routing(e.node, key);
    } else {
      throw InputError(e.node.place, key, "this observer estimates nothing that could be routed");
    }
  }
  if (plugin) config.observer = std::filesystem::absolute(name).string();
  try {
    make_observer(config.observer, config.options, dt);
  } catch (const OptionError& error) {
    const Node* option = named_by(error.what(), table);
    throw InputError(option != nullptr ? option->place : overrides.empty() ? table.place : place, "", error.what());
  }
  return config;
}

}  // namespace

std::vector<std::string> plugin_files(std::string_view specification) {
  const std::string_view name = split(specification).first;
  const auto pair = parse_pair_name(name);
  std::vector<std::string> files;
  for (const std::string_view part : pair ? std::vector{pair->legs, pair->com} : std::vector{name}) {
    if (is_plugin_path(part)) files.emplace_back(part);
  }
  return files;
}

ObserverConfig load_observer(std::string_view specification, const std::string& profile, double dt,
                             const Place& place) {
  const Place written = !place.source.empty() ? place : Place{fmt::format("--observer {}", specification)};
  const std::vector<std::string> profiles = profile_names();
  if (std::find(profiles.begin(), profiles.end(), profile) == profiles.end()) {
    throw InputError({"--profile"}, "",
                     fmt::format("there is no '{}'; there are: {}", profile, fmt::join(profiles, ", ")));
  }
  const Node document = parse_file(profile_file(profile));
  check_profile(document);
  return configure(specification, document, profile, dt, written);
}

bool is_profile(const std::filesystem::path& file) {
  const Node document = parse_file(file);
  bool observers = false;
  for (const Entry& e : std::get<Table>(document.value)) {
    if (e.key == "summary" || e.key == "path" || e.key == "base" || e.key == "cells_of") return false;
    observers = observers || e.key == kOfLegs || e.key == kOfCom || e.key == kOfBoth || e.key == kPlugins ||
                find_built_in_observer(e.key) != nullptr;
  }
  return observers;
}

std::vector<ObserverConfig> load_profile(const std::filesystem::path& file) {
  const Node document = parse_file(file);
  check_profile(document);
  std::vector<ObserverConfig> observers;
  for (const ObserverInfo& info : built_in_observers()) {
    if (!estimates(info)) continue;
    observers.push_back(configure(info.name, document, file.stem().string(), SimOptions{}.dt, document.place));
  }
  return observers;
}

}  // namespace dob
