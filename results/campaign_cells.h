// The cells of a campaign, sorted into its curves. Private to results/.
#pragma once

#include <array>
#include <vector>

#include "results/campaign.h"
#include "results/store.h"

namespace dob {

// A planned cell of a curve and what has become of it.
struct CurveCell {
  std::array<int, 2> level{0, 0};  // as CampaignCell::level
  int seed = 0;
  const CellResult* result = nullptr;  // in Run::cells; nullptr: not run yet
};

bool survived(const CurveCell& cell) noexcept;
bool fell(const CurveCell& cell) noexcept;
bool has_error(const CurveCell& cell) noexcept;  // it could not be run

// For each of Campaign::curves its cells by level, then seed, whatever the order in which they ended.
// Throws std::invalid_argument for a campaign and a run that do not belong together, and for a cell of a curve or level
// that the campaign does not have.
std::vector<std::vector<CurveCell>> cells_of_curves(const Campaign& campaign, const Run& run);

}  // namespace dob
