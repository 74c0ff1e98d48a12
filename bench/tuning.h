// The recorded tuning procedure behind the profile "tuned": the same for every observer, repeatable from its data.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/batch.h"
#include "results/cell.h"
#include "scenarios/tuning.h"

namespace dob {

// Specifications `OBSERVER:key=value,...` to try: first the observer as its profile has it, then `count` - 1 random
// draws from the space. The draws depend on the observer's name and the count's order only: the first n of a larger
// count are the same.
std::vector<std::string> tuning_candidates(const std::string& observer, const std::vector<TuningParameter>& space,
                                           int count);

// How a candidate did. Fewer falls (cells that could not be run count as falls) always win; the score decides among
// equals: mean over the cells of com_error_max / com_scale + foot_error_max / foot_scale for survivors, of the share
// of the time it did not last plus ten for the others.
struct TuningResult {
  std::string specification;
  int runs = 0;
  int falls = 0;
  double score = 0.0;
  double com_error_max = 0.0;   // [m] mean over the survivors
  double foot_error_max = 0.0;  // [m]

  bool better_than(const TuningResult& other) const noexcept {
    return falls != other.falls ? falls < other.falls : score < other.score;
  }
};
TuningResult judge(const std::string& specification, const std::vector<CellResult>& cells,
                   const TuningProcedure& procedure);

// All candidates of one observer as one batch in `options.out`; results in the order of the candidates. Throws what
// plan_batch and run_batch throw. A batch that was stopped by a signal: its number in `stop_signal`, no results.
std::vector<TuningResult> tune(const std::string& observer, int budget, const BatchOptions& options, int& stop_signal);

}  // namespace dob
