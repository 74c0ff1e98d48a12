// What the page says of a campaign. Private to results/. The data is described in docs/report.md.
#pragma once

#include <string>
#include <vector>

#include "results/campaign_result.h"
#include "results/store.h"
#include "results/store_json.h"

namespace dob {

// Null for a run that is none. `run` is the campaign's, for the reasons why cells could not be run.
Json campaign_json(const std::optional<CampaignResult>& result, const Run& run);

// The part of a campaign's run that the page lists cell by cell, because it may hold their time series: of each curve
// and level the first cell that has one. All of them would make a page of tens of megabytes that nobody can read.
Run run_with_series(const Run& run, const Campaign& campaign);

}  // namespace dob
