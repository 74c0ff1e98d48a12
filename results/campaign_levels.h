// What the cells of one curve say level by level. Private to results/.
#pragma once

#include <vector>

#include "results/campaign_cells.h"
#include "results/campaign_result.h"

namespace dob {

// One for each level with cells. `cells` are sorted as cells_of_curves() sorts them.
std::vector<LevelResult> level_results(const std::vector<CurveCell>& cells);

// Seeds that fell at a level of the axis and survived a harder one, by seed.
std::vector<NonMonotoneSeed> non_monotone_seeds(const std::vector<CurveCell>& cells, const CampaignAxis& axis);

}  // namespace dob
