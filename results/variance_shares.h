// Shares of variance in a complete factorial design. Private to results/.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/campaign_result.h"

namespace dob {

// One value for every combination of the levels of the factors with every seed.
struct FactorialDesign {
  std::vector<std::string> factors;
  std::vector<int> levels;     // of each factor, and last the number of seeds
  std::vector<double> values;  // the seed is the index that runs fastest, then the last factor
};

// The same, but some values are missing.
struct PartialDesign {
  std::vector<std::string> factors;
  std::vector<int> levels;
  std::vector<std::optional<double>> values;
};

// A complete part of the design: time and again that level of a factor, or that seed, is left out which lacks the
// largest share of its values, until none lacks any. So an observer that could not be run at all goes as a level, and a
// lone error takes its seed or its level with it, whichever is smaller; among equals the seed goes first. Greedy: not
// always the largest complete part. Without values, if none is left.
FactorialDesign complete_part(const PartialDesign& design);

// Analysis of variance of a complete design with one value per combination and seed: sum of squares over the total (eta
// squared) for the factors, their pairs, and the seed as a block; the residual is the rest, interactions of three and
// more factors and those with the seed. They sum to 1. The largest first, the residual last. Factors of one level and a
// single seed have no share and are not there; nothing is, if the values are all the same.
// Intervals: 95 %, percentile bootstrap over seeds (a seed is drawn with all its values), seeded, the same bits with
// every standard library; nullopt below kMinSamplesForInterval seeds. A share is never negative, so that of a factor
// that does nothing has an interval above 0: it is the size of what chance does.
// Source: D. C. Montgomery, Design and Analysis of Experiments, ch. 5; B. Efron & R. Tibshirani, An Introduction to the
// Bootstrap (1993), ch. 13.
// Throws std::invalid_argument for a design whose sizes do not agree.
std::vector<VarianceShare> variance_shares(const FactorialDesign& design);

}  // namespace dob
