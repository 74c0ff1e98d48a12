// Runs the cells of a plan into a run directory, several at a time, each in its own process.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/batch_plan.h"

namespace dob {

enum class Keep { kNone, kFirstSeed, kAll };

inline constexpr long kDefaultMemoryLimit_MB = 4000;  // a cell of 46 s needs about a hundredth of it

struct BatchOptions {
  int jobs = 1;
  double timeout_s = 0.0;                         // [s] wall time for one cell; 0: none
  long memory_limit_MB = kDefaultMemoryLimit_MB;  // of addresses for one cell; 0: none
  std::filesystem::path out;                      // run directory; empty: ./dobbench-results/NNNN
  bool resume = false;                            // goes on with the run in `out`, if there is one
  bool retry_errors = false;                      // with resume: cells that could not be run are run again
  bool log_csv = false;                           // time series of every cell as logs/CELL.csv
  double log_rate = 1000.0;                       // [Hz] of these
  Keep keep = Keep::kNone;                        // cells whose time series are kept as traces/CELL.dobtrace
  bool progress = false;                          // a progress line on stderr
  std::string command_line;
};

struct BatchSummary {
  std::filesystem::path dir;
  std::size_t errors = 0;  // cells that could not be run
  int stop_signal = 0;     // SIGINT or SIGTERM ended the batch; 0: it is complete
};

// Of a plan that is not run as a whole, the cells that are wanted next: from the outcomes of those that were wanted so
// far (nullopt: was not) and nothing else, so that a batch that was interrupted, or divided, chooses as one that was
// not. None: it is complete.
struct CellChoice {
  std::function<std::vector<std::size_t>(const std::vector<std::optional<Outcome>>&)> next;
  std::size_t most = 0;  // cells that it will want at most
};

// The results do not depend on jobs, nor on whether the batch was interrupted and resumed. Throws StoreError when the
// run directory cannot be made, holds another run, or is being written by another process; WriteError when it cannot be
// written any more: what was finished by then is kept.
BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options);
// The same of the cells that are chosen.
BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options, const CellChoice& choice);

// What the run directory says about this program, machine and plan.
RunInfo run_info(const BatchPlan& plan, const std::string& command_line);

}  // namespace dob
