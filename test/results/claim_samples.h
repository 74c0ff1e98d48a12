// Claims and runs made by hand for the tests of the evaluators.
#pragma once

#include <string>
#include <vector>

#include "results/claims.h"
#include "test/results/run_samples.h"

namespace dob::test {

inline const Setting kPaperSetting{"paper", "paper", "spline", ""};

// A cell of case1/knee that survived, or fell at a time.
inline CellResult cell(const std::string& observer, int seed, const CellMetrics& metrics) {
  CellResult result = survived(key("case1", "knee", observer, "paper", seed), 0.0);
  result.metrics = metrics;
  return result;
}
inline CellResult fallen(const std::string& observer, int seed, double time_s, const CellMetrics& metrics) {
  CellResult result = fell(key("case1", "knee", observer, "paper", seed), time_s, 0.0);
  result.metrics = metrics;
  return result;
}

// What the evaluator says about case1/knee in the run of these cells.
template <typename Test>
Finding ask(const Test& claim, const std::vector<CellResult>& cells) {
  const Run run = run_of(cells);
  const CellGroups groups(run);
  return evaluate(claim, ClaimView(groups, {"case1/knee"}, kPaperSetting));
}

}  // namespace dob::test
