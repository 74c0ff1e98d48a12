// What a trial walks on.
#pragma once

#include "scenarios/scenario.h"

namespace dob {

// The scenario's terrain with the blocks of its field where this seed puts them.
Terrain laid_terrain(const Scenario& scenario, int seed);

}  // namespace dob
