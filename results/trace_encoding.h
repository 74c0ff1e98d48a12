// Time series in the few bytes that a page has room for: whole numbers of 16 bits, of which differences are stored.
// Private to results/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dob {

inline constexpr std::int16_t kDoesNotApply = -32768;

// value = offset + scale * number, to half a scale.
struct QuantisedColumn {
  double offset = 0.0;
  double scale = 1.0;
  std::vector<std::int16_t> numbers;  // kDoesNotApply for what is not finite
};

// In steps of `resolution` > 0, or of the column's range over 65534 where that is coarser. The offset is 0 while the
// values allow it, so that zero stays zero.
QuantisedColumn quantise(const std::vector<float>& column, double resolution);

// Two points for each `samples` > 0 of the column (the last may be fewer): the smallest and the largest of them, in
// their order of time, so that no peak is lost. Both are NaN where none of them applies.
std::vector<float> min_max_decimated(const std::vector<float>& column, std::size_t samples);

// The first number, then differences modulo 2^16, little-endian.
std::string delta_coded(const std::vector<std::int16_t>& numbers);

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace dob
