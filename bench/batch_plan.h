// From what the user asks for to the cells of a batch. Everything is resolved and checked before the first cell runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/campaign.h"
#include "results/cell.h"
#include "results/store.h"
#include "scenarios/scenario.h"

namespace dob {

struct BatchRequest {
  std::vector<std::string> scenarios;  // empty: the paper's set
  // Specifications; empty: the scenario's own, else every built-in one. A batch that names no scenario runs those that
  // are about certain observers with their own whatever is asked here; likewise with the profiles that belong to them.
  std::vector<std::string> observers;
  std::vector<std::string> shadows;    // specifications of observers that watch every cell, first profile asked for
  std::vector<std::string> profiles;   // empty: every shipped one
  std::vector<std::string> gains;      // gain sets of the controller; empty: of each scenario its own, else "paper"
  std::string planner;                 // empty: the scenario's own
  std::vector<std::string> overrides;  // KEY=VALUE
  int first_seed = 1;
  int last_seed = 1;
};

// The observer in the loop of a cell, and those that watch it.
struct PlannedObserver {
  ObserverConfig observer;
  std::vector<ObserverConfig> shadows = {};  // without the observer in the loop
};

struct PlannedCell {
  CellKey key;
  std::size_t scenario = 0;  // index into BatchPlan::scenarios
  std::size_t observer = 0;  // index into BatchPlan::observers
  int first_seed = 1;        // of its row in the tables

  bool is_first() const noexcept { return key.seed == first_seed; }
  friend auto operator<=>(const PlannedCell&,
                          const PlannedCell&) = default;  // NOLINT(modernize-use-nullptr): see CellKey
};

inline int& seed_of(PlannedCell& cell) noexcept {
  return cell.key.seed;
}

struct BatchPlan {
  std::vector<Scenario> scenarios;         // one for each scenario, variant and gain set
  std::vector<ResolvedScenario> resolved;  // their resolved files, for the run directory
  std::vector<PlannedObserver> observers;  // of all cells
  SeededList<PlannedCell> cells;           // in the order of the tables; no cell twice
  std::vector<std::string> warnings;       // what can be run and is hardly meant: late_loads()
  std::optional<Campaign> campaign;        // what the cells are the plan of, if they are
  std::vector<long> ids;                   // places in the whole plan, from 1, of a shard's cells; empty: all are here
  RunShard shard;                          // take_shard() of bench/shard.h; planned = 0: not yet known
};

// The observers of a list "NAME[:key=value,...],NAME,...": a part with an '=' and no ':' before it is an option of the
// observer before it, except "legs=", which begins a pair.
std::vector<std::string> split_specifications(const std::string& list);

// Throws InputError for the first thing that cannot be run, and for more than a million cells.
BatchPlan plan_batch(const BatchRequest& request);

}  // namespace dob
