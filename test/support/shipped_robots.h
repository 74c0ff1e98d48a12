// The robots in robot/, for tests that hold for any of them.
#pragma once

#include <array>
#include <filesystem>

#include "robot/description.h"

namespace dob::test {

struct ShippedRobot {
  const char* name;
  const char* urdf;  // from the source directory
  Forward forward;

  std::filesystem::path file() const { return std::filesystem::path(DOB_SOURCE_DIR) / urdf; }
  RobotDescription load() const { return load_robot(file(), forward); }
};

inline constexpr std::array<ShippedRobot, 2> kShippedRobots{{{"dogbot", "robot/dogbot/dogbot.urdf", Forward::kMinusY},
                                                             {"quad12", "robot/quad12/quad12.urdf", Forward::kPlusX}}};

}  // namespace dob::test
