#include "sim/sensors.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace dob {
namespace {

void require_fraction(std::string_view field, double value) {
  if (!std::isfinite(value) || value < 0.0) {
    throw std::invalid_argument(fmt::format("sensor noise: {} = {}, must be finite and >= 0", field, value));
  }
}

// Uniform in (0, 1): the upper 53 bits, moved off zero by half a step so that its logarithm exists.
double uniform(std::mt19937_64& engine) noexcept {
  return (static_cast<double>(engine() >> 11U) + 0.5) * 0x1p-53;
}

}  // namespace

void SensorNoise::validate() const {
  require_fraction("torque_relative", torque_relative);
  require_fraction("foot_force_relative", foot_force_relative);
}

Sensors::Sensors(const SensorNoise& noise, std::uint64_t seed) : noise_(noise), engine_(seed) {
  noise_.validate();
}

double Sensors::normal() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(uniform(engine_)));
  const double angle = 2.0 * std::numbers::pi * uniform(engine_);
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

SensorReading Sensors::measure(const StepResult& step) noexcept {
  SensorReading reading{step.joint_torque, step.foot_force_W};
  if (noise_.torque_relative == 0.0 && noise_.foot_force_relative == 0.0) return reading;  // most trials: draw nothing
  for (double& torque : reading.joint_torque) torque *= 1.0 + noise_.torque_relative * normal();
  for (Vec3& force : reading.foot_force_W) {
    for (double& component : force) component *= 1.0 + noise_.foot_force_relative * normal();
  }
  return reading;
}

}  // namespace dob
