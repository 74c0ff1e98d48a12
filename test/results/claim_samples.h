// Claims and runs made by hand for the tests of the evaluators.
#pragma once

#include <string>
#include <vector>

#include "results/claims.h"
#include "test/results/run_samples.h"

namespace dob::test {

inline const Setting kPaperSetting{"paper", "paper", "spline", ""};

// The checkpoint at a trial's end, with the metrics of the whole.
inline CellResult with_end(CellResult cell) {
  const CellMetrics& m = cell.metrics;
  cell.checkpoints.push_back({.t = cell.simulated_s,
                              .com_error_max_m = m.com_error_max_m,
                              .com_error_rms_m = m.com_error_rms_m,
                              .path_error_max_m = m.path_error_max_m,
                              .foot_error_max_m = m.foot_error_max_m,
                              .grf_error_mean_N = m.grf_error_mean_N});
  return cell;
}

// A cell of case1/knee that survived, or fell at a time; its checkpoints before the end.
inline CellResult cell(const std::string& observer, int seed, const CellMetrics& metrics,
                       std::vector<MetricsCheckpoint> checkpoints = {}) {
  CellResult result = survived(key("case1", "knee", observer, "paper", seed), 0.0);
  result.metrics = metrics;
  result.checkpoints = std::move(checkpoints);
  return with_end(result);
}
inline CellResult fallen(const std::string& observer, int seed, double time_s, const CellMetrics& metrics,
                         std::vector<MetricsCheckpoint> checkpoints = {}) {
  CellResult result = fell(key("case1", "knee", observer, "paper", seed), time_s, 0.0);
  result.metrics = metrics;
  result.checkpoints = std::move(checkpoints);
  return with_end(result);
}

// What the evaluator says about case1/knee in the run of these cells.
template <typename Test>
Finding ask(const Test& claim, const std::vector<CellResult>& cells) {
  const Run run = run_of(cells);
  const CellGroups groups(run);
  return evaluate(claim, ClaimView(groups, {"case1/knee"}, kPaperSetting));
}

}  // namespace dob::test
