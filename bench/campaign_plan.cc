#include "bench/campaign_plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/campaign_estimators.h"
#include "bench/campaign_grid.h"
#include "bench/campaign_search.h"
#include "observers/pair.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

constexpr std::size_t kMostCells = 1'000'000;

class Planner {
 public:
  explicit Planner(const CampaignSpec& spec) : spec_(spec) {
    plan_.campaign = Campaign{.kind = spec.kind,
                              .name = spec.name,
                              .summary = spec.summary,
                              .document = spec.document,
                              .axes = {},
                              .factors = {},
                              .curves = {},
                              .cells = {}};
    for (const AxisSpec& axis : spec.axes) plan_.campaign->axes.push_back(axis.axis);
    if (spec.kind == CampaignKind::kFactorial)
      plan_.campaign->factors = {"scenario", "leg estimator", "CoM estimator", "gains", "planner"};
  }

  BatchPlan plan() {
    const std::vector<std::string> planners = spec_.planners.empty() ? std::vector<std::string>{""} : spec_.planners;
    for (const std::string& scenario : spec_.scenarios) {
      for (const std::vector<std::string>& overrides : grid_of(spec_)) {
        for (const std::string& planner : planners) {
          BatchRequest request;
          request.scenarios = {scenario};
          request.profiles = spec_.profiles;
          request.gains = spec_.gains;
          request.planner = planner;
          request.overrides = overrides;
          request.last_seed = spec_.seeds;
          require_base(request);
          add_block(request);
        }
      }
    }
    sort_cells();
    return std::move(plan_);
  }

 private:
  void add_block(const BatchRequest& request) {
    if (spec_.kind == CampaignKind::kFactorial) return add_factorial(request);
    if (spec_.kind == CampaignKind::kMap) {
      for (int i = 0; i < levels_of(0); ++i) {
        for (int j = 0; j < levels_of(1); ++j) add_levels(request, {0, 1}, {i, j});
      }
      return;
    }
    for (int axis = 0; axis < static_cast<int>(spec_.axes.size()); ++axis) {
      for (int i = 0; i < levels_of(axis); ++i) add_levels(request, {axis}, {i, 0});
    }
  }

  int levels_of(int axis) const {
    return static_cast<int>(spec_.axes[static_cast<std::size_t>(axis)].axis.levels.size());
  }

  void add_factorial(BatchRequest request) {
    std::map<std::string, Combination> meaning;
    for (const Combination& combination : combinations(spec_)) {
      request.observers.push_back(combination.observer);
      meaning.emplace(combination.observer, combination);
    }
    append(planned(request, {}), {}, {}, [&](const CellKey& key) {
      const Combination& combination = meaning.at(key.observer);
      const std::string scenario = fmt::format("{}{}{}{}{}", key.scenario, key.variant.empty() ? "" : "/", key.variant,
                                               key.overrides.empty() ? "" : " ", key.overrides);
      return std::pair(key, std::vector{scenario, combination.legs, combination.com, key.gains, key.planner});
    });
  }

  // The cells of one level of one axis, or of a pair of levels of two.
  void add_levels(const BatchRequest& base, const std::vector<int>& axes, const std::array<int, 2>& level) {
    BatchRequest request = base;
    std::vector<std::pair<const AxisSpec*, double>> scales;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const AxisSpec& axis = spec_.axes[static_cast<std::size_t>(axes[i])];
      const double value = axis.axis.levels[static_cast<std::size_t>(level[i])];
      for (const std::string& text : axis.set) request.overrides.push_back(with_level(text, value));
      if (!axis.observer_scale.empty()) scales.emplace_back(&axis, value);
    }
    const std::string common = fmt::format("{}", fmt::join(base.overrides, "; "));
    const auto curve_of = [&](const std::string& observer) {
      return [&, observer](CellKey key) {
        key.overrides = common;
        if (!observer.empty()) key.observer = observer;
        return std::pair(std::move(key), std::vector<std::string>{});
      };
    };
    if (scales.empty()) {
      request.observers = spec_.observers;
      append(planned(request, axes), axes, level, curve_of(""));
      return;
    }
    for (const std::string& observer : spec_.observers) {
      for (const std::string& profile : spec_.profiles) {
        const std::string scaled = scaled_observer(observer, profile, scales);
        if (scaled.empty()) continue;
        request.observers = {scaled};
        request.profiles = {profile};
        append(planned(request, axes), axes, level, curve_of(observer));
      }
    }
  }

  // The specification with the options that the axes scale; "" for an observer that has none of them.
  std::string scaled_observer(const std::string& observer, const std::string& profile,
                              const std::vector<std::pair<const AxisSpec*, double>>& scales) const {
    const ObserverConfig config = load_observer(observer, profile);
    std::string specification = observer;
    for (const auto& [axis, factor] : scales) {
      bool scaled = false;
      for (const std::string& option : axis->observer_scale) {
        const auto it = config.options.find(option);
        const double* number = it == config.options.end() ? nullptr : std::get_if<double>(&it->second);
        if (number == nullptr) continue;
        const bool first = specification.find(':') == std::string::npos && !parse_pair_name(observer);
        specification += fmt::format("{}{}={:.6g}", first ? ":" : ",", option, *number * factor);
        scaled = true;
      }
      if (!scaled) return "";
    }
    return specification;
  }

  // What is wrong is said where it was written: before any axis, the scenarios and what is laid over all of them.
  void require_base(const BatchRequest& request) const {
    try {
      load_scenarios({request.scenarios[0], {}, request.planner, request.overrides});
    } catch (const InputError& error) {
      const bool of_set = std::string_view(error.what()).starts_with("--set");
      throw InputError(of_set ? spec_.set_place : spec_.scenarios_place, of_set ? "set" : "", error.what());
    }
  }

  BatchPlan planned(const BatchRequest& request, const std::vector<int>& axes) const {
    try {
      return plan_batch(request);
    } catch (const InputError& error) {
      const std::string_view message = error.what();
      if (message.starts_with("--observer")) throw InputError(spec_.observers_place, "", error.what());
      if (axes.empty()) throw InputError(spec_.scenarios_place, "", error.what());
      const AxisSpec& axis = axis_in(message, axes);
      throw InputError(axis.place, "axis." + axis.axis.name, error.what());
    }
  }

  // The one whose key the message names, else the last one: the others are tried with it.
  const AxisSpec& axis_in(std::string_view message, const std::vector<int>& axes) const {
    for (const int i : axes) {
      const AxisSpec& axis = spec_.axes[static_cast<std::size_t>(i)];
      for (const std::string& text : axis.set) {
        if (message.find(text.substr(0, text.find('='))) != std::string_view::npos) return axis;
      }
    }
    return spec_.axes[static_cast<std::size_t>(axes.back())];
  }

  // Adds the cells of a part; `curve_of` tells the key of a cell's curve and the levels of its factors.
  template <typename CurveOf>
  void append(BatchPlan part, const std::vector<int>& axes, const std::array<int, 2>& level, const CurveOf& curve_of) {
    std::vector<std::size_t> scenario_at;
    for (std::size_t i = 0; i < part.scenarios.size(); ++i) {
      scenario_at.push_back(add_scenario(std::move(part.scenarios[i]), std::move(part.resolved[i])));
    }
    const std::size_t observers = plan_.observers.size();
    std::move(part.observers.begin(), part.observers.end(), std::back_inserter(plan_.observers));
    std::map<CellKey, std::size_t> curve_of_row;
    for (const PlannedCell& row : part.cells.rows()) {
      auto [key, factors] = curve_of(row.key);
      if (!keys_.insert(row.key).second) refuse_again(row.key, axes);
      curve_of_row[row.key] = curve_at({std::move(key), axes, std::move(factors)});
    }
    for (std::size_t i = 0; i < part.cells.size(); ++i) {
      const std::size_t curve = curve_of_row.at(part.cells.row(i).key);
      PlannedCell cell = part.cells[i];
      cell.scenario = scenario_at[cell.scenario];
      cell.observer += observers;
      plan_.cells.push_back(std::move(cell));
      plan_.campaign->cells.push_back({curve, level});
    }
    for (std::string& warning : part.warnings) {
      if (std::find(plan_.warnings.begin(), plan_.warnings.end(), warning) == plan_.warnings.end()) {
        plan_.warnings.push_back(std::move(warning));
      }
    }
    if (plan_.cells.size() > kMostCells) {
      throw InputError(
          spec_.scenarios_place, "",
          fmt::format("makes more than {} cells: fewer levels, seeds, observers or scenarios", kMostCells));
    }
  }

  // The levels 1.0 of two axes that set the same key, for example.
  [[noreturn]] void refuse_again(const CellKey& key, const std::vector<int>& axes) const {
    const std::string what =
        fmt::format("makes a trial that is there already, {} {} with {}", key.scenario, key.observer, key.overrides);
    if (axes.empty()) throw InputError(spec_.scenarios_place, "", what);
    const AxisSpec& axis = spec_.axes[static_cast<std::size_t>(axes.back())];
    throw InputError(axis.place, "axis." + axis.axis.name, what + "; allowed: levels of its own");
  }

  // Resolved scenarios of one name that differ in their overrides are told apart by a number.
  std::size_t add_scenario(Scenario&& scenario, ResolvedScenario&& resolved) {
    const auto [it, added] = places_.emplace(std::pair(resolved.name, resolved.toml), plan_.scenarios.size());
    if (!added) return it->second;
    const int number = ++named_[resolved.name];
    resolved.name += fmt::format("_{:03}", number);
    plan_.scenarios.push_back(std::move(scenario));
    plan_.resolved.push_back(std::move(resolved));
    return it->second;
  }

  std::size_t curve_at(CampaignCurve&& curve) {
    const auto [it, added] = curves_.emplace(std::pair(curve.key, curve.axes), plan_.campaign->curves.size());
    if (added) plan_.campaign->curves.push_back(std::move(curve));
    return it->second;
  }

  void sort_cells() {
    std::vector<std::size_t> order(plan_.cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto place = [&](std::size_t i) {
      const CampaignCell& cell = plan_.campaign->cells[i];
      return std::tuple(cell.curve, cell.level, plan_.cells.seed(i));
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    SeededList<PlannedCell> cells;
    std::vector<CampaignCell> places;
    for (const std::size_t i : order) {
      cells.push_back(plan_.cells[i]);
      places.push_back(plan_.campaign->cells[i]);
    }
    plan_.cells = std::move(cells);
    plan_.campaign->cells = std::move(places);
  }

  const CampaignSpec& spec_;
  BatchPlan plan_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  // name and text -> index into plan_.scenarios
  std::set<CellKey> keys_;                                             // without seeds: each row has all of them
  std::map<std::string, int> named_;                                   // scenarios of a name so far
  std::map<std::pair<CellKey, std::vector<int>>, std::size_t> curves_;
};

long budget_of_curve(const CampaignSpec& spec, const BatchPlan& plan) {
  const auto curves = static_cast<long>(plan.campaign->curves.size());
  const long cells = static_cast<long>(plan.cells.size());
  const bool whole = spec.kind == CampaignKind::kMap || spec.kind == CampaignKind::kFactorial;
  const bool given = spec.trials > 0 || spec.trials_per_curve > 0;
  const long of_curve = spec.trials > 0 ? spec.trials / std::max(curves, 1L) : spec.trials_per_curve;
  const long most = spec.trials > 0 ? spec.trials : spec.trials_per_curve * curves;
  if (whole && given && cells > most) {
    throw InputError(spec.budget_place, "budget",
                     fmt::format("{} trials, but the whole of a {} is run: {} cells on {} curves", most,
                                 spec.kind == CampaignKind::kMap ? "map" : "factorial", cells, curves));
  }
  if (whole) return cells;
  std::size_t levels = 0;
  for (const AxisSpec& axis : spec.axes) levels = std::max(levels, axis.axis.levels.size());
  const long least = least_trials(spec.kind, levels, spec.seeds);
  if (given && of_curve < least) {
    throw InputError(spec.budget_place, "budget",
                     fmt::format("{} trials for {} curves; allowed: at least {} for each, {} in all", most, curves,
                                 least, least * curves));
  }
  if (given) return of_curve;
  return spec.kind == CampaignKind::kLimit ? kDefaultTrials : cells;
}

}  // namespace

CampaignPlan plan_campaign(const CampaignSpec& spec) {
  require_estimators(spec);
  CampaignPlan plan{Planner(spec).plan(), 0};
  if (plan.batch.cells.empty()) {
    throw InputError(spec.scenarios_place, "",
                     "makes no cell: no observer has an option that the axis scales (observer_scale)");
  }
  plan.trials_per_curve = budget_of_curve(spec, plan.batch);
  return plan;
}

}  // namespace dob
