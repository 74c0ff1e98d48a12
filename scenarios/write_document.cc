// From a document back to TOML text.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "robot/text_input.h"
#include "scenarios/document.h"

namespace dob {
namespace {

bool is_table(const Node& node) {
  return std::holds_alternative<Table>(node.value);
}

// Written as [[key]] elements rather than in one line.
bool is_array_of_tables(const Node& node) {
  const auto* array = std::get_if<Array>(&node.value);
  return array != nullptr && !array->empty() && std::all_of(array->begin(), array->end(), is_table);
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += fmt::format("\\{}", c);
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string key_text(const std::string& key) {
  return is_bare_key(key) ? key : in_quotes(key);
}

struct ValueWriter {
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(double number) const {
    if (number == 0.0 && std::signbit(number)) return "-0.0";  // -0 would be the whole number 0
    return fmt::format("{}", number);                          // shortest exact form
  }
  std::string operator()(const std::string& text) const { return in_quotes(text); }
  std::string operator()(const Array& array) const {
    std::string result;
    for (const Node& node : array) result += (result.empty() ? "" : ", ") + std::visit(*this, node.value);
    return "[" + result + "]";
  }
  std::string operator()(const Table& table) const {
    std::string result;
    for (const Entry& e : table) {
      result += fmt::format("{}{} = {}", result.empty() ? "" : ", ", key_text(e.key), std::visit(*this, e.node.value));
    }
    return "{" + result + "}";
  }
};

// The table's own values first: what stands below a header belongs to it.
void write_table(std::string& out, const Table& table, const std::string& prefix) {
  for (const Entry& e : table) {
    if (!is_table(e.node) && !is_array_of_tables(e.node))
      out += fmt::format("{} = {}\n", key_text(e.key), std::visit(ValueWriter{}, e.node.value));
  }
  for (const Entry& e : table) {
    const std::string path = prefix + key_text(e.key);
    if (is_table(e.node)) {
      out += fmt::format("\n[{}]\n", path);
      write_table(out, std::get<Table>(e.node.value), path + ".");
    } else if (is_array_of_tables(e.node)) {
      for (const Node& element : std::get<Array>(e.node.value)) {
        out += fmt::format("\n[[{}]]\n", path);
        write_table(out, std::get<Table>(element.value), path + ".");
      }
    }
  }
}

}  // namespace

std::string to_toml(const Node& document) {
  std::string out;
  if (const auto* table = std::get_if<Table>(&document.value)) write_table(out, *table, "");
  return out;
}

std::string describe(const Node& node) {
  if (is_table(node)) return "a table";
  if (is_array_of_tables(node)) return "an array of tables";
  constexpr std::size_t kShown = 200;  // [bytes]
  return printable_line(std::visit(ValueWriter{}, node.value), kShown);
}

}  // namespace dob
