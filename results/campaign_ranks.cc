#include "results/campaign_ranks.h"

#include <algorithm>
#include <utility>

#include "observers/factory.h"
#include "results/table_rows.h"

namespace dob {
namespace {

bool can_be_ranked(const CurveResult& curve) {
  const std::string& observer = curve.curve.key.observer;
  return curve.half && curve.twentieth && !is_oracle(observer.substr(0, observer.find(':')));
}

// How hard the levels are at which a half and a twentieth of the trials fall: larger is better.
std::pair<double, double> merit(const CurveResult& curve, const Campaign& campaign) {
  const std::vector<double>& levels = campaign.axes[static_cast<std::size_t>(curve.curve.axes[0])].levels;
  const double harder = levels.back() > levels.front() ? 1.0 : -1.0;
  return {harder * curve.half->estimate, harder * curve.twentieth->estimate};
}

}  // namespace

bool same_campaign_block(const CurveResult& a, const CurveResult& b) {
  return a.curve.axes == b.curve.axes && same_block(a.curve.key, b.curve.key);
}

std::vector<std::optional<int>> campaign_ranks(const CampaignResult& result) {
  std::vector<std::optional<int>> ranks(result.curves.size());
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const CurveResult& own = result.curves[i];
    if (!can_be_ranked(own)) continue;
    ranks[i] = 1 + static_cast<int>(std::count_if(result.curves.begin(), result.curves.end(), [&](const auto& other) {
                 return same_campaign_block(other, own) && can_be_ranked(other) &&
                        merit(other, result.campaign) > merit(own, result.campaign);
               }));
  }
  return ranks;
}

}  // namespace dob
