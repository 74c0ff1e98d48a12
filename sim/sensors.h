// What the robot's torque and foot-force sensors say about a step.
#pragma once

#include <cstdint>

#include "robot/types.h"
#include "sim/normal_deviates.h"
#include "sim/simulator.h"

namespace dob {

// Standard deviation of the Gaussian noise on each component, as a fraction of that component's true value
// (case 4 with noise: 0.1). A component that is zero is measured as zero.
struct SensorNoise {
  double torque_relative = 0.0;
  double foot_force_relative = 0.0;

  // Throws std::invalid_argument naming the field, the value and what is allowed.
  void validate() const;
};

struct SensorReading {
  Vec12 joint_torque = Vec12::Zero();          // [N m]
  PerLeg<Vec3> foot_force_W = zero_vectors();  // [N] ground on foot
};

// The same seed gives the same noise.
class Sensors {
 public:
  Sensors(const SensorNoise& noise, std::uint64_t seed);

  // With noise, every call draws the same number of deviates, so that a reading's noise does not depend on earlier
  // signals.
  SensorReading measure(const StepResult& step) noexcept;

 private:
  SensorNoise noise_;
  NormalDeviates normal_;
};

}  // namespace dob
