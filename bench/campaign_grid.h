// What of a campaign is combined with what, as texts.
#pragma once

#include <string>
#include <vector>

#include "bench/campaign_spec.h"

namespace dob {

// One of what a factorial combines.
struct Combination {
  std::string observer, legs, com;
};

// Every leg estimator with every CoM estimator; "none" leaves its part out.
std::vector<Combination> combinations(const CampaignSpec& spec);

// What is laid over every scenario, with every combination of one of each list of the grid.
std::vector<std::vector<std::string>> grid_of(const CampaignSpec& spec);

// KEY=VALUE of an axis at one of its levels.
std::string with_level(std::string text, double level);

}  // namespace dob
