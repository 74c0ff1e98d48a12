// What a campaign has found: shares of falls and errors over the levels, thresholds, shares of variance.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "results/campaign.h"
#include "results/cell.h"
#include "results/fall_threshold.h"
#include "results/statistics.h"

namespace dob {

struct Run;

// The trials of a curve at one level (of a map: at one pair of levels).
struct LevelResult {
  std::array<int, 2> level{0, 0};
  int planned = 0;  // cells of the plan there
  int trials = 0;   // that have been run and survived or fell
  int falls = 0;
  int errors = 0;                                       // that could not be run
  std::optional<Interval> falls_ci;                     // Wilson; nullopt below eight trials
  std::optional<double> com_error_m, foot_error_m;      // median of the maxima over the survivors
  std::optional<Interval> com_error_ci, foot_error_ci;  // bootstrap; nullopt below eight survivors
};

// A seed that fell at a level and survived a harder one.
struct NonMonotoneSeed {
  int seed = 0;
  double fell_at = 0.0;      // the mildest level at which it fell
  double survived_at = 0.0;  // the hardest level that it survived
};

struct CurveResult {
  CampaignCurve curve;
  std::vector<LevelResult> levels;            // those with cells of the plan, in the order of the levels
  std::optional<FallThreshold> half;          // 50 % falls; one axis only, and nullopt without a trial
  std::optional<FallThreshold> twentieth;     // 5 % falls
  std::vector<NonMonotoneSeed> non_monotone;  // one axis only
  int seeds = 0;                              // that were run at any level
  int trials = 0, falls = 0, errors = 0;
};

// Share of the variance of a response that a factor explains: sum of squares between its levels over the total (eta
// squared), of the balanced part of the design.
struct VarianceShare {
  std::string factor;  // "leg estimator", "leg estimator x gains", "scenario", "seed", "residual"
  int levels = 0;      // of a factor or, for an interaction, combinations; 0 for the residual
  double share = 0.0;
  std::optional<Interval> interval;  // percentile bootstrap over seeds; nullopt below eight seeds
};

// Responses: "falls", 0 or 1; "log CoM error", log10 of com_error_max_m, a fall counting as the largest error of any
// survivor of the campaign. To leave the trials that fell out would make a comparison of what was easy, another part of
// the design for each factor, and the design unbalanced; that a fall is at least as bad as the worst that was survived
// is all that is assumed, and the logarithm keeps it from outweighing the rest (a composite response, ICH E9(R1),
// 2019). Cells that could not be run or have not been run yet have no value; a complete part of the design without them
// is taken by leaving out whole levels and seeds (complete_part() of results/variance_shares.h).
struct FactorialResult {
  std::string response;  // "falls", "log CoM error"
  int trials = 0;        // that it is about
  int left_out = 0;      // planned cells that it is not about: without a value, or with one but left out with them
  // Factors, their pairs, seed, residual; the largest first, the residual last. A factor of which one level is left is
  // not there; nothing is, if no trial differs from the others.
  std::vector<VarianceShare> shares;
};

struct CampaignResult {
  Campaign campaign;
  std::vector<CurveResult> curves;         // of Campaign::curves, in their order
  std::vector<FactorialResult> factorial;  // kFactorial only
  std::size_t planned = 0;                 // cells of the plan; a campaign needs not run all of them
};

// `run` is that of the campaign's directory: campaign.cells and run.info.cells belong together. The same bits whatever
// the order of run.cells. Throws std::invalid_argument for a campaign that is none: cells that are not those of the
// run, curves or levels that are not there, ladders that are not monotone, factorial curves with the same levels.
CampaignResult campaign_result(const Campaign& campaign, const Run& run);

}  // namespace dob
