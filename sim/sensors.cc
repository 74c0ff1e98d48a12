#include "sim/sensors.h"

#include "sim/random_stream.h"
#include "sim/require.h"

namespace dob {
namespace {

constexpr std::uint32_t kSensorStream = 0x5e50u;  // sets this stream apart from others of the same seed

}  // namespace

void SensorNoise::validate() const {
  const Require require{"sensor noise"};
  require.not_negative("torque_relative", torque_relative);
  require.not_negative("foot_force_relative", foot_force_relative);
}

Sensors::Sensors(const SensorNoise& noise, std::uint64_t seed)
    : noise_(noise), normal_(random_stream(seed, kSensorStream)) {
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
