// Figures of a campaign as they stand in a reader's table. Private to results/.
#pragma once

#include <string>

#include "results/campaign_result.h"

namespace dob {

std::string kind_name(CampaignKind kind);  // "limit", "map", "breakdown", "factorial"

// Three significant digits, or all those of a whole number below a million; levels may be milliseconds in seconds.
std::string three_digits(double x);

// "62.3"; "< 20" or "> 150" where the trials say no more than that it is beyond an end of the ladder.
std::string estimate_cell(const FallThreshold& threshold, const CampaignAxis& axis);

// "[55.1, 71]", "[< 20, 71]": an end that is open says so; "> 150" where all of it is beyond the end.
std::string interval_cell(const FallThreshold& threshold, const CampaignAxis& axis);

// "3/8", "-" without a trial.
std::string falls_cell(int falls, int trials);

// "amplitude [N]"
std::string axis_name(const CampaignAxis& axis);

// "limit push_limit: how hard ...: 312 trials of 400 planned cells, 41 fell, 2 could not be run"
std::string campaign_heading(const CampaignResult& result);

}  // namespace dob
