#include "sim/normal_deviates.h"

#include <cmath>
#include <numbers>

namespace dob {
namespace {

// Uniform in (0, 1): the upper 53 bits, moved off zero by half a step so that its logarithm exists.
double open_uniform(std::mt19937_64& engine) noexcept {
  return (static_cast<double>(engine() >> 11U) + 0.5) * 0x1p-53;
}

}  // namespace

double NormalDeviates::next() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(open_uniform(engine_)));
  const double angle = 2.0 * std::numbers::pi * open_uniform(engine_);
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace dob
