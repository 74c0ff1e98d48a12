// The comparison table as readers see it: blocks of cells of text, before any format. Private to results/.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/table_rows.h"

namespace dob {

struct BlockColumn {
  std::string heading;
  std::string unit = {};  // "" for none
  bool right = true;      // aligned to the right

  std::string unit_in_brackets() const { return unit.empty() ? "" : "[" + unit + "]"; }
};

struct TableBlock {
  std::string title;
  std::vector<BlockColumn> columns;
  std::vector<std::vector<std::string>> rows = {};
  std::vector<std::string> notes = {};  // what the rows cannot say: errors with reasons, what is not run yet
  std::vector<std::size_t> rules = {};  // a rule stands before these rows
  // A block that is too wide for the screen is cut into several between the columns behind these, which are repeated;
  // 0: it is not cut.
  std::size_t fixed_columns = 0;
};

// The rows of the comparison, in blocks of rows that share everything but observer and profile (by observer: everything
// but scenario and variant).
std::vector<TableBlock> comparison_blocks(const std::vector<TableRow>& rows, TableOrder order);

// What a serial pass measured, in the same blocks; none of those in which nothing was timed.
std::vector<TableBlock> timing_blocks(const std::vector<TableRow>& rows, TableOrder order);

// Which observer to use, on one screen: observers against scenarios, a block for each set of gains, planner and
// overrides that has at least two of both.
std::vector<TableBlock> summary_blocks(const std::vector<TableRow>& rows);

// What columns and marks mean, one sentence group per entry.
std::vector<std::string> comparison_legend(const std::vector<TableRow>& rows);
std::vector<std::string> timing_legend();
std::vector<std::string> summary_legend();

}  // namespace dob
