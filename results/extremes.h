// What decimation keeps of a stretch of samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace dob {

// Where the smallest and the largest finite value of [begin, end) stand, the earlier place first: no peak is lost that
// way. Both are `begin` if no value is finite. Needs begin < end.
template <typename Number>
std::pair<std::size_t, std::size_t> extremes(const std::vector<Number>& values, std::size_t begin, std::size_t end) {
  std::size_t smallest = begin, largest = begin;  // what is not finite at `begin` gives way to the first value that is
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::isfinite(values[i])) continue;
    if (!std::isfinite(values[smallest]) || values[i] < values[smallest]) smallest = i;
    if (!std::isfinite(values[largest]) || values[i] > values[largest]) largest = i;
  }
  return std::minmax({smallest, largest});
}

}  // namespace dob
