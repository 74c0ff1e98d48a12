// A campaign: many trials that differ in one or two axes (an amplitude, a delay, a bandwidth) and in the seed, so that
// "it fell" becomes a share of falls over an axis. What belongs to which curve stands in the run's database beside the
// cells; what has become of them is read from the run as always.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/cell.h"

namespace dob {

enum class CampaignKind {
  kLimit,      // one axis, searched for where trials begin to fall
  kMap,        // two axes, every level of one with every level of the other
  kBreakdown,  // several axes, one at a time, from the mildest level until everything falls
  kFactorial,  // no axis: every combination of what a cell can be made of
};

struct CampaignAxis {
  std::string name;            // for people: "amplitude"
  std::string unit;            // "N"; "" for a plain number
  std::vector<double> levels;  // from the mildest to the hardest: the numbers may descend. At least two, no two equal
  bool logarithmic = false;    // levels are positive and evenly spaced in their logarithm
};

// Cells that differ in the levels of its axes and in the seed only.
struct CampaignCurve {
  CellKey key;            // seed 0. `overrides` are those of all its cells; what an axis changes is not in the key
  std::vector<int> axes;  // indices into Campaign::axes: kLimit and kBreakdown one, kMap two, kFactorial none
  std::vector<std::string> factors = {};  // kFactorial: its level of each of Campaign::factors
};

// Where a planned cell belongs.
struct CampaignCell {
  std::size_t curve = 0;
  std::array<int, 2> level{0, 0};  // index into the levels of the curve's first and second axis; 0 where it has none
};

struct Campaign {
  CampaignKind kind = CampaignKind::kLimit;
  std::string name;      // of its file, without the ending
  std::string summary;   // one line
  std::string document;  // the file's text with what the command line laid over it
  std::vector<CampaignAxis> axes;
  std::vector<std::string> factors;   // kFactorial: "scenario", "leg estimator", "CoM estimator", "gains", "planner"
  std::vector<CampaignCurve> curves;  // in the order of the tables
  std::vector<CampaignCell> cells;    // one for each of RunInfo::cells, in their order
};

// What the run in `dir` is a campaign of; nullopt for a run that is none. Throws StoreError.
std::optional<Campaign> read_campaign(const std::filesystem::path& dir);

}  // namespace dob
