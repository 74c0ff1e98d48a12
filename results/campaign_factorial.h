// What a factorial campaign says about its factors. Private to results/.
#pragma once

#include <vector>

#include "results/campaign_cells.h"
#include "results/campaign_result.h"

namespace dob {

// Of the responses "falls" and "log CoM error" (FactorialResult in results/campaign_result.h says what they are).
// `cells`: those of each curve, as of cells_of_curves(). Throws std::invalid_argument for a curve that does not say its
// level of every factor, and for two curves with the same levels.
std::vector<FactorialResult> factorial_results(const Campaign& campaign,
                                               const std::vector<std::vector<CurveCell>>& cells);

}  // namespace dob
