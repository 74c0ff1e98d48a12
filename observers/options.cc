#include "observers/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace dob {
namespace {

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> parse_list(std::string_view text) {
  std::vector<double> list;
  while (true) {
    const std::size_t semicolon = text.find(';');
    const auto number = parse_number(text.substr(0, semicolon));
    if (!number) return std::nullopt;
    list.push_back(*number);
    if (semicolon == std::string_view::npos) return list;
    text.remove_prefix(semicolon + 1);
  }
}

bool within(double value, const NumberRange& range) {
  return std::isfinite(value) && value > range.above && value >= range.min && value <= range.max;
}

std::string describe(const NumberRange& range) {
  if (!std::isinf(range.min)) return fmt::format("from {} to {}", range.min, range.max);
  const bool below = range.max == NumberRange{}.max;
  if (std::isinf(range.above)) return below ? "finite" : fmt::format("at most {}", range.max);
  return below ? fmt::format("above {}", range.above) : fmt::format("in ({}, {}]", range.above, range.max);
}

struct Formatter {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return fmt::format("\"{}\"", value); }
  std::string operator()(const std::vector<double>& value) const { return fmt::format("{}", fmt::join(value, ";")); }
};

}  // namespace

OptionValue parse_option_value(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  if (const auto list = parse_list(text)) {
    if (list->size() == 1) return list->front();
    return *list;
  }
  return std::string(text);
}

std::string format_option_value(const OptionValue& value) {
  return std::visit(Formatter{}, value);
}

OptionError::OptionError(std::string_view observer, std::string_view key, const OptionValue& value,
                         std::string_view allowed)
    : std::runtime_error(fmt::format("observer {}: option {} = {} is refused: {}", observer, key,
                                     format_option_value(value), allowed)) {}

void check_tick(std::string_view observer, double dt) {
  if (!std::isfinite(dt) || dt <= 0.0) throw OptionError(observer, "dt", dt, "allowed is a finite tick > 0 s");
}

const OptionValue* OptionReader::find(const std::string& key) {
  known_.insert(key);
  const auto it = options_.find(key);
  return it == options_.end() ? nullptr : &it->second;
}

bool OptionReader::flag(const std::string& key, bool fallback) {
  const OptionValue* value = find(key);
  if (value == nullptr) return fallback;
  if (const bool* flag = std::get_if<bool>(value)) return *flag;
  throw OptionError(observer_, key, *value, "allowed is true or false");
}

double OptionReader::number(const std::string& key, double fallback, NumberRange range) {
  const OptionValue* value = find(key);
  if (value == nullptr) return fallback;
  const double* number = std::get_if<double>(value);
  if (number != nullptr && within(*number, range)) return *number;
  throw OptionError(observer_, key, *value, fmt::format("allowed is a number {}", describe(range)));
}

int OptionReader::integer(const std::string& key, int fallback, int min, int max) {
  const OptionValue* value = find(key);
  if (value == nullptr) return fallback;
  const double* number = std::get_if<double>(value);
  if (number != nullptr && *number >= min && *number <= max && *number == std::floor(*number)) {
    return static_cast<int>(*number);
  }
  throw OptionError(observer_, key, *value, fmt::format("allowed is a whole number from {} to {}", min, max));
}

std::string OptionReader::choice(const std::string& key, std::initializer_list<std::string_view> allowed) {
  const OptionValue* value = find(key);
  if (value == nullptr) return std::string(*allowed.begin());
  const std::string* text = std::get_if<std::string>(value);
  if (text != nullptr && std::find(allowed.begin(), allowed.end(), *text) != allowed.end()) return *text;
  throw OptionError(observer_, key, *value, fmt::format("allowed is one of {}", fmt::join(allowed, ", ")));
}

std::vector<double> OptionReader::list(const std::string& key, std::vector<double> fallback, NumberRange range,
                                       int max_size) {
  const OptionValue* value = find(key);
  if (value == nullptr) return fallback;
  std::vector<double> list;
  if (const auto* several = std::get_if<std::vector<double>>(value)) list = *several;
  if (const double* one = std::get_if<double>(value)) list = {*one};
  const bool good = !list.empty() && list.size() <= static_cast<std::size_t>(max_size) &&
                    std::all_of(list.begin(), list.end(), [&](double x) { return within(x, range); });
  if (good) return list;
  throw OptionError(observer_, key, *value,
                    fmt::format("allowed are 1 to {} numbers, each {}", max_size, describe(range)));
}

void OptionReader::refuse_unknown() const {
  for (const auto& [key, value] : options_) {
    if (known_.contains(key)) continue;
    const std::string keys = known_.empty() ? "none" : fmt::format("{}", fmt::join(known_, ", "));
    throw OptionError(observer_, key, value, fmt::format("no such option; there are: {}", keys));
  }
}

}  // namespace dob
