// Which trials a campaign runs next, from how those before have ended.
#pragma once

#include <optional>
#include <vector>

#include "bench/batch.h"
#include "bench/campaign_plan.h"
#include "results/campaign.h"

namespace dob {

inline constexpr long kDefaultTrials = 60;  // of a curve of a limit, if nobody says how many

// The fewest that a curve with an axis of `levels` levels needs to say anything.
long least_trials(CampaignKind kind, std::size_t levels, int seeds);

// What is known at one level of a curve.
struct LevelState {
  int cells = 0;   // seeds that there are
  int trials = 0;  // of them: survived or fell
  int falls = 0;
  int errors = 0;  // could not be run
  int used() const noexcept { return trials + errors; }
};

// Levels whose next unused seed is to be tried, several of one level one after the other; none: the curve is done. They
// depend on the state alone. `left` is what its budget still holds.
//
// A limit is searched for by bisection with trials that may err, and without believing that whoever survives a level
// survives a milder one: first two seeds at levels spread over the whole ladder; then, four at a time, where the
// interval of the 50 % or of the 5 % threshold is widest, with one of the four spent on the least known level
// elsewhere. Done when both intervals are as narrow as the ladder is fine.
std::vector<int> next_of_limit(const CampaignAxis& axis, const std::vector<LevelState>& levels, long left);

// A breakdown tries all seeds of one level after the other, until everything has fallen at two levels running.
std::vector<int> next_of_breakdown(const std::vector<LevelState>& levels, long left);

// Of all curves of the plan that have cells here.
CellChoice campaign_choice(const CampaignPlan& plan);

}  // namespace dob
