// Runs of two groups compared seed by seed, for claims that set one figure against another.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "results/claim_cells.h"

namespace dob {

// Figures of the same runs, in the same order.
struct PairedFigures {
  std::vector<double> a, b;
  std::optional<double> until;  // [s] the earliest end of a common time that a fall has cut short
};

// Of every two runs of one seed that compare: on the time that both stood where the metric (index into kMetricFields)
// has checkpoints, else where both survived (results/paired.h).
PairedFigures pair_by_seed(const CellGroup& a, const CellGroup& b, std::size_t metric);

// The same over the cases that both have.
PairedFigures pair_by_case(const std::vector<const CellGroup*>& a, const std::vector<const CellGroup*>& b,
                           std::size_t metric);

// "17.5 (17.6) mm": median and largest. There must be a figure.
std::string describe_all(std::size_t metric, const std::vector<double>& figures);

}  // namespace dob
