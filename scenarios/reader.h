// Strict reading of one table of a document: every key is asked for by name, with its type and its range; what
// nobody asks for is refused. All functions throw InputError with the place, the key, the value and what is allowed.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/types.h"
#include "scenarios/document.h"

namespace dob {

// Allowed numbers: finite, from `min` to `max`, the ends included unless said otherwise.
struct Range {
  double min;
  double max;
  bool without_min = false;
  bool without_max = false;
};
constexpr Range between(double min, double max) {
  return {.min = min, .max = max};
}
constexpr Range above(double min, double max) {
  return {.min = min, .max = max, .without_min = true};
}
constexpr Range below(double min, double max) {
  return {.min = min, .max = max, .without_max = true};
}

// What keys in several files may be: enough for any legged robot, too little for a wrong unit.
inline constexpr double kLongestTime = 1e5;             // [s]
inline constexpr Range kFriction = between(0.0, 10.0);  // [-]

// One of the words that a key may have, and what it means.
template <typename T>
struct Choice {
  std::string_view word;
  T meaning;
};

class Reader {
 public:
  // Reads the node, which must be a table, with `read(Reader&)`. `path` is what messages put before the keys.
  template <typename Read>
  static void read(const Node& node, const std::string& path, Read read) {
    Reader reader(node, path);
    read(reader);
    reader.finish();
  }

  // Asking whether a key is there makes it a known one.
  bool has(std::string_view key) { return find(key, false) != nullptr; }
  const Place& place(std::string_view key) const;  // of the table when the key is missing

  // Without a fallback the key has to be there. A missing key is reported when the whole table has been read,
  // so that a misspelt one is called unknown rather than the right one missing; until then its value is a stand-in.
  double number(std::string_view key, Range range, std::optional<double> fallback = std::nullopt);
  int integer(std::string_view key, int min, int max);
  std::vector<double> numbers(std::string_view key, Range range);  // at least one
  Vec3 vector(std::string_view key, Range range);
  Vec3 vector_or_number(std::string_view key, Range range);  // one number stands for three equal ones
  Vec3 direction(std::string_view key);                      // normalised; zero is refused
  bool flag(std::string_view key, std::optional<bool> fallback = std::nullopt);
  std::string text(std::string_view key);
  std::vector<std::string> texts(std::string_view key);  // at least one; a text stands for a list of itself
  template <typename T, std::size_t N>
  T choice(std::string_view key, const std::array<Choice<T>, N>& choices, std::optional<T> fallback = std::nullopt);

  // The table under the key.
  template <typename Read>
  void table(std::string_view key, Read read_table) {
    if (const Node* node = find(key)) read(*node, join(key), read_table);
  }

  // Every element of the array of tables under the key.
  template <typename Read>
  void each(std::string_view key, Read read_element) {
    const Array* elements = array(key);
    for (std::size_t i = 0; elements != nullptr && i < elements->size(); ++i) {
      read((*elements)[i], join(key) + "." + std::to_string(i), read_element);
    }
  }

  // Refuses the value of a key that is there.
  [[noreturn]] void refuse(std::string_view key, const std::string& allowed) const;

 private:
  Reader(const Node& node, std::string path);
  const Node* find(std::string_view key, bool required = true);
  const Array* array(std::string_view key);
  std::string join(std::string_view key) const;
  void finish() const;

  const Node& table_;
  std::string path_;
  std::vector<std::string> known_;
  std::string missing_;  // the first key that had to be there
};

template <typename T, std::size_t N>
T Reader::choice(std::string_view key, const std::array<Choice<T>, N>& choices, std::optional<T> fallback) {
  const Node* node = find(key, !fallback);
  if (node == nullptr) return fallback.value_or(choices.front().meaning);
  const auto* text = std::get_if<std::string>(&node->value);
  std::string words;
  for (const Choice<T>& c : choices) {
    if (text != nullptr && c.word == *text) return c.meaning;
    words += (words.empty() ? "" : ", ") + std::string(c.word);
  }
  refuse(key, "one of " + words);
}

}  // namespace dob
