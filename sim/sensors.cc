#include "sim/sensors.h"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "sim/random_stream.h"

namespace dob {
namespace {

constexpr std::uint32_t kStream = 0x5e50u;  // sets this stream apart from others of the same seed

void require_fraction(std::string_view field, double value) {
  if (!std::isfinite(value) || value < 0.0) {
    throw std::invalid_argument(fmt::format("sensor noise: {} = {}, must be finite and >= 0", field, value));
  }
}

}  // namespace

void SensorNoise::validate() const {
  require_fraction("torque_relative", torque_relative);
  require_fraction("foot_force_relative", foot_force_relative);
}

Sensors::Sensors(const SensorNoise& noise, std::uint64_t seed) : noise_(noise), normal_(random_stream(seed, kStream)) {
  noise_.validate();
}

SensorReading Sensors::measure(const StepResult& step) noexcept {
  SensorReading reading{step.joint_torque, step.foot_force_W};
  if (noise_.torque_relative == 0.0 && noise_.foot_force_relative == 0.0) return reading;  // most trials: draw nothing
  for (double& torque : reading.joint_torque) torque *= 1.0 + noise_.torque_relative * normal_.next();
  for (Vec3& force : reading.foot_force_W) {
    for (double& component : force) component *= 1.0 + noise_.foot_force_relative * normal_.next();
  }
  return reading;
}

}  // namespace dob
