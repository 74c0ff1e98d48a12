// What the observers of a plan are made from, as text.
#pragma once

#include <string>
#include <vector>

#include "bench/batch_plan.h"

namespace dob {

// Of each of the plan's observers, in their order: options and routing of it and its shadows (observer_toml() of
// scenarios/loader.h), behind comments with fingerprints of the libraries that they come from: one that has been built
// anew is another observer. Throws std::runtime_error for a library that cannot be read.
std::vector<std::string> observer_sources(const BatchPlan& plan);

}  // namespace dob
