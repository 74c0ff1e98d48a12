#pragma once

#include <cmath>
#include <optional>

namespace dob {

// Mean of what was added; nullopt if nothing was.
class RunningMean {
 public:
  void add(double x) noexcept {
    sum_ += x;
    ++count_;
  }
  std::optional<double> value() const noexcept {
    return count_ == 0 ? std::nullopt : std::optional(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0.0;
  long count_ = 0;
};

inline std::optional<double> root(std::optional<double> mean_square) noexcept {
  return mean_square ? std::optional(std::sqrt(*mean_square)) : std::nullopt;
}

// A figure that is not finite is none.
inline std::optional<double> finite(std::optional<double> x) noexcept {
  return x && std::isfinite(*x) ? x : std::nullopt;
}

}  // namespace dob
