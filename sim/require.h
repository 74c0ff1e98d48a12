// Refuses what an option must not be. Private to sim/.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace dob {

// Throws std::invalid_argument, like "payload: mass = -1, must be finite and > 0" of Require{"payload"}.
struct Require {
  std::string_view options;

  void operator()(bool allowed, std::string_view field, double value, std::string_view expected) const {
    if (allowed) return;
    throw std::invalid_argument(fmt::format("{}: {} = {}, must be {}", options, field, value, expected));
  }
  void finite(std::string_view field, double value) const { (*this)(std::isfinite(value), field, value, "finite"); }
  void not_negative(std::string_view field, double value) const {
    (*this)(std::isfinite(value) && value >= 0.0, field, value, "finite and >= 0");
  }
  void positive(std::string_view field, double value) const {
    (*this)(std::isfinite(value) && value > 0.0, field, value, "finite and > 0");
  }
};

}  // namespace dob
