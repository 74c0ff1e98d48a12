// Runs the cells of a plan into a run directory, several at a time, each in its own process.
#pragma once

#include <filesystem>

#include "bench/batch_plan.h"

namespace dob {

struct BatchOptions {
  int jobs = 1;
  double timeout_s = 0.0;     // [s] wall time for one cell; 0: none
  std::filesystem::path out;  // run directory; empty: ./dobbench-results/NNNN
  bool log_csv = false;       // every tick of every cell as logs/CELL.csv
  bool progress = false;      // a progress line on stderr
  std::string command_line;
};

struct BatchSummary {
  std::filesystem::path dir;
  std::size_t errors = 0;  // cells that could not be run
  int stop_signal = 0;     // SIGINT or SIGTERM ended the batch; 0: it is complete
};

// Throws StoreError when the run directory cannot be made or written.
BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options);

}  // namespace dob
