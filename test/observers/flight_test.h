// What the tests on the robot in free flight share: the robot, and states to start from.
#pragma once

#include <random>

#include <gtest/gtest.h>

#include "test/observers/free_flight.h"
#include "test/support/random_state.h"

namespace dob::test {

class FlightTest : public ::testing::Test {
 protected:
  explicit FlightTest(unsigned seed = 7) : random(seed) {}

  RobotState moving_state() {
    RobotState state = random_state(random);
    state.qd *= 0.2;
    state.omega_WB *= 0.5;
    return state;
  }

  RobotDescription robot =
      load_robot(std::filesystem::path(DOB_SOURCE_DIR) / "robot/dogbot/dogbot.urdf", Forward::kMinusY);
  Model model{robot};
  std::mt19937_64 random;
};

}  // namespace dob::test
