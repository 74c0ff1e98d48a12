#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "results/table_formats.h"

namespace dob {
namespace {

// What stands for a character in LaTeX.
std::string_view latex(const char& c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '~':
      return "\\textasciitilde{}";
    case '^':
      return "\\textasciicircum{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '|':
      return "\\textbar{}";
    default:
      return {&c, 1};
  }
}

std::string latex(const std::string& text) {
  std::string out;
  for (const char& c : text) {
    if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) out += '\\';
    out += latex(c);
  }
  return out;
}

// A line that begins with '[' or '*' would be taken for an option of the line end before it.
std::string latex_line(const std::vector<std::string>& cells) {
  return fmt::format("{{}}{} \\\\\n", fmt::join(cells, " & "));
}

std::string latex_block(const TableBlock& block) {
  std::string alignment;
  std::vector<std::string> headings, units;
  for (const BlockColumn& column : block.columns) {
    alignment += column.right ? 'r' : 'l';
    headings.push_back(latex(column.heading));
    units.push_back(latex(column.unit_in_brackets()));
  }
  std::string out = fmt::format(
      "\\begin{{table}}\n\\centering\n\\caption{{{}}}\n\\begin{{tabular}}{{{}}}\n\\toprule\n{}{}\\midrule\n",
      latex(block.title), alignment, latex_line(headings), latex_line(units));
  for (std::size_t i = 0; i < block.rows.size(); ++i) {
    if (std::count(block.rules.begin(), block.rules.end(), i) > 0) out += "\\midrule\n";
    std::vector<std::string> row = block.rows[i];
    for (std::string& cell : row) cell = latex(cell);
    out += latex_line(row);
  }
  out += "\\bottomrule\n\\end{tabular}\n";
  for (const std::string& note : block.notes) out += fmt::format("\\par\\footnotesize {}\n", latex(note));
  return out + "\\end{table}\n\n";
}

}  // namespace

std::string latex_heading(const std::string& line) {
  return fmt::format("\\par\\noindent {}\n\n", latex(line));
}

std::string table_latex(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend) {
  std::string out = "% needs \\usepackage{booktabs}\n";
  for (const TableBlock& block : blocks) out += latex_block(block);
  for (const std::string& line : legend) {
    out += fmt::format("\\par\\noindent{{\\footnotesize {}}}\n", latex(line));
  }
  return out;
}

}  // namespace dob
