// Rows of a run beside the same cells computed anew: are they the same, bit for bit?
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "results/cell.h"
#include "results/table.h"

namespace dob {

enum class Reproduced {
  kEqual,        // state hash, outcome, time, reason, every metric, checkpoint and shadow, bit for bit
  kDifferent,    // the outcome is the same, something else is not
  kFlipped,      // another outcome
  kNotVerified,  // could not be computed again
};

constexpr std::string_view to_string(Reproduced verdict) noexcept {
  constexpr std::string_view kWords[]{"equal", "different", "outcome flipped", "not verified"};
  return kWords[static_cast<std::size_t>(verdict)];
}

struct VerifiedCell {
  CellKey key;
  Reproduced verdict = Reproduced::kNotVerified;
  std::string detail;  // what differs, or why it was not verified; "" when equal
};

// A stored row beside the cell computed anew. A stored timeout says something about a clock and nothing about the cell:
// it cannot be verified; nor can a cell that had a result and has none now, for which the detail gives the reason.
VerifiedCell verified(const CellResult& stored, const CellResult& again);

// How far a metric lies from the stored one, over the cells whose outcome is the same.
struct MetricSpread {
  std::string_view metric;    // of results/metric_fields.h, or simulated_s
  int cells = 0;              // in which both have a value
  int different = 0;          // of these
  double largest = 0.0;       // |stored - again| / max(|stored|, |again|), of the cells that survived,
  double largest_fell = 0.0;  // and of those that fell: the last ticks before a fall amplify anything
  CellKey where;              // of the larger of these
  int one_sided = 0;          // cells in which one of the two has a value and the other has none
};

using CellPair = std::pair<CellResult, CellResult>;  // stored, computed anew

// One for each metric that any cell has. Cells that are errors, now or then, and those that flipped are left out.
std::vector<MetricSpread> metric_spreads(const std::vector<CellPair>& pairs);

struct Verification {
  std::string dir;
  std::size_t planned = 0, finished = 0;  // cells of the run
  long seed = 1;                          // of the sample; without a meaning when that is every finished cell
  std::vector<VerifiedCell> cells;        // the sample, in the order of the run's tables
  // What differs between the programs, or code paths, that computed the rows and this one; "" for the same.
  std::string across;
  std::vector<MetricSpread> spreads;  // empty unless `across`

  std::size_t count(Reproduced verdict) const;
};

// Text, Markdown or CSV; ends in a line end. CSV has every cell of the sample, one a line; the others count them and
// name those that are not equal (across programs: of which more than bits differ).
std::string verification_text(const Verification& verification, TableFormat format);

}  // namespace dob
