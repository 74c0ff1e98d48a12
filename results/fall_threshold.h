// The level of an axis at which a stated share of the trials falls, and how well the trials tell.
#pragma once

#include <vector>

#include "results/statistics.h"

namespace dob {

// Trials at one level of an axis. Cells that could not be run are in neither number.
struct LevelCount {
  double level = 0.0;
  int trials = 0;
  int falls = 0;
};

struct FallThreshold {
  double estimate = 0.0;  // median of the posterior, at most an end of the ladder
  Interval interval;      // its 95 %, in the order of numbers: low <= estimate <= high
  bool below = false;  // the ends of the interval reach the mildest or the hardest level of the ladder and say no more
  bool above = false;  // than "milder" or "harder"; so does the estimate, if it is that level
};

// Posterior of the level at which `share` (0 to 1, both excluded) of the trials falls, for the model
//   P(fall at x) = g + (1 - g - l) / (1 + exp(-(x - m) / s)),  x = level or its logarithm, counted so that it grows
//                                                              from the mildest to the hardest level
// with the midpoint m uniform over the ladder and half its width beyond either end, s log-uniform from a fiftieth of
// the ladder's width to its width, and lapses g, l (falls and survivals that have nothing to do with the level) from 0
// to 0.1. On a grid, without random numbers. `counts` from the mildest to the hardest level of the whole ladder, those
// without trials too; without any trial it is what the model says before them.
// The threshold is that of the logistic part: where 1 / (1 + exp(-(x - m) / s)) = share. With lapses there need not be
// a level at which a small share of all trials falls, and falls that have nothing to do with the level do not move the
// level that matters. What the posterior says beyond the ends of the ladder is the prior, not the trials: estimate and
// interval end there.
// Method: adaptive threshold estimation, Kontsevich & Tyler, Vision Research 39 (1999); lapses after Wichmann & Hill,
// Perception & Psychophysics 63 (2001).
// Throws std::invalid_argument for fewer than two levels, levels that are not finite, not monotone or, on a logarithmic
// ladder, not positive, for counts that cannot be, and for a share out of range.
FallThreshold fall_threshold(const std::vector<LevelCount>& counts, bool logarithmic, double share);

}  // namespace dob
