#include "bench/batch_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/trial.h"
#include "observers/factory.h"
#include "results/fingerprint.h"
#include "scenarios/gains_name.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

constexpr std::size_t kMaxCells = 1'000'000;  // a year of computing, a gigabyte of plan

std::vector<std::string> or_paper_set(const std::vector<std::string>& asked) {
  if (!asked.empty()) return asked;
  std::vector<std::string> names;
  for (const ScenarioInfo& info : list_scenarios()) {
    if (info.set == ScenarioSet::kPaper) names.push_back(info.name);
  }
  return names;
}

// What a scenario is run with.
struct Lineup {
  std::vector<WrittenText> observers;
  std::vector<std::string> profiles;
};

// A scenario that is about certain observers brings them along, unless it was named together with others.
Lineup lineup_of(const std::string& scenario, const BatchRequest& request) {
  const ScenarioInfo info = scenario_info(scenario);
  const bool named = !request.scenarios.empty();
  Lineup lineup;
  if (!info.observers.empty() && !(named && !request.observers.empty())) {
    lineup.observers = info.observers;
    const bool own_profiles = !(named && !request.profiles.empty());
    for (const WrittenText& profile : info.profiles) {
      if (own_profiles) lineup.profiles.push_back(profile.text);
    }
  }
  if (lineup.observers.empty()) {
    for (const std::string& asked : request.observers) lineup.observers.push_back({asked, {}});
  }
  if (lineup.observers.empty()) {
    for (const ObserverInfo& info_of : built_in_observers())
      lineup.observers.push_back({std::string(info_of.name), {}});
  }
  if (lineup.profiles.empty()) lineup.profiles = request.profiles.empty() ? list_profiles() : request.profiles;
  return lineup;
}

// What loading cannot see: a standing pose that the legs cannot reach, for example.
void require_runnable(const Scenario& scenario) {
  try {
    const Trial trial(scenario, {.observer = "none", .profile = "-", .options = {}, .routing = {}}, 1);
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("{}{}{}: {}", scenario.name, scenario.variant.empty() ? "" : "/", scenario.variant, error.what()));
  }
}

// Two plugins of one name would share their rows.
void require_one_meaning(const ObserverConfig& observer, std::map<std::string, std::string>& called) {
  const auto [it, added] = called.emplace(observer.label, observer.observer);
  if (added || it->second == observer.observer) return;
  throw InputError(fmt::format("--observer {} and --observer {} are both called '{}' in the tables", it->second,
                               observer.observer, observer.label));
}

// Where the plan has the scenario; one that is asked for twice is there once.
std::size_t add_scenario(BatchPlan& plan, const Scenario& scenario, const ScenarioRequest& wanted,
                         const std::string& gains) {
  require_runnable(scenario);
  ResolvedScenario resolved{
      fmt::format("{}{}{}_{}", scenario.name, scenario.variant.empty() ? "" : "_", scenario.variant, gains),
      resolved_toml(wanted, scenario.variant)};
  // The document names the file only: of another robot in it the run is another one.
  resolved.toml += fmt::format("\n# robot.urdf holds {}\n", file_fingerprint(scenario.robot.urdf));
  for (std::size_t i = 0; i < plan.resolved.size(); ++i) {
    if (plan.resolved[i].name != resolved.name) continue;
    if (plan.resolved[i].toml == resolved.toml) return i;
    throw InputError(
        fmt::format("{}: another scenario of this batch has the same name, '{}'", wanted.name, scenario.name));
  }
  plan.scenarios.push_back(scenario);
  plan.resolved.push_back(std::move(resolved));
  return plan.scenarios.size() - 1;
}

std::vector<ObserverConfig> load_observers(const Lineup& lineup, double dt) {
  std::vector<ObserverConfig> observers;
  for (const WrittenText& specification : lineup.observers) {
    for (const std::string& profile : lineup.profiles) {
      observers.push_back(load_observer(specification.text, profile, dt, specification.place));
    }
  }
  return observers;
}

CellKey key_of(const Scenario& scenario, const ObserverConfig& observer, const std::string& gains,
               const ScenarioRequest& wanted, int seed) {
  return {.scenario = scenario.name,
          .variant = scenario.variant,
          .observer = observer.label,
          .profile = observer.profile,
          .gains = gains,
          .planner = std::string(to_string(scenario.planner.kind)),
          .overrides = fmt::format("{}", fmt::join(wanted.overrides, "; ")),
          .seed = seed};
}

// Each once, in the first profile that is asked for.
std::vector<ObserverConfig> load_shadows(const BatchRequest& request, double dt) {
  const std::string profile = request.profiles.empty() ? "matched" : request.profiles.front();
  std::vector<ObserverConfig> shadows;
  for (const std::string& specification : request.shadows) {
    ObserverConfig shadow = load_observer(specification, profile, dt, {"--shadow " + specification});
    const auto same = [&](const ObserverConfig& other) { return other.label == shadow.label; };
    if (std::none_of(shadows.begin(), shadows.end(), same)) shadows.push_back(std::move(shadow));
  }
  return shadows;
}

// The observer in the loop is judged on the same data already.
std::vector<ObserverConfig> without(std::vector<ObserverConfig> shadows, const ObserverConfig& in_the_loop) {
  std::erase_if(shadows, [&](const ObserverConfig& shadow) {
    return shadow.label == in_the_loop.label && shadow.profile == in_the_loop.profile;
  });
  return shadows;
}

// Each once: gain sets and variants share what their file says. Seed 1 shifts nothing.
void add_warnings(BatchPlan& plan, const Scenario& scenario, const ScenarioRequest& wanted, bool shifted) {
  for (std::string& late : late_loads(wanted, scenario.variant, shifted)) {
    if (std::find(plan.warnings.begin(), plan.warnings.end(), late) == plan.warnings.end()) {
      plan.warnings.push_back(std::move(late));
    }
  }
}

// Before they are made: a slip of the keyboard is not to cost the memory.
void require_room(const BatchPlan& plan, const BatchRequest& request, std::size_t observers) {
  const long seeds = static_cast<long>(request.last_seed) - request.first_seed + 1;
  const std::size_t cells = plan.cells.size() + observers * static_cast<std::size_t>(std::max(seeds, 0L));
  if (cells <= kMaxCells) return;
  throw InputError(
      fmt::format("--seeds: {} seeds make {} cells or more; allowed: {} cells in one batch", seeds, cells, kMaxCells));
}

}  // namespace

std::vector<std::string> split_specifications(const std::string& list) {
  std::vector<std::string> specifications;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string part = list.substr(begin, end - begin);
    const bool option = part.find('=') < part.find(':') && !part.starts_with("legs=");
    if (option && !specifications.empty()) {
      specifications.back() += "," + part;
    } else {
      specifications.push_back(part);
    }
    begin = end + 1;
  }
  return specifications;
}

BatchPlan plan_batch(const BatchRequest& request) {
  BatchPlan plan;
  const std::vector<std::string> gain_sets = request.gains.empty() ? std::vector<std::string>{""} : request.gains;
  std::set<CellKey> planned;                  // by their first seeds
  std::map<std::string, std::string> called;  // label in the tables -> observer
  for (const std::string& name : or_paper_set(request.scenarios)) {
    const Lineup lineup = lineup_of(name, request);
    for (const std::string& asked : gain_sets) {
      const ScenarioRequest wanted{name, asked, request.planner, request.overrides};
      for (const Scenario& scenario : load_scenarios(wanted)) {
        const std::string gains = gains_name(wanted, scenario.variant);
        const std::size_t index = add_scenario(plan, scenario, wanted, gains);
        add_warnings(plan, scenario, wanted, request.last_seed > 1);
        const std::vector<ObserverConfig> shadows = load_shadows(request, scenario.sim.dt);
        for (const ObserverConfig& shadow : shadows) require_one_meaning(shadow, called);
        const std::vector<ObserverConfig> observers = load_observers(lineup, scenario.sim.dt);
        require_room(plan, request, observers.size());
        for (const ObserverConfig& observer : observers) {
          require_one_meaning(observer, called);
          plan.observers.push_back({observer, without(shadows, observer)});
          PlannedCell cell{key_of(scenario, observer, gains, wanted, request.first_seed), index,
                           plan.observers.size() - 1, request.first_seed};
          if (!planned.insert(cell.key).second) continue;
          for (long seed = request.first_seed; seed <= request.last_seed; ++seed) {
            cell.key.seed = static_cast<int>(seed);
            plan.cells.push_back(cell);
          }
        }
      }
    }
  }
  return plan;
}

}  // namespace dob
