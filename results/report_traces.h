// Which cells' time series go into the page, and they themselves. Private to results/.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "results/report_index.h"
#include "results/store.h"
#include "results/store_json.h"

namespace dob {

// The finished cells that have kept a trace, the most wanted first: the first variant of every scenario file for every
// observer in the first profile (tuned, else the scenario's first; observers without profiles always), with the gains
// "paper" (else the first) and the scenario's first planner; then the other variants; then the other profiles; then the
// other gains, planners and overrides; then the other seeds.
std::vector<const CellResult*> traces_in_order(const Run& run, const ReportIndex& index);

struct ReportTraces {
  // {"cell" (its place in the plan), ids, "seed", "bytes", and those of results/report_payload.h}
  Json descriptions = Json::array();
  std::vector<std::string> payloads;  // base64, for trace_element() of results/report_page.h
  Json left_out = Json::array();      // [{"what", "why"}]
  std::vector<std::string> missing;   // what was not recorded, and what cannot be read
};

// As many of them, in that order, as fit into `room` bytes of the page with all that is said about them. `limit` is
// what the page calls the reason. A trace that cannot be read is a sentence in `missing`.
ReportTraces take_traces(const std::filesystem::path& dir, const Run& run, const ReportIndex& index, std::size_t room,
                         const std::string& limit);

}  // namespace dob
