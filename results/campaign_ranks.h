// Who stands the hardest levels. Private to results/.
#pragma once

#include <optional>
#include <vector>

#include "results/campaign_result.h"

namespace dob {

// Whether two curves compete: they agree in everything but observer and profile, their axes included.
bool same_campaign_block(const CurveResult& a, const CurveResult& b);

// For each curve its place within its block, 1 the best: half of its trials fall at a harder level; where that is the
// same (beyond an end of the ladder, say), a twentieth does. Equals share a place. nullopt for an oracle (a bound) and
// where there is no threshold.
std::vector<std::optional<int>> campaign_ranks(const CampaignResult& result);

}  // namespace dob
