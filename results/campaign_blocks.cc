#include "results/campaign_blocks.h"

#include <algorithm>

#include <fmt/format.h>

#include "results/claim_cells.h"

namespace dob {
namespace {

bool belongs(const CurveResult& result, const CampaignBlock& block) {
  CellKey key = result.curve.key;
  key.observer = block.key.observer;
  key.profile = block.key.profile;
  return key == block.key && result.curve.axes == block.axes;
}

}  // namespace

std::vector<CampaignBlock> campaign_blocks(const CampaignResult& result) {
  std::vector<CampaignBlock> blocks;
  for (const CurveResult& curve : result.curves) {
    auto block = std::find_if(blocks.begin(), blocks.end(), [&](const CampaignBlock& b) { return belongs(curve, b); });
    if (block == blocks.end()) {
      blocks.push_back({curve.curve.key, curve.curve.axes, {}});
      block = blocks.end() - 1;
    }
    block->curves.push_back(&curve);
  }
  return blocks;
}

std::string block_name(const CampaignBlock& block, const Campaign& campaign) {
  std::string name = fmt::format("{}, gains {}, planner {}", case_name(block.key), block.key.gains, block.key.planner);
  if (!block.key.overrides.empty()) name += ", set " + block.key.overrides;
  for (std::size_t i = 0; i < block.axes.size(); ++i) {
    name += (i == 0 ? "; " : " and ") + axis_name(campaign.axes.at(static_cast<std::size_t>(block.axes[i])));
  }
  return name;
}

}  // namespace dob
