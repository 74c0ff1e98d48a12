// The robot as the page's replay draws it. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/report_terrain.h"
#include "results/store_json.h"
#include "robot/description.h"

namespace dob {

// Canonical link frames (robot/description.h); link 0 is the trunk, joint 3 * leg + (0, 1, 2), legs LF RF LH RH.
// {"name", "mass_kg", "links": [{"name", "parent": -1 | index, "joint": -1 | 0..11, "origin": [3], "axis": [3],
//                     "shapes": [{"kind": "box" | "cylinder" | "sphere", "size": [3], "position": [3],
//                                 "rotation": [9, row by row]}]}],
//  "feet": [{"leg", "link", "center": [3], "radius"}]}
Json robot_json(const RobotDescription& robot);

// Those that walked, each once, in the order of the scenarios. `shown[i]["robot"]` becomes the place of that of
// scenarios[i]; null where the scenario or its robot's description cannot be read, the latter a sentence in `missing`.
Json report_robots(const std::vector<ReportScenario>& scenarios, Json& shown, std::vector<std::string>& missing);

}  // namespace dob
