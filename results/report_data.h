// What the page says of a run apart from scenarios, robot and time series: the run, its rows, cells, claims and
// timings. Private to results/. The whole of the data is described in docs/report.md.
#pragma once

#include <string>
#include <vector>

#include "results/report_index.h"
#include "results/store.h"
#include "results/store_json.h"

namespace dob {

Json run_json(const Run& run);
Json observers_json(const ReportIndex& index);
Json settings_json(const ReportIndex& index);

// The objects of `table --format json --timing`, each with its ids.
Json rows_json(const Run& run, const ReportIndex& index);

// One for each planned cell, run yet or not, in the order of the plan. Metrics to seven digits; "trace" is null.
Json cells_json(const Run& run, const ReportIndex& index);

// The objects of `table --claims --format json`; a sentence in `missing` where the claims cannot be asked.
Json claims_json(const Run& run, std::vector<std::string>& missing);

// One for each cell that a serial pass has measured.
Json timing_json(const Run& run, const ReportIndex& index);

// What the run lacks of all this and how to get it.
void note_what_is_missing(const Run& run, std::vector<std::string>& missing);

}  // namespace dob
