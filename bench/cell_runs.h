// Cells in processes of their own: what `run` and `verify` share.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "bench/batch_plan.h"
#include "bench/trial.h"
#include "bench/worker_pool.h"
#include "results/cell.h"
#include "results/seeded_list.h"

namespace dob {

// The cell's trial in the calling process, under its key. Throws as Trial does.
CellResult run_cell(const CellKey& key, const Scenario& scenario, const PlannedObserver& observer,
                    const Trial::Sink& sink = {});

// `compute(i)` in a process of its own for each of `keys`, and `done(i, result)` in this one, in the order in which
// they end. A cell whose process comes to no result, for whatever reason, is a row of outcome kError with that reason.
// Files of a cell that cannot be written are no property of the cell: WriteError is thrown and the processes are ended.
// On SIGINT or SIGTERM the processes are ended and the number of the signal is returned; 0 otherwise.
int run_cells(const CellKeys& keys, const WorkerOptions& options, const std::function<CellResult(std::size_t)>& compute,
              const std::function<void(std::size_t, const CellResult&)>& done);

}  // namespace dob
