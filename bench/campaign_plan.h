// From what a campaign asks for to the cells that it may need, all of them resolved and checked before the first runs.
#pragma once

#include "bench/batch_plan.h"
#include "bench/campaign_spec.h"

namespace dob {

struct CampaignPlan {
  BatchPlan batch;            // with batch.campaign; its cells by curve, level and seed
  long trials_per_curve = 0;  // that each curve may use
};

// Plugins are loaded in a process of their own first. Throws InputError for the first thing that cannot be run, for a
// budget that is too small for the curves, for an axis that changes nothing, and for more than a million cells.
CampaignPlan plan_campaign(const CampaignSpec& spec);

}  // namespace dob
