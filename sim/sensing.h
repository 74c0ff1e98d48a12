// What the robot is told about its state, torques and contact forces, late and with errors, and remembers.
#pragma once

#include <array>
#include <cstdint>

#include "robot/types.h"
#include "sim/normal_deviates.h"
#include "sim/sensors.h"

namespace dob {

inline constexpr int kMaxDelayTicks = 10;

// Joint angles and rates, position and attitude of the trunk are told as they are, save for the delay.
struct SensingErrors {
  double base_velocity_noise = 0.0;          // [m/s] standard deviation per component and tick, white
  double base_angular_velocity_noise = 0.0;  // [rad/s] likewise
  double torque_bias = 0.0;                  // [N m] on every joint, constant; the seed draws each joint's sign
  double foot_force_bias = 0.0;  // [N] on the vertical force of every foot that touches, constant: a sensor that is
                                 // tared while the foot is in the air, and wrong under load
  int delay_ticks = 0;           // of everything, 0 to kMaxDelayTicks

  bool of_state() const noexcept;  // does the state that is told differ from the true one?

  // Throws std::invalid_argument naming the field, the value and what is allowed.
  void validate() const;
};

// What is known of the tick `tick`: the state at its time, torques and forces over the step that ended there. Before
// the first step there were none, and these are zero.
struct Measurement {
  long tick = 0;
  RobotState state;
  SensorReading reading;
};

// After step k (from 1) the robot is told what was measured at tick k - d; until k = d that is the start, tick 0, which
// is known exactly. So an observer's interval at tick k is [(k - 1 - d) dt, (k - d) dt], and the errors of its two ends
// are those of two ticks. Streams: noise and signs have their own of each seed, apart from all others, and the noise
// of a tick depends neither on the signals nor on the other errors. Allocates nothing after construction.
class Sensing {
 public:
  Sensing(const SensingErrors& errors, std::uint64_t seed);

  // To the start of a trial; `initial` is the state that is told until the delay has passed.
  void reset(const RobotState& initial) noexcept;

  // After a step: the true state at its end, what the sensors of torque and force say about it and which feet touched.
  // Returns what the robot is told now; it stays valid until the next call.
  const Measurement& measure(const RobotState& state, const SensorReading& reading,
                             const PerLeg<bool>& foot_contact) noexcept;

 private:
  SensingErrors errors_;
  NormalDeviates noise_;
  Vec12 torque_bias_;  // [N m]
  long tick_ = 0;
  std::array<Measurement, kMaxDelayTicks + 1> memory_;  // of tick k in slot k modulo its size
};

}  // namespace dob
