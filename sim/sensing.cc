#include "sim/sensing.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/random_stream.h"
#include "sim/require.h"

namespace dob {
namespace {

constexpr std::uint32_t kSensingStreams = 0x5e45u;  // sets these streams apart from others of the same seed
enum Stream : std::uint32_t { kBaseVelocity, kTorqueSigns };

Vec12 draw_signs(std::uint64_t seed) {
  std::mt19937_64 random = random_stream(seed, kSensingStreams, kTorqueSigns);
  Vec12 signs;
  for (double& sign : signs) sign = (random() >> 63U) == 0 ? 1.0 : -1.0;
  return signs;
}

}  // namespace

bool SensingErrors::of_state() const noexcept {
  return base_velocity_noise != 0.0 || base_angular_velocity_noise != 0.0 || delay_ticks != 0;
}

void SensingErrors::validate() const {
  const Require require{"sensing"};
  require.not_negative("base_velocity_noise", base_velocity_noise);
  require.not_negative("base_angular_velocity_noise", base_angular_velocity_noise);
  require.not_negative("torque_bias", torque_bias);
  require.finite("foot_force_bias", foot_force_bias);
  require(delay_ticks >= 0 && delay_ticks <= kMaxDelayTicks, "delay_ticks", delay_ticks,
          fmt::format("from 0 to {}", kMaxDelayTicks));
}

Sensing::Sensing(const SensingErrors& errors, std::uint64_t seed)
    : errors_(errors),
      noise_(random_stream(seed, kSensingStreams, kBaseVelocity)),
      torque_bias_(errors.torque_bias * draw_signs(seed)) {
  errors_.validate();
}

void Sensing::reset(const RobotState& initial) noexcept {
  tick_ = 0;
  memory_.fill({0, initial, {}});
}

const Measurement& Sensing::measure(const RobotState& state, const SensorReading& reading,
                                    const PerLeg<bool>& foot_contact) noexcept {
  constexpr long kSlots = kMaxDelayTicks + 1;
  ++tick_;
  Measurement& now = memory_[static_cast<std::size_t>(tick_ % kSlots)];
  now = {tick_, state, reading};
  if (errors_.base_velocity_noise != 0.0 || errors_.base_angular_velocity_noise != 0.0) {
    for (double& v : now.state.v_WB) v += errors_.base_velocity_noise * noise_.next();
    for (double& w : now.state.omega_WB) w += errors_.base_angular_velocity_noise * noise_.next();
  }
  now.reading.joint_torque += torque_bias_;
  for (std::size_t l = 0; l < kLegs; ++l) {
    if (foot_contact[l]) now.reading.foot_force_W[l].z() += errors_.foot_force_bias;
  }
  const long told = std::max(tick_ - errors_.delay_ticks, 0L);
  return memory_[static_cast<std::size_t>(told % kSlots)];
}

}  // namespace dob
