// The table of a campaign for programs. Private to results/.
#pragma once

#include <string>

#include "results/campaign_result.h"

namespace dob {

std::string campaign_json(const CampaignResult& result);
std::string campaign_csv(const CampaignResult& result);

}  // namespace dob
