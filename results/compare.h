// Two runs of the same cells compared, run by run: has something become worse?
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/metric_fields.h"
#include "results/paired.h"
#include "results/store.h"

namespace dob {

// One row of the tables, over the seeds that both runs hold.
struct ComparedRow {
  CellKey key;    // its seed has no meaning
  int cells = 0;  // that both runs hold
  int falls_a = 0, falls_b = 0, errors_a = 0, errors_b = 0;
  PairedDifference difference;  // b - a
  std::string regression;       // why b is worse; "" when it is not
};

struct Comparison {
  std::string_view metric;
  std::vector<ComparedRow> rows;        // in the order of a's tables
  std::vector<CellKey> only_a, only_b;  // rows of which one of the runs holds no cell; their seeds have no meaning

  bool regression() const noexcept;
};

// Cells are paired by their whole key. A metric that checkpoints hold is compared on the time that both runs stood
// (results/paired.h), any other one over the pairs of which both survived.
//
// A row is a regression when in b
//  - more cells could not be run, or more runs fell, than in a; or
//  - the 95 % interval of the median difference lies above zero (from kMinSamplesForInterval pairs on); or,
//  - with fewer pairs, every single one is worse by more than 5 % of its value in a.
// Larger is worse for every metric there is. Throws std::invalid_argument when the runs share no row.
Comparison compare_runs(const Run& a, const Run& b, const MetricField& metric);

// For readers: one line per row, the regressions' reasons, what is only in one of the runs.
std::string comparison_text(const Comparison& comparison);

}  // namespace dob
