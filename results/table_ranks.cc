#include <algorithm>
#include <optional>
#include <tuple>

#include "results/table_rows.h"

namespace dob {
namespace {

std::optional<double> com_error(const TableRow& row) {
  return row.metrics[metric_index("com_error_max_m")].median;
}

// Smaller is better.
struct Merit {
  double lost_share;
  double error;  // where every run was lost: minus the time until the fall

  friend auto operator<=>(const Merit&, const Merit&) = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

// Of a row that can be ranked.
Merit merit(const TableRow& row) {
  const double lost = row.falls + row.errors;
  return {lost / (row.runs + row.errors), row.until_fall ? -*row.fall_time_median_s : *com_error(row)};
}

// An oracle is a bound; without a run, or without a finite error of those that survived, there is nothing to go by.
bool can_be_ranked(const TableRow& row) {
  return !row.oracle && row.runs > 0 && (row.until_fall || com_error(row));
}

auto block_of(const CellKey& key) noexcept {
  return std::tie(key.scenario, key.variant, key.gains, key.planner, key.overrides);
}

}  // namespace

bool same_block(const CellKey& a, const CellKey& b) noexcept {
  return block_of(a) == block_of(b);
}

void rank_rows(std::vector<TableRow>& rows) {
  for (TableRow& row : rows) {
    if (!can_be_ranked(row)) continue;
    row.rank = 1 + static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const TableRow& other) {
                 return same_block(other.key, row.key) && can_be_ranked(other) && merit(other) < merit(row);
               }));
  }
}

}  // namespace dob
