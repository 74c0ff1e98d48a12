#include "scenarios/reader.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "robot/text_input.h"

namespace dob {
namespace {

std::string words(Range range) {
  return fmt::format("{} {} {} {}", range.without_min ? "above" : "from", range.min,
                     range.without_max ? "to below" : "to", range.max);
}

std::optional<double> number_in(const Node& node, Range range) {
  const auto* number = std::get_if<double>(&node.value);
  if (number == nullptr || !std::isfinite(*number)) return std::nullopt;
  if (*number < range.min || (range.without_min && *number == range.min)) return std::nullopt;
  if (*number > range.max || (range.without_max && *number == range.max)) return std::nullopt;
  return *number;
}

std::optional<Vec3> vector_in(const Node& node, Range range) {
  const auto* array = std::get_if<Array>(&node.value);
  if (array == nullptr || array->size() != 3) return std::nullopt;
  Vec3 vector;
  for (int i = 0; i < 3; ++i) {
    const auto number = number_in((*array)[static_cast<std::size_t>(i)], range);
    if (!number) return std::nullopt;
    vector[i] = *number;
  }
  return vector;
}

constexpr const char* kMissing = "missing; the key is needed here";
constexpr const char* kPlainWords = "one line of printable text";

bool is_plain(const std::string& text) {
  return printable_line(text, 4 * text.size() + 16) == text;
}

// Levenshtein's distance: the fewest characters to insert, delete or change.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// The part before the unit: `amplitude` of `amplitude_N`.
std::string_view stem(std::string_view key) {
  return key.substr(0, key.rfind('_'));
}

// A key with another unit, or none, is nearer than the letters say.
int distance(const std::string& key, const std::string& known) {
  if (known.starts_with(key + '_')) return 0;
  constexpr int kOtherUnit = 2;  // letters
  return static_cast<int>(edit_distance(key, known)) - (stem(key) == stem(known) ? kOtherUnit : 0);
}

std::string suggestion(const std::string& key, const std::vector<std::string>& known) {
  const int typing_errors = std::max(2, static_cast<int>(key.size()) / 3);
  const auto nearest = std::min_element(
      known.begin(), known.end(), [&](const auto& a, const auto& b) { return distance(key, a) < distance(key, b); });
  if (nearest != known.end() && distance(key, *nearest) <= typing_errors)
    return fmt::format("did you mean '{}'?", *nearest);
  return known.empty() ? "none is allowed here" : fmt::format("allowed: {}", fmt::join(known, ", "));
}

}  // namespace

Reader::Reader(const Node& node, std::string path) : table_(node), path_(std::move(path)) {
  table_of(table_, path_);
}

std::string Reader::join(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const Node* Reader::find(std::string_view key, bool required) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  const Node* node = table_.find(key);
  if (node == nullptr && required && missing_.empty()) missing_ = key;
  return node;
}

const Place& Reader::place(std::string_view key) const {
  const Node* node = table_.find(key);
  return node == nullptr ? table_.place : node->place;
}

void Reader::refuse(std::string_view key, const std::string& allowed) const {
  const Node* node = table_.find(key);
  if (node == nullptr) throw InputError(table_.place, join(key), kMissing);
  throw InputError(node->place, join(key), fmt::format("{}; allowed: {}", describe(*node), allowed));
}

void Reader::finish() const {
  for (const Entry& e : std::get<Table>(table_.value)) {
    if (std::find(known_.begin(), known_.end(), e.key) != known_.end()) continue;
    throw InputError(e.node.place, join(e.key), fmt::format("unknown key '{}'; {}", e.key, suggestion(e.key, known_)));
  }
  if (!missing_.empty()) throw InputError(table_.place, join(missing_), kMissing);
}

double Reader::number(std::string_view key, Range range, std::optional<double> fallback) {
  const Node* node = find(key, !fallback);
  if (node == nullptr) return fallback.value_or(range.max);
  if (const auto number = number_in(*node, range)) return *number;
  refuse(key, "a number " + words(range));
}

int Reader::integer(std::string_view key, int min, int max) {
  const Node* node = find(key);
  if (node == nullptr) return min;
  const auto number = number_in(*node, between(min, max));
  if (number && *number == std::floor(*number)) return static_cast<int>(*number);
  refuse(key, fmt::format("a whole number from {} to {}", min, max));
}

std::vector<double> Reader::numbers(std::string_view key, Range range) {
  const Node* node = find(key);
  if (node == nullptr) return {};
  std::vector<double> numbers;
  if (const auto* array = std::get_if<Array>(&node->value)) {
    for (const Node& element : *array) {
      if (const auto number = number_in(element, range)) numbers.push_back(*number);
    }
    if (!numbers.empty() && numbers.size() == array->size()) return numbers;
  }
  refuse(key, "a list of numbers, each " + words(range));
}

Vec3 Reader::vector(std::string_view key, Range range) {
  const Node* node = find(key);
  if (node == nullptr) return Vec3::UnitX();
  if (const auto vector = vector_in(*node, range)) return *vector;
  refuse(key, "three numbers, each " + words(range));
}

Vec3 Reader::vector_or_number(std::string_view key, Range range) {
  const Node* node = find(key);
  if (node == nullptr) return Vec3::UnitX();
  if (const auto number = number_in(*node, range)) return Vec3::Constant(*number);
  if (const auto vector = vector_in(*node, range)) return *vector;
  refuse(key, fmt::format("a number {0}, or three for x, y, z", words(range)));
}

Vec3 Reader::direction(std::string_view key) {
  constexpr double kLargest = 1e6;    // keeps the norm finite
  constexpr double kSmallest = 1e-6;  // of the norm
  const Vec3 vector = this->vector(key, between(-kLargest, kLargest));
  if (vector.norm() < kSmallest) refuse(key, fmt::format("a vector with a norm of at least {}", kSmallest));
  return vector.normalized();
}

bool Reader::flag(std::string_view key, std::optional<bool> fallback) {
  const Node* node = find(key, !fallback);
  if (node == nullptr) return fallback.value_or(false);
  if (const auto* flag = std::get_if<bool>(&node->value)) return *flag;
  refuse(key, "true or false");
}

std::string Reader::text(std::string_view key) {
  const Node* node = find(key);
  if (node == nullptr) return {};
  const auto* text = std::get_if<std::string>(&node->value);
  if (text == nullptr) refuse(key, "text in quotes");
  if (!is_plain(*text)) refuse(key, kPlainWords);
  return *text;
}

std::vector<std::string> Reader::texts(std::string_view key) {
  const Node* node = find(key);
  if (node == nullptr) return {};
  if (std::holds_alternative<std::string>(node->value)) return {text(key)};
  std::vector<std::string> texts;
  if (const auto* array = std::get_if<Array>(&node->value)) {
    for (const Node& element : *array) {
      const auto* text = std::get_if<std::string>(&element.value);
      if (text != nullptr && !is_plain(*text)) refuse(key, fmt::format("a list of texts, each {}", kPlainWords));
      if (text != nullptr) texts.push_back(*text);
    }
    if (!texts.empty() && texts.size() == array->size()) return texts;
  }
  refuse(key, "a text, or a list of texts");
}

const Array* Reader::array(std::string_view key) {
  const Node* node = find(key);
  if (node == nullptr) return nullptr;
  if (const auto* array = std::get_if<Array>(&node->value)) return array;
  refuse(key, fmt::format("an array of tables, [[{}]]", key));
}

}  // namespace dob
