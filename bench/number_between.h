// The range of a number on the command line.
#pragma once

#include <charconv>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace dob {

// As CLI::Range, for which `nan` is within any range.
inline CLI::Validator number_between(double min, double max) {
  const std::string range = fmt::format("from {} to {}", min, max);
  const auto check = [min, max, range](const std::string& text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool good = error == std::errc{} && end == text.data() + text.size() && number >= min && number <= max;
    return good ? std::string() : fmt::format("{}; allowed: a number {}", text, range);
  };
  return {check, range};
}

}  // namespace dob
