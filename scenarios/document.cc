#include "scenarios/document.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "robot/text_input.h"
#include "scenarios/document_limits.h"

namespace dob {
namespace {

Place place_of(const std::string& source, const toml::source_region& region) {
  return {source, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Node convert(const toml::node& from, const Place& place);

// Throws when there are more than `most` of `what`.
void require_at_most(std::size_t most, std::size_t count, const char* what, const Place& place) {
  if (count > most) throw InputError(place, "", fmt::format("{} {}; at most {} are allowed", count, what, most));
}

Node convert(const toml::table& from, const Place& place) {
  require_at_most(kMostEntries, from.size(), "keys in one table", place);
  Table table;
  for (const auto& [key, value] : from) {
    require_at_most(kLongestKey, key.str().size(), "bytes in one key", place_of(place.source, key.source()));
    table.push_back({std::string(key.str()), convert(value, place_of(place.source, key.source()))});
  }
  const auto position = [](const Entry& e) { return std::tuple(e.node.place.line, e.node.place.column); };
  std::stable_sort(table.begin(), table.end(),
                   [&](const Entry& a, const Entry& b) { return position(a) < position(b); });
  return {std::move(table), place};
}

Node convert(const toml::array& from, const Place& place) {
  require_at_most(kMostElements, from.size(), "elements in one list", place);
  Array array;
  for (const toml::node& value : from) array.push_back(convert(value, place_of(place.source, value.source())));
  return {std::move(array), place};
}

Node convert(const toml::node& from, const Place& place) {
  if (const auto* table = from.as_table()) return convert(*table, place);
  if (const auto* array = from.as_array()) return convert(*array, place);
  if (const auto* flag = from.as_boolean()) return {flag->get(), place};
  if (const auto* text = from.as_string()) {
    require_at_most(kLongestText, text->get().size(), "bytes in one text", place);
    return {text->get(), place};
  }
  if (const auto* number = from.as_floating_point()) return {number->get(), place};
  if (const auto* number = from.as_integer()) return {static_cast<double>(number->get()), place};
  throw InputError(place, "", "a date or a time; allowed: true, false, numbers, strings, arrays, tables");
}

// Everything that came from the command line stands at the option, not at a line.
void set_place(Node& node, const Place& place) {
  node.place = place;
  if (auto* array = std::get_if<Array>(&node.value)) {
    for (Node& element : *array) set_place(element, place);
  }
  if (auto* table = std::get_if<Table>(&node.value)) {
    for (Entry& e : *table) set_place(e.node, place);
  }
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::optional<std::size_t> parse_index(std::string_view text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

// Are the keys those of an array's elements: 0, 1, ...?
bool names_elements(const Table& table) {
  return !table.empty() && std::all_of(table.begin(), table.end(), [](const Entry& e) { return parse_index(e.key); });
}

Node& child(Node& parent, std::string_view key, const std::string& path, const Place& place) {
  if (auto* table = std::get_if<Table>(&parent.value)) return entry(*table, key, place);
  auto* array = std::get_if<Array>(&parent.value);
  if (array == nullptr) {
    throw InputError(place, path, fmt::format("nothing is called '{}' below {}", key, describe(parent)));
  }
  const auto index = parse_index(key);
  if (!index || *index >= array->size()) {
    throw InputError(place, path, fmt::format("no element '{}'; there are {}, counted from 0", key, array->size()));
  }
  return (*array)[*index];
}

// `path` of the two nodes, with a dot behind it; for messages.
void merge_at(Node& base, const Node& overlay, const std::string& path) {
  auto* below = std::get_if<Table>(&base.value);
  const auto* above = std::get_if<Table>(&overlay.value);
  if (above != nullptr && std::holds_alternative<Array>(base.value) && names_elements(*above)) {
    for (const Entry& e : *above) merge_at(child(base, e.key, path + e.key, e.node.place), e.node, path + e.key + ".");
    return;
  }
  if (below == nullptr || above == nullptr) {
    base = overlay;
    return;
  }
  base.place = overlay.place;
  for (const Entry& e : *above) merge_at(entry(*below, e.key, e.node.place), e.node, path + e.key + ".");
}

}  // namespace

const Node* Node::find(std::string_view key) const {
  const auto* table = std::get_if<Table>(&value);
  if (table == nullptr) return nullptr;
  const auto it = std::find_if(table->begin(), table->end(), [&](const Entry& e) { return e.key == key; });
  return it == table->end() ? nullptr : &it->node;
}

Node* Node::find(std::string_view key) {
  return const_cast<Node*>(std::as_const(*this).find(key));  // NOLINT: the node itself is not const
}

Node parse_file(const std::filesystem::path& file) {
  const std::string source = file.string();
  try {
    return parse_text(read_text_file(file, kMostBytes), source);
  } catch (const TextFileError& error) {
    throw InputError({source}, "", fmt::format("{}; a TOML file is needed", error.what()));
  }
}

Node parse_text(std::string_view text, const std::string& source) {
  try {
    check_nesting(text, source);
    return convert(toml::parse(text, std::string_view(source)), {source, 1, 1});
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(source, error.source()), "", std::string(error.description()));
  }
}

bool is_bare_key(std::string_view text) {
  const auto allowed = [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), allowed);
}

Node parse_value(const std::string& key, const std::string& text, const Place& place) {
  const auto refuse = [&](std::string_view why) {
    constexpr std::size_t kShown = 200;  // [bytes]
    throw InputError(place, key, fmt::format("{}; {}; allowed: a TOML value", printable_line(text, kShown), why));
  };
  try {
    check_nesting(text, place.source);
  } catch (const InputError&) {
    refuse(fmt::format("nested deeper than {} levels or a key of more than {} parts", kDeepestNesting, kMostKeyParts));
  }
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) {
      Node node = convert(*table.get("value"), place);
      set_place(node, place);
      return node;
    }
  } catch (const toml::parse_error& error) {
    if (is_bare_key(text) && is_letter(text.front())) return {text, place};
    refuse(error.description());
  }
  throw InputError(place, key, "more than one value; allowed: one TOML value");
}

const Table& table_of(const Node& node, const std::string& key) {
  if (const auto* table = std::get_if<Table>(&node.value)) return *table;
  throw InputError(node.place, key, fmt::format("{}; allowed: a table", describe(node)));
}

Node& entry(Table& table, std::string_view key, const Place& place) {
  const auto it = std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.key == key; });
  if (it != table.end()) return it->node;
  return table.emplace_back(Entry{std::string(key), {Table{}, place}}).node;
}

void erase(Node& table, std::string_view key) {
  if (auto* entries = std::get_if<Table>(&table.value))
    std::erase_if(*entries, [&](const Entry& e) { return e.key == key; });
}

void merge(Node& base, const Node& overlay) {
  merge_at(base, overlay, "");
}

void set(Node& document, const std::string& path, const Node& value) {
  check_path(path, value.place);
  Node* node = &document;
  std::string_view rest = path;
  while (true) {
    const std::size_t dot = rest.find('.');
    const std::string_view key = rest.substr(0, dot);
    node = &child(*node, key, path, value.place);
    if (dot == std::string_view::npos) break;
    rest.remove_prefix(dot + 1);
  }
  *node = value;
}

}  // namespace dob
