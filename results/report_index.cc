#include "results/report_index.h"

#include <algorithm>

#include "results/claim_cells.h"

namespace dob {
namespace {

using Name = std::vector<std::string>;

Name named_scenario(const CellKey& cell) {
  return {cell.scenario, cell.variant};
}

Name named_observer(const CellKey& cell) {
  return {cell.observer, cell.profile};
}

Name setting_name(const CellKey& cell) {
  return {cell.gains, cell.planner, cell.overrides};
}

// An observer may have an '@' in its options.
std::string unique_id(const CellKey& cell, const std::vector<std::string>& taken) {
  std::string id = cell.profile == "-" ? cell.observer : cell.observer + "@" + cell.profile;
  while (std::find(taken.begin(), taken.end(), id) != taken.end()) id += "'";
  return id;
}

}  // namespace

void ReportIndex::Part::add(const std::vector<std::string>& name, const CellKey& cell) {
  if (places.emplace(name, first.size()).second) first.push_back(cell);
}

ReportIndex::ReportIndex(const CellKeys& cells) {
  for (const CellKey& cell : cells) {
    scenarios_.add(named_scenario(cell), cell);
    observers_.add(named_observer(cell), cell);
    settings_.add(setting_name(cell), cell);
  }
  for (const CellKey& cell : observers_.first) observer_ids_.push_back(unique_id(cell, observer_ids_));
}

std::size_t ReportIndex::scenario(const CellKey& cell) const {
  return scenarios_.places.at(named_scenario(cell));
}

std::size_t ReportIndex::observer(const CellKey& cell) const {
  return observers_.places.at(named_observer(cell));
}

std::size_t ReportIndex::setting(const CellKey& cell) const {
  return settings_.places.at(setting_name(cell));
}

std::string ReportIndex::scenario_id(const CellKey& cell) const {
  return case_name(cell);
}

const std::string& ReportIndex::observer_id(const CellKey& cell) const {
  return observer_ids_[observer(cell)];
}

Json ReportIndex::ids(const CellKey& cell) const {
  return {{"scenario_id", scenario_id(cell)}, {"observer_id", observer_id(cell)}, {"setting", setting(cell)}};
}

}  // namespace dob
