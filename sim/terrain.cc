#include "sim/terrain.h"

#include <fmt/format.h>

#include "sim/require.h"

namespace dob {

void Terrain::validate() const {
  const Require require{"terrain"};
  require.not_negative("ground_friction", ground_friction);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const TerrainBox& box = boxes[i];
    require.not_negative(fmt::format("boxes[{}].friction", i), box.friction);
    require.finite(fmt::format("boxes[{}].yaw_rad", i), box.yaw_rad);
    for (int axis = 0; axis < 3; ++axis) {
      const double center = box.center[axis];
      const double edge = box.size[axis];
      require.finite(fmt::format("boxes[{}].center[{}]", i, axis), center);
      require.positive(fmt::format("boxes[{}].size[{}]", i, axis), edge);
    }
  }
}

}  // namespace dob
