#include "scenarios/laid_terrain.h"

namespace dob {

Terrain laid_terrain(const Scenario& scenario, int seed) {
  Terrain terrain = scenario.terrain;
  if (scenario.block_field) {
    const auto blocks = lay_blocks(*scenario.block_field, static_cast<std::uint64_t>(seed));
    terrain.boxes.insert(terrain.boxes.end(), blocks.begin(), blocks.end());
  }
  return terrain;
}

}  // namespace dob
