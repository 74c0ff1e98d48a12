// The table of a campaign.
#pragma once

#include <string>

#include "results/campaign_result.h"
#include "results/table.h"

namespace dob {

// Plain text, ends in a line end. The same bytes whatever the order in which cells ended. Text, Markdown and LaTeX are
// for readers: a line that says what campaign it is and how much of it has been run, blocks, a legend; three
// significant digits, CoM errors in millimetres. CSV: a line for each curve and level, with what is known of the curve
// repeated; errors in SI units, levels and thresholds in the unit of their axis, which has a column of its own; shares
// of variance are not in it. JSON: an object of the campaign with arrays `axes`, `curves` (each with its `levels`) and
// `factorial`. Both hold full precision.
std::string render_campaign(const CampaignResult& result, TableFormat format);

}  // namespace dob
