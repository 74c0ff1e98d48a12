// From a merged document to a Scenario: which keys there are, their units and their ranges. The defaults are in
// config/defaults.toml, which names every key.
#pragma once

#include <string>
#include <vector>

#include "scenarios/document.h"
#include "scenarios/scenario.h"

namespace dob {

class Reader;

// Reads everything but the keys that scenarios/scenario_source.h takes out of a file; loads the robot's description,
// too, because points and postures are checked against it. Throws InputError for the first thing that is wrong.
Scenario read_scenario(const Node& document);

// One [[disturbance]] of the document, added to the scenario, whose gait and tick are read already; the foot is the
// contact sphere's centre of `robot`.
void read_disturbance(Reader& reader, const RobotDescription& robot, Scenario& scenario);

// [terrain]: the ground, its boxes, and a field of blocks if there is one.
void read_terrain(Reader& reader, Scenario& scenario);
// What the robot does not know, or is told wrongly: [model_error], [sensing], [[payload]].
void read_imperfections(Reader& reader, Scenario& scenario);

// late_loads() of scenarios/loader.h, of a document and what was read from it.
std::vector<std::string> find_late_loads(const Node& document, const Scenario& scenario, bool shifted);

}  // namespace dob
