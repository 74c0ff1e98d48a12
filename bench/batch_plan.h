// From what the user asks for to the cells of a batch. Everything is resolved and checked before the first cell runs.
#pragma once

#include <string>
#include <vector>

#include "results/cell.h"
#include "results/store.h"
#include "scenarios/scenario.h"

namespace dob {

struct BatchRequest {
  std::vector<std::string> scenarios;  // empty: every shipped one
  std::vector<std::string> observers;  // specifications; empty: every built-in one
  std::vector<std::string> profiles;   // empty: every shipped one
  std::vector<std::string> gains;      // gain sets of the controller; empty: "paper"
  std::string planner;                 // empty: the scenario's own
  std::vector<std::string> overrides;  // KEY=VALUE
  int first_seed = 1;
  int last_seed = 1;
};

struct PlannedCell {
  CellKey key;
  std::size_t scenario = 0;  // index into BatchPlan::scenarios
  ObserverConfig observer;
};

struct BatchPlan {
  std::vector<Scenario> scenarios;         // one for each scenario, variant and gain set
  std::vector<ResolvedScenario> resolved;  // their resolved files, for the run directory
  std::vector<PlannedCell> cells;          // in the order of the tables; no cell twice
};

// Throws InputError for the first thing that cannot be run.
BatchPlan plan_batch(const BatchRequest& request);

// Name of the resolved scenario that the cell runs.
std::string resolved_name(const CellKey& key);

}  // namespace dob
