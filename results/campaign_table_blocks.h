// What a campaign has found, as readers see it, before any format. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/campaign_result.h"
#include "results/table_blocks.h"

namespace dob {

// A row for each curve, in blocks of curves that compete (results/campaign_ranks.h).
std::vector<TableBlock> limit_blocks(const CampaignResult& result);

// The same, with a column for each level of the axis.
std::vector<TableBlock> breakdown_blocks(const CampaignResult& result);

// A block for each curve: levels of its first axis down, of its second across.
std::vector<TableBlock> map_blocks(const CampaignResult& result);

// A block for each response.
std::vector<TableBlock> factorial_blocks(const CampaignResult& result);

// Those of its kind, and what their columns mean, one sentence group per entry.
std::vector<TableBlock> campaign_table_blocks(const CampaignResult& result);
std::vector<std::string> campaign_legend(CampaignKind kind);

}  // namespace dob
