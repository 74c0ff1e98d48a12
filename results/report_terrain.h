// The scenarios of a run as the page shows them: what they are, and what was walked on. Private to results/.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/report_index.h"
#include "results/store.h"
#include "results/store_json.h"
#include "scenarios/scenario.h"

namespace dob {

struct ReportScenario {
  CellKey cell;                      // the first one; its seed is the one that is replayed
  std::optional<Scenario> scenario;  // nullopt: its resolved file cannot be loaded
};

// Loads the run directory's scenarios/NAME.toml, in the order of index.scenarios(). What cannot be loaded is a sentence
// in `missing`.
std::vector<ReportScenario> load_report_scenarios(const std::filesystem::path& dir, const RunInfo& info,
                                                  const ReportIndex& index, std::vector<std::string>& missing);

// [{"id", "scenario", "variant", "summary", "duration_s", "metric_leg": "LF" | "all", "set": "paper" | "extra",
//   "seed", "setting", "boxes": [{"center", "size", "yaw", "friction"}], "friction"}, ...]. Of a file that is not
// known: no summary and boxes, all legs, and null for duration and friction.
Json scenarios_json(const std::vector<ReportScenario>& scenarios, const ReportIndex& index);

}  // namespace dob
