// The single figures of a campaign. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/campaign_blocks.h"
#include "results/figure.h"
#include "results/figure_style.h"

namespace dob {

struct CurveLook {
  std::string label;  // observer, with its profile where the block has several of them
  FigureLook look;
};

// Of each curve of the block, in their order. Profiles of one observer share its colour and differ by dash.
std::vector<CurveLook> curve_looks(const CampaignBlock& block);

// Panels over the level: share of falls with Wilson intervals; the levels at which 50 % and 5 % fall; median CoM error.
Figure fall_curves_figure(const Campaign& campaign, const CampaignBlock& block);

enum class HeatMapValue { kFalls, kComError };

// A panel for each curve; first axis across, second one up. Pairs of levels without a trial are crossed.
Figure heat_map_figure(const Campaign& campaign, const CampaignBlock& block, HeatMapValue value);

// A panel of bars for each response.
Figure variance_figure(const CampaignResult& result);

}  // namespace dob
