// Cells of a run computed again from what its directory holds, and compared with its rows: `dobbench verify`.
#pragma once

#include <filesystem>
#include <vector>

#include "results/verification.h"

namespace dob {

struct VerifyOptions {
  std::size_t sample = 20;  // finished cells, drawn without replacement; 0, or more than there are: all
  long seed = 1;            // of the drawing
  int jobs = 1;
  double timeout_s = 0.0;                      // [s] wall time for one cell; 0: none
  bool across = false;                         // also rows of other programs and code paths, by outcome and metrics
  std::vector<std::filesystem::path> plugins;  // libraries that may be loaded
  bool progress = false;                       // a progress line on stderr
};

struct VerifyResult {
  Verification verification;  // of the cells that were computed before a signal came
  int stop_signal = 0;        // SIGINT or SIGTERM ended it; 0: it is complete
};

// `count` different ones of the numbers below `size`, in increasing order; all of them for 0 or a larger count. The
// same on every machine.
std::vector<std::size_t> draw_sample(std::size_t size, std::size_t count, long seed);

// Throws StoreError when `dir` is no run, has no finished cell, or has been changed since; and, unless `across`, when
// a cell of the sample was computed by another program or on another code path.
VerifyResult verify_run(const std::filesystem::path& dir, const VerifyOptions& options);

}  // namespace dob
