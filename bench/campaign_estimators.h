// Whether the observers that a campaign names are what it takes them for.
#pragma once

#include "bench/campaign_spec.h"

namespace dob {

// Profiles that are there; of a factorial, estimators of legs among the legs and of the CoM among `com`; plugins that
// survive being loaded, in a process of their own. Throws InputError at the place in the campaign's file.
void require_estimators(const CampaignSpec& spec);

}  // namespace dob
