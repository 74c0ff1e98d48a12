// The serial timing pass: `dobbench timing`.
#pragma once

#include "bench/batch_plan.h"
#include "results/cell.h"

namespace dob {

// A cell's first `seconds` (0: its whole trial) alone in this process. The first 0.1 s are left out: they pay for cold
// caches and first page faults. `shadows` do not run along.
CellTiming time_cell(const CellKey& key, const Scenario& scenario, const ObserverConfig& observer, double seconds);

// The first seed of every row of the tables.
std::vector<PlannedCell> first_seeds(const BatchPlan& plan);

}  // namespace dob
