#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "results/table_formats.h"

namespace dob {
namespace {

constexpr std::size_t kTextWidth = 118;   // of sentences
constexpr std::size_t kTableWidth = 158;  // of lines of figures

// Characters on the screen: bytes that do not continue a UTF-8 character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; }));
}

std::string wrapped(const std::string& text, const std::string& indent) {
  std::string out, line = indent;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (line.size() > indent.size() && width_of(line) + 1 + width_of(word) > kTextWidth) {
      out += line + "\n";
      line = indent;
    }
    line += (line.size() > indent.size() ? " " : "") + word;
    begin = end + 1;
  }
  return out + line + "\n";
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string fill(width - width_of(text), ' ');
  return right ? fill + text : text + fill;
}

std::size_t line_width(const std::vector<std::size_t>& widths, std::size_t gap) {
  return std::accumulate(widths.begin(), widths.end(), 2 + gap * (widths.size() - 1));
}

// Two blanks between columns, one if the line would be too long.
std::string gap_between(const std::vector<std::size_t>& widths) {
  return line_width(widths, 2) > kTableWidth ? " " : "  ";
}

std::string text_line(const TableBlock& block, const std::vector<std::size_t>& widths,
                      const std::vector<std::string>& cells) {
  const std::string gap = gap_between(widths);
  std::string line = " ";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += (i == 0 ? " " : gap) + padded(cells[i], widths[i], block.columns[i].right);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::vector<std::vector<std::string>> heading_lines(const TableBlock& block) {
  std::vector<std::string> headings, units;
  for (const BlockColumn& column : block.columns) {
    headings.push_back(column.heading);
    units.push_back(column.unit_in_brackets());
  }
  return {headings, units};
}

std::vector<std::size_t> column_widths(const TableBlock& block) {
  std::vector<std::vector<std::string>> lines = heading_lines(block);
  lines.insert(lines.end(), block.rows.begin(), block.rows.end());
  std::vector<std::size_t> widths(block.columns.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
  }
  return widths;
}

std::string text_lines(const TableBlock& block) {
  const std::vector<std::size_t> widths = column_widths(block);
  std::string out;
  for (const auto& line : heading_lines(block)) out += text_line(block, widths, line);
  for (std::size_t i = 0; i < block.rows.size(); ++i) {
    if (std::count(block.rules.begin(), block.rules.end(), i) > 0) {
      out += fmt::format("  {:-<{}}\n", "", line_width(widths, gap_between(widths).size()) - 2);
    }
    out += text_line(block, widths, block.rows[i]);
  }
  return out;
}

// The fixed columns and [first, last) of the others.
TableBlock part_of(const TableBlock& block, std::size_t first, std::size_t last) {
  const auto cut = [&](const auto& cells) {
    auto part = cells;
    part.erase(part.begin() + static_cast<std::ptrdiff_t>(last), part.end());
    part.erase(part.begin() + static_cast<std::ptrdiff_t>(block.fixed_columns),
               part.begin() + static_cast<std::ptrdiff_t>(first));
    return part;
  };
  TableBlock part{block.title, cut(block.columns)};
  for (const auto& row : block.rows) part.rows.push_back(cut(row));
  part.rules = block.rules;
  return part;
}

// As many columns side by side as the screen has room for, then the next ones below.
std::string cut_lines(const TableBlock& block) {
  const std::vector<std::size_t> widths = column_widths(block);
  const auto fixed_end = widths.begin() + static_cast<std::ptrdiff_t>(block.fixed_columns);
  const std::size_t fixed_width = std::accumulate(widths.begin(), fixed_end, 2 * block.fixed_columns);
  std::string out;
  for (std::size_t first = block.fixed_columns; first < widths.size();) {
    std::size_t last = first, width = fixed_width;
    while (last < widths.size() && (last == first || width + widths[last] + 2 <= kTableWidth)) {
      width += widths[last] + 2;
      ++last;
    }
    if (first > block.fixed_columns) out += "\n";
    out += text_lines(part_of(block, first, last));
    first = last;
  }
  return out;
}

std::string text_block(const TableBlock& block) {
  std::string out = wrapped(block.title, "");
  out += block.fixed_columns > 0 ? cut_lines(block) : text_lines(block);
  for (const std::string& note : block.notes) out += wrapped("! " + note, "  ");
  return out + "\n";
}

}  // namespace

std::string text_heading(const std::string& line) {
  return wrapped(line, "") + "\n";
}

std::string table_text(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend) {
  std::string out;
  for (const TableBlock& block : blocks) out += text_block(block);
  for (const std::string& line : legend) out += wrapped(line, "");
  return out;
}

}  // namespace dob
