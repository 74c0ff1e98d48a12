// The ground the robot walks on: the plane z = 0 of W and boxes resting on it.
#pragma once

#include <vector>

#include "robot/types.h"

namespace dob {

// A box with vertical edges. It may reach below the plane; only what sticks out can be touched.
struct TerrainBox {
  Vec3 center = Vec3::Zero();  // [m] in W
  Vec3 size = Vec3::Ones();    // [m] full edges, along the box's own axes
  double yaw_rad = 0.0;        // [rad] about z of W
  double friction = 1.0;       // [-] coefficient of its whole surface
};

struct Terrain {
  double ground_friction = 1.0;  // [-]
  std::vector<TerrainBox> boxes;

  // Throws std::invalid_argument naming the box, the field, the value and what is allowed.
  void validate() const;
};

}  // namespace dob
