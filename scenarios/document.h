// A TOML document as a plain value: a tree that can be copied and merged, and in which every node still knows
// where it was written. Only document.cc knows the TOML library.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scenarios/input_error.h"

namespace dob {

struct Entry;
struct Node;
using Array = std::vector<Node>;
using Table = std::vector<Entry>;  // in the order of the file

// Integers are doubles here: nothing in the schema is counted.
struct Node {
  std::variant<bool, double, std::string, Array, Table> value;
  Place place;  // of the key for what stands in a table, of the value for what stands in an array

  const Node* find(std::string_view key) const;  // nullptr: no such key, or not a table
  Node* find(std::string_view key);
};

struct Entry {
  std::string key;
  Node node;
};

// Throws InputError: a file that cannot be read, TOML that cannot be parsed (line and column), dates and times.
Node parse_file(const std::filesystem::path& file);

// The same of a text; `source` is what messages call it.
Node parse_text(std::string_view text, const std::string& source);

// Letters, digits, _ and - only: a key that needs no quotes, and what we allow as a name.
bool is_bare_key(std::string_view text);

// The value of `--set key=text`. Text that is a bare word (LF, spline) is a string without quotes, too. Every
// node gets the place. Throws InputError.
Node parse_value(const std::string& key, const std::string& text, const Place& place);

// The entries of a table. Throws InputError with the key when the node is not one.
const Table& table_of(const Node& node, const std::string& key);

// The entry of a table, made if it is not there.
Node& entry(Table& table, std::string_view key, const Place& place);

// Removes the entry of a table, if there is one.
void erase(Node& table, std::string_view key);

// Puts `overlay` over `base`: tables are merged key by key, everything else, arrays included, is replaced. A table
// whose keys are numbers is merged into the elements of an array that they count, from 0; throws InputError past its
// end.
void merge(Node& base, const Node& overlay);

// Replaces the node at a dotted path (`disturbance.0.amplitude_N`), making tables on the way. Throws InputError
// when the path runs into a value or past the end of an array.
void set(Node& document, const std::string& path, const Node& value);

// TOML text that parses to the same document. Numbers are exact.
std::string to_toml(const Node& document);

// One value as it would stand in a file, for messages; a table is only called one.
std::string describe(const Node& node);

}  // namespace dob
