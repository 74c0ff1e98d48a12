#include "bench/stored_cells.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "observers/pair.h"
#include "observers/plugin.h"
#include "results/fingerprint.h"
#include "scenarios/loader.h"
#include "scenarios/stored_observer.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

// A cell that cannot be computed again, with the reason.
struct Obstacle {
  std::string reason;
};

// What the comment "# WHAT holds ..." says; "" when there is none.
std::string comment_in(std::string_view text, std::string_view what) {
  const std::string head = fmt::format("# {} holds ", what);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.starts_with(head)) return std::string(line.substr(head.size()));
    begin = end + 1;
  }
  return "";
}

}  // namespace

StoredCells::StoredCells(fs::path dir, const RunInfo& info, const std::vector<fs::path>& plugins)
    : dir_(std::move(dir)) {
  if (info.sources.size() != info.cells.size()) {
    throw StoreError(dir_.string() + ": does not hold what its cells were made from");
  }
  for (std::size_t i = 0; i < info.cells.size(); ++i) sources_.emplace(info.cells[i], info.sources[i]);
  for (const fs::path& plugin : plugins) plugins_[file_fingerprint(plugin)] = fs::absolute(plugin);
}

StoredCell StoredCells::of(const CellResult& row) {
  const auto source = sources_.find(row.key);
  if (source == sources_.end()) throw StoreError(dir_.string() + ": a cell that does not belong to the run");
  StoredCell stored{row.key, {}, nullptr, {}};
  try {
    const Loaded& loaded = scenario_of(source->second.scenario);
    if (!loaded.scenario) throw Obstacle{loaded.obstacle};
    stored.scenario = &*loaded.scenario;
    StoredObservers observers = read_observer_toml(source->second.observer, (dir_ / "run.sqlite").string());
    take_plugins(observers.observer, source->second.observer);
    stored.observer.observer = std::move(observers.observer);
    stored.observer.observer.profile = row.key.profile;
    stored.observer.observer.label = row.key.observer;
    for (std::size_t i = 0; i < observers.shadows.size(); ++i) {
      ObserverConfig& shadow = observers.shadows[i];
      take_plugins(shadow, source->second.observer);
      if (i < row.shadows.size()) {  // an error has none, and nothing to call them
        shadow.label = row.shadows[i].observer;
        shadow.profile = row.shadows[i].profile;
      }
      stored.observer.shadows.push_back(std::move(shadow));
    }
  } catch (const Obstacle& obstacle) {
    stored.obstacle = obstacle.reason;
  }
  return stored;
}

// What has become unreadable elsewhere, the robot's description for example, is an obstacle of its cells; what is not
// as it was in the run directory is not to be trusted.
const StoredCells::Loaded& StoredCells::scenario_of(const std::string& name) {
  const auto [it, added] = scenarios_.emplace(name, Loaded{});
  if (!added) return it->second;
  const ResolvedScenario resolved = read_resolved(dir_, name);
  try {
    std::vector<Scenario> loaded = load_scenarios({.name = (dir_ / "scenarios" / (name + ".toml")).string()});
    if (loaded.size() != 1) throw Obstacle{"its resolved scenario has variants"};
    if (file_fingerprint(loaded[0].robot.urdf) != comment_in(resolved.toml, "robot.urdf")) {
      throw Obstacle{loaded[0].robot.urdf.string() + ": is not the robot that the run was made with"};
    }
    it->second.scenario = std::move(loaded[0]);
  } catch (const Obstacle& obstacle) {
    it->second.obstacle = obstacle.reason;
  } catch (const std::runtime_error& error) {
    it->second.obstacle = error.what();
  }
  return it->second;
}

std::string StoredCells::library_for(const std::string& path, const std::string& source) const {
  const auto named = plugins_.find(comment_in(source, path));
  if (named != plugins_.end()) return named->second.string();
  throw Obstacle{fmt::format("plugin: {} is loaded only if --plugin names a library with what it held then", path)};
}

// In place of each plugin, alone or in a pair, the library that the user has named.
void StoredCells::take_plugins(ObserverConfig& observer, const std::string& source) const {
  const auto taken = [&](std::string_view name) {
    return is_plugin_path(name) ? library_for(std::string(name), source) : std::string(name);
  };
  if (const auto pair = parse_pair_name(observer.observer)) {
    observer.observer = fmt::format("legs={},com={}", taken(pair->legs), taken(pair->com));
  } else {
    observer.observer = taken(observer.observer);
  }
}

}  // namespace dob
