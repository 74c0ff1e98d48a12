// The comparison table of a run: one row per (scenario, variant, observer, profile, gains, planner, overrides).
#pragma once

#include <string>

#include "results/store.h"

namespace dob {

enum class TableFormat { kText, kMarkdown, kCsv, kLatex, kJson };
enum class TableOrder { kByScenario, kByObserver };

struct TableOptions {
  TableFormat format = TableFormat::kText;
  TableOrder order = TableOrder::kByScenario;
  bool timing = false;  // adds the figures that differ from run to run
  bool shadow = false;  // the table of the shadow observers instead (results/table_shadow.h)
  // The observer that the others are compared with in pairs of runs, OBSERVER or OBSERVER@PROFILE (results/
  // table_reference.h); empty: `none`, if it is in the run.
  std::string reference = {};
};

// Throws std::invalid_argument for a reference that is not in the run, and for a table of shadows of a run without.
// Plain text, ends in a line end. Depends on the run's cells only, not on the order in which they ended. Text, Markdown
// and LaTeX are for readers: millimetres, rounded, with notes on what went wrong. CSV and JSON hold every metric in SI
// units and full precision. Which runs a figure stands for: results/table_rows.h.
std::string render_table(const Run& run, const TableOptions& options);

}  // namespace dob
