#include "results/trace_encoding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/extremes.h"

namespace dob {
namespace {

constexpr double kLargest = 32767.0;

struct Range {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
};

Range range_of(const std::vector<float>& column) {
  Range range;
  for (const float x : column) {
    if (!std::isfinite(x)) continue;
    range.min = std::min(range.min, static_cast<double>(x));
    range.max = std::max(range.max, static_cast<double>(x));
  }
  return range;
}

// Offset and scale for a range, without numbers.
QuantisedColumn steps_for(const Range& range, double resolution) {
  if (std::max(-range.min, range.max) <= kLargest * resolution) return {0.0, resolution, {}};
  const double middle = 0.5 * (range.min + range.max);
  return {middle, std::max(resolution, (range.max - range.min) / (2.0 * kLargest)), {}};
}

}  // namespace

QuantisedColumn quantise(const std::vector<float>& column, double resolution) {
  QuantisedColumn out = steps_for(range_of(column), resolution);
  out.numbers.reserve(column.size());
  for (const float x : column) {
    const double steps = std::round((static_cast<double>(x) - out.offset) / out.scale);
    out.numbers.push_back(std::isfinite(x) ? static_cast<std::int16_t>(std::clamp(steps, -kLargest, kLargest))
                                           : kDoesNotApply);
  }
  return out;
}

std::vector<float> min_max_decimated(const std::vector<float>& column, std::size_t samples) {
  std::vector<float> points;
  points.reserve(2 * (column.size() / samples + 1));
  for (std::size_t begin = 0; begin < column.size(); begin += samples) {
    const std::size_t end = std::min(begin + samples, column.size());
    const auto [first, second] = extremes(column, begin, end);
    points.push_back(column[first]);
    points.push_back(column[second]);
  }
  return points;
}

std::string delta_coded(const std::vector<std::int16_t>& numbers) {
  std::string bytes;
  bytes.reserve(2 * numbers.size());
  std::uint16_t last = 0;
  for (const std::int16_t number : numbers) {
    const auto now = static_cast<std::uint16_t>(number);
    const auto difference = static_cast<std::uint16_t>(now - last);
    bytes += static_cast<char>(difference & 0xFFU);
    bytes += static_cast<char>(difference >> 8U);
    last = now;
  }
  return bytes;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * (bytes.size() / 3 + 1));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      group = group << 8U | (b < there ? static_cast<unsigned char>(bytes[i + b]) : 0U);
    }
    for (std::size_t d = 0; d < 4; ++d) text += d <= there ? kDigits[group >> (18U - 6U * d) & 63U] : '=';
  }
  return text;
}

}  // namespace dob
