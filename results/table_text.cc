#include <algorithm>
#include <numeric>

#include "results/table_formats.h"

namespace dob {
namespace {

constexpr std::size_t kTextWidth = 118;

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

// Two blanks between columns, one if the line would be too long.
std::string gap_between(const std::vector<std::size_t>& widths) {
  const std::size_t line = std::accumulate(widths.begin(), widths.end(), 2 * widths.size());
  return line > kTextWidth ? " " : "  ";
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

std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
  }
  return widths;
}

std::string text_block(const TableBlock& block) {
  std::vector<std::string> headings, units;
  for (const BlockColumn& column : block.columns) {
    headings.push_back(column.heading);
    units.push_back(column.unit_in_brackets());
  }
  std::vector<std::vector<std::string>> lines{headings, units};
  lines.insert(lines.end(), block.rows.begin(), block.rows.end());
  const std::vector<std::size_t> widths = column_widths(lines);
  std::string out = wrapped(block.title, "");
  for (const auto& line : lines) out += text_line(block, widths, line);
  for (const std::string& note : block.notes) out += wrapped("! " + note, "  ");
  return out + "\n";
}

}  // namespace

std::string table_text(const std::vector<TableBlock>& blocks, const std::vector<std::string>& legend) {
  std::string out;
  for (const TableBlock& block : blocks) out += text_block(block);
  for (const std::string& line : legend) out += wrapped(line, "");
  return out;
}

}  // namespace dob
