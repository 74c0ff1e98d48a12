#include "bench/batch_plan.h"

#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/trial.h"
#include "observers/factory.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

std::vector<std::string> or_all_scenarios(const std::vector<std::string>& asked) {
  if (!asked.empty()) return asked;
  std::vector<std::string> names;
  for (const ScenarioInfo& info : list_scenarios()) names.push_back(info.name);
  return names;
}

std::vector<std::string> or_all_observers(const std::vector<std::string>& asked) {
  if (!asked.empty()) return asked;
  std::vector<std::string> names;
  for (const ObserverInfo& info : built_in_observers()) names.emplace_back(info.name);
  return names;
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

}  // namespace

BatchPlan plan_batch(const BatchRequest& request) {
  BatchPlan plan;
  const std::vector<std::string> profiles = request.profiles.empty() ? list_profiles() : request.profiles;
  const std::vector<std::string> gain_sets = request.gains.empty() ? std::vector<std::string>{"paper"} : request.gains;
  const std::string overrides = fmt::format("{}", fmt::join(request.overrides, "; "));
  std::set<CellKey> planned;
  std::map<std::string, std::string> called;  // label in the tables -> observer
  for (const std::string& name : or_all_scenarios(request.scenarios)) {
    for (const std::string& gains : gain_sets) {
      const ScenarioRequest wanted{name, gains, request.planner, request.overrides};
      for (const Scenario& scenario : load_scenarios(wanted)) {
        require_runnable(scenario);
        const std::string file =
            fmt::format("{}{}{}_{}", scenario.name, scenario.variant.empty() ? "" : "_", scenario.variant, gains);
        plan.resolved.push_back({file, resolved_toml(wanted, scenario.variant)});
        plan.scenarios.push_back(scenario);
        for (const std::string& specification : or_all_observers(request.observers)) {
          for (const std::string& profile : profiles) {
            const ObserverConfig observer = load_observer(specification, profile, scenario.sim.dt);
            require_one_meaning(observer, called);
            for (int seed = request.first_seed; seed <= request.last_seed; ++seed) {
              const CellKey key{scenario.name,  scenario.variant,
                                observer.label, observer.profile,
                                gains,          std::string(to_string(scenario.planner.kind)),
                                overrides,      seed};
              if (!planned.insert(key).second) continue;
              plan.cells.push_back({key, plan.scenarios.size() - 1, observer});
            }
          }
        }
      }
    }
  }
  return plan;
}

std::string resolved_name(const CellKey& key) {
  return fmt::format("{}{}{}_{}", key.scenario, key.variant.empty() ? "" : "_", key.variant, key.gains);
}

}  // namespace dob
