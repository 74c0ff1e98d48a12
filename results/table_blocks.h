// The comparison table as readers see it: blocks of cells of text, before any format. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/table_rows.h"

namespace dob {

struct BlockColumn {
  std::string heading;
  std::string unit;   // "" for none
  bool right = true;  // aligned to the right

  std::string unit_in_brackets() const { return unit.empty() ? "" : "[" + unit + "]"; }
};

// Rows that share everything but observer and profile (by observer: everything but scenario and variant).
struct TableBlock {
  std::string title;
  std::vector<BlockColumn> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;  // what the rows cannot say: errors with reasons, what is not run yet
};

std::vector<TableBlock> make_blocks(const Run& run, const TableOptions& options);

// What columns and marks mean, one sentence group per entry.
std::vector<std::string> table_legend(const TableOptions& options);

}  // namespace dob
