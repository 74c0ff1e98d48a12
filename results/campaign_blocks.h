// A campaign's curves side by side: what is compared with what.
#pragma once

#include <string>
#include <vector>

#include "results/campaign_result.h"
#include "results/campaign_text.h"

namespace dob {

// Curves over the same axes that differ in the observer and its profile only.
struct CampaignBlock {
  CellKey key;            // of its first curve; observer and profile have no meaning
  std::vector<int> axes;  // indices into Campaign::axes
  std::vector<const CurveResult*> curves;
};

// In the order of first mention. The result must outlive them.
std::vector<CampaignBlock> campaign_blocks(const CampaignResult& result);

// "case1/tip_lateral, gains paper, planner spline, set terrain.friction=0.5; amplitude [N]"
std::string block_name(const CampaignBlock& block, const Campaign& campaign);

}  // namespace dob
