// Figures of a campaign: what it has found, one figure for each block of curves that are compared.
#pragma once

#include <vector>

#include "results/campaign_result.h"
#include "results/figure.h"
#include "results/figure_cells.h"
#include "results/figure_spec.h"

namespace dob {

struct CampaignFigure {
  FigureSpec spec;  // id, caption, note
  Figure figure;
};

// limit01, breakdown01, ... (falls, thresholds and CoM errors over the level), map01, map01_com, ... (heat maps), or
// factorial (shares of variance). Of the curves that the request asks for. Throws StoreError if there is none.
std::vector<CampaignFigure> campaign_figures(const CampaignResult& result, const FigureRequest& request);

}  // namespace dob
