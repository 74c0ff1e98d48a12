#include <algorithm>
#include <limits>
#include <tuple>

#include "results/table_rows.h"

namespace dob {
namespace {

// Smaller is better.
struct Merit {
  double lost_share;
  double error;  // where every run was lost: minus the time until the fall

  friend auto operator<=>(const Merit&, const Merit&) = default;
};

Merit merit(const TableRow& row) {
  const double lost = row.falls + row.errors;
  const std::optional<double> com = row.metrics[metric_index("com_error_max_m")].median;
  return {lost / (row.runs + row.errors),
          row.until_fall ? -*row.fall_time_median_s : com.value_or(std::numeric_limits<double>::infinity())};
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
    if (row.oracle || row.runs == 0) continue;
    row.rank = 1 + static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const TableRow& other) {
                 return same_block(other.key, row.key) && !other.oracle && other.runs > 0 && merit(other) < merit(row);
               }));
  }
}

}  // namespace dob
