// The range of every number of a robot description, as data. Internal to robot/.
#pragma once

#include <array>
#include <string_view>

class TiXmlElement;

namespace dob {

// Numbers of one attribute: finite, from min to max, min itself not where it is left out.
struct UrdfRange {
  std::string_view element, attribute, unit;
  double min, max;
  bool without_min = false;
};

// Wide enough for any legged robot, narrow enough for degrees, millimetres and grams to fall out. No mass and no
// inertia is that of a link that stands for a frame; what moves needs one (robot/description.h). <axis> and <limit> are
// those of revolute joints: what others have there is not read.
inline constexpr std::array kUrdfRanges{
    UrdfRange{"mass", "value", "kg", 0.0, 1e3},
    UrdfRange{"inertia", "ixx", "kg m^2", 0.0, 1e3},
    UrdfRange{"inertia", "iyy", "kg m^2", 0.0, 1e3},
    UrdfRange{"inertia", "izz", "kg m^2", 0.0, 1e3},
    UrdfRange{"inertia", "ixy", "kg m^2", -1e3, 1e3},
    UrdfRange{"inertia", "ixz", "kg m^2", -1e3, 1e3},
    UrdfRange{"inertia", "iyz", "kg m^2", -1e3, 1e3},
    UrdfRange{"origin", "xyz", "m", -10.0, 10.0},
    UrdfRange{"origin", "rpy", "rad", -12.6, 12.6},
    UrdfRange{"box", "size", "m", 0.0, 10.0, true},
    UrdfRange{"cylinder", "radius", "m", 0.0, 10.0, true},
    UrdfRange{"cylinder", "length", "m", 0.0, 10.0, true},
    UrdfRange{"sphere", "radius", "m", 0.0, 10.0, true},
    UrdfRange{"axis", "xyz", "-", -1e3, 1e3},
    UrdfRange{"limit", "lower", "rad", -12.6, 12.6},
    UrdfRange{"limit", "upper", "rad", -12.6, 12.6},
    UrdfRange{"limit", "effort", "N m", 0.0, 1e4, true},
    UrdfRange{"limit", "velocity", "rad/s", 0.0, 1e3, true},
};

// Throws DescriptionError with line, column, link or joint, element, attribute, value and what is allowed, also for
// what is no number. How many numbers an attribute has is left to urdfdom.
void check_ranges(const TiXmlElement& robot);

}  // namespace dob
