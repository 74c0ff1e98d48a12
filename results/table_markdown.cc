#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "results/table_formats.h"

namespace dob {
namespace {

// Characters that Markdown gives a meaning, escaped.
std::string markdown(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("|*_`<[]\\").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string markdown_line(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_block(const TableBlock& block) {
  std::vector<std::string> headings, rules;
  for (const BlockColumn& column : block.columns) {
    headings.push_back(column.unit.empty() ? column.heading
                                           : column.heading + " " + markdown(column.unit_in_brackets()));
    rules.emplace_back(column.right ? "---:" : "---");
  }
  std::string out = fmt::format("### {}\n\n{}{}", markdown(block.title), markdown_line(headings), markdown_line(rules));
  for (std::vector<std::string> row : block.rows) {
    std::transform(row.begin(), row.end(), row.begin(), markdown);
    out += markdown_line(row);
  }
  out += "\n";
  for (const std::string& note : block.notes) out += "- " + markdown(note) + "\n";
  return block.notes.empty() ? out : out + "\n";
}

}  // namespace

std::string markdown_heading(const std::string& line) {
  return markdown(line) + "\n\n";
}

std::string table_markdown(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend) {
  std::string out;
  for (const TableBlock& block : blocks) out += markdown_block(block);
  return fmt::format("{}{}\n", out, markdown(fmt::format("{}", fmt::join(legend, "\n"))));
}

}  // namespace dob
