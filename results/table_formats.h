// The comparison table in each of its formats. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/table_blocks.h"
#include "results/table_rows.h"
#include "results/table_shadow.h"

namespace dob {

// For readers: the blocks, then the legend. Text keeps to 158 columns unless a name is too long for it; LaTeX is a
// fragment of tables that needs the package booktabs.
std::string table_text(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend);
std::string table_markdown(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend);
std::string table_latex(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend);

// A line above the blocks that says what they are of; an empty line stands behind it.
std::string text_heading(const std::string& line);
std::string markdown_heading(const std::string& line);
std::string latex_heading(const std::string& line);

// For programs: every metric, SI units, full precision.
// JSON: an array of objects, one per row, fields named in docs/metrics.md; METRIC_ci95 is [low, high].
// CSV: a heading line and one line per row, quoted as in RFC 4180; intervals are two columns, _low and _high.
std::string table_json(const std::vector<TableRow>& rows, bool timing);
std::string table_csv(const std::vector<TableRow>& rows, bool timing);
std::string shadow_json(const std::vector<ShadowRow>& rows);
std::string shadow_csv(const std::vector<ShadowRow>& rows);

}  // namespace dob
