#include "sim/terrain.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

void require(bool allowed, std::string_view where, double value, std::string_view expected) {
  if (!allowed) throw std::invalid_argument(fmt::format("terrain: {} = {}, must be {}", where, value, expected));
}

void require_friction(double friction, std::string_view where) {
  require(std::isfinite(friction) && friction >= 0.0, where, friction, "finite and >= 0");
}

}  // namespace

void Terrain::validate() const {
  require_friction(ground_friction, "ground_friction");
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const TerrainBox& box = boxes[i];
    require_friction(box.friction, fmt::format("boxes[{}].friction", i));
    require(std::isfinite(box.yaw_rad), fmt::format("boxes[{}].yaw_rad", i), box.yaw_rad, "finite");
    for (int axis = 0; axis < 3; ++axis) {
      const double center = box.center[axis];
      const double edge = box.size[axis];
      require(std::isfinite(center), fmt::format("boxes[{}].center[{}]", i, axis), center, "finite");
      require(std::isfinite(edge) && edge > 0.0, fmt::format("boxes[{}].size[{}]", i, axis), edge, "finite and > 0");
    }
  }
}

}  // namespace dob
