#include "results/figure_cells.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/claim_cells.h"

namespace dob {
namespace {

constexpr const char* kNoProfile = "-";  // of an observer that has none

// `wish`, else `favourite` if the run has it, else its first value.
std::string chosen(const Run& run, std::string CellKey::*member, const std::string& wish, const std::string& favourite,
                   const std::string& what) {
  std::vector<std::string> values;
  for (const CellKey& key : run.info.cells.rows()) {
    const std::string& value = key.*member;
    if (value != kNoProfile && std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  const auto has = [&](const std::string& value) {
    return std::find(values.begin(), values.end(), value) != values.end();
  };
  if (!wish.empty() && !has(wish)) {
    throw StoreError(fmt::format("--{} {}: the run has {}", what, wish, fmt::join(values, ", ")));
  }
  if (!wish.empty()) return wish;
  return has(favourite) ? favourite : values.empty() ? kNoProfile : values.front();
}

// Of each scenario what was wished for, else `favourite` if it has that, else its first value.
std::map<std::string, std::string> chosen_gains(const Run& run, const std::string& wish, const std::string& favourite) {
  std::map<std::string, std::string> gains;
  for (const CellKey& key : run.info.cells.rows()) {
    std::string& of_scenario = gains.try_emplace(key.scenario, wish.empty() ? key.gains : wish).first->second;
    if (wish.empty() && key.gains == favourite) of_scenario = favourite;
  }
  return gains;
}

// Each once, in the order of the cells.
std::string listed(const Run& run, const std::map<std::string, std::string>& gains) {
  std::vector<std::string> names;
  for (const CellKey& key : run.info.cells.rows()) {
    const std::string& name = gains.at(key.scenario);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

FigureCells::FigureCells(const std::filesystem::path& dir, Run run, const FigureRequest& request)
    : dir_(dir), run_(std::move(run)), request_(request) {
  request_.profile = chosen(run_, &CellKey::profile, request.profile, "tuned", "profile");
  chosen(run_, &CellKey::gains, request.gains, "", "gains");  // refuses a wish that the run does not have
  gains_ = chosen_gains(run_, request.gains, "paper");
  request_.gains = listed(run_, gains_);
  request_.planner = chosen(run_, &CellKey::planner, request.planner, "", "planner");
  const std::vector<std::string> known = observers();
  for (const std::string& observer : request_.observers) {
    if (std::find(known.begin(), known.end(), observer) == known.end()) {
      throw StoreError(fmt::format("--observer {}: the run has {}", observer, fmt::join(known, ", ")));
    }
  }
}

std::vector<std::string> FigureCells::observers(const std::vector<std::string>& leave_out) const {
  std::vector<std::string> names;
  for (const CellKey& key : run_.info.cells.rows()) {
    if (std::find(leave_out.begin(), leave_out.end(), key.scenario) != leave_out.end()) continue;
    if (std::find(names.begin(), names.end(), key.observer) == names.end()) names.push_back(key.observer);
  }
  return names;
}

bool FigureCells::shown(const CellKey& key, const std::string& profile) const noexcept {
  const std::string& wanted = profile.empty() ? request_.profile : profile;
  return (key.profile == wanted || key.profile == kNoProfile) && key.gains == gains_.at(key.scenario) &&
         key.planner == request_.planner;
}

std::optional<CellKey> FigureCells::planned(const std::string& scenario, const std::string& observer,
                                            const std::string& profile) const {
  std::optional<CellKey> best;
  for (const CellKey& key : run_.info.cells) {
    if (case_name(key) != scenario || key.observer != observer || !shown(key, profile)) continue;
    if (!best || (key.overrides == best->overrides && key.seed < best->seed)) best = key;
  }
  return best;
}

FigureCell FigureCells::find(const std::vector<std::string>& scenarios, const std::string& observer,
                             const std::string& profile) {
  for (const std::string& scenario : scenarios) {
    const std::optional<CellKey> key = planned(scenario, observer, profile);
    if (!key) continue;
    const auto cell =
        std::find_if(run_.cells.begin(), run_.cells.end(), [&](const CellResult& c) { return c.key == *key; });
    const std::string name = fmt::format("{}, {}", scenario, observer);
    if (cell == run_.cells.end()) throw StoreError(name + ": has not been run yet");
    if (cell->outcome == Outcome::kError) throw StoreError(fmt::format("{}: could not be run: {}", name, cell->reason));
    if (cell->trace.empty()) throw StoreError(name + ": its time series was not kept (`dobbench run --keep`)");
    return {&*cell, &trace(*cell)};
  }
  const std::vector<CellKey>& rows = run_.info.cells.rows();
  const bool any = std::any_of(rows.begin(), rows.end(), [&](const CellKey& key) {
    return std::any_of(scenarios.begin(), scenarios.end(), [&](const auto& name) { return name == case_name(key); });
  });
  if (!any) throw StoreError(fmt::format("{}: not part of the run", fmt::join(scenarios, " or ")));
  throw StoreError(fmt::format("{}, {}: not part of the run with profile {}, gains {}, planner {}",
                               fmt::join(scenarios, " or "), observer, profile.empty() ? request_.profile : profile,
                               request_.gains, request_.planner));
}

const Trace& FigureCells::trace(const CellResult& cell) {
  const auto found = traces_.find(cell.trace);
  if (found != traces_.end()) return found->second;
  Trace read = read_trace(dir_ / cell.trace);
  for (const auto& column : read.columns) {
    if (column.size() != read.rows()) throw StoreError(fmt::format("{}: its data are damaged", cell.trace));
  }
  if (read.rows() == 0) throw StoreError(fmt::format("{}: has no samples", cell.trace));
  return traces_.emplace(cell.trace, std::move(read)).first->second;
}

}  // namespace dob
