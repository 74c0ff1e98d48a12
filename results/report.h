// A run as one page that opens from disk, without a network: `dobbench report`. What is in it: docs/report.md.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/campaign_result.h"
#include "results/store.h"

namespace dob {

// results/report/template.html of what came with the program (scenarios/data_root.h).
std::filesystem::path report_template_file();

struct ReportOptions {
  double max_megabytes = 12.0;  // [10^6 bytes] of the whole page; time series are left out until it fits
  std::string version, commit;  // of this program
  std::filesystem::path page_template = report_template_file();
};

struct ReportSummary {
  std::size_t bytes = 0;              // of the page
  std::size_t traces = 0;             // in it
  std::vector<std::string> left_out;  // "what: why"
  std::vector<std::string> missing;   // what the run lacks, and how to get it
};

// Makes the page of the run in `dir`, which a batch may be writing at the same time, and puts it into `file`, complete
// or not at all. Throws StoreError: no run there, a file that cannot be written, a page that is too large even without
// time series.
ReportSummary write_report(const std::filesystem::path& dir, const std::filesystem::path& file,
                           const ReportOptions& options);

// The same of a run that has been read, and of what it has found if it is a campaign: the page then shows that, and of
// single cells only those with time series.
ReportSummary write_report(const std::filesystem::path& dir, const Run& run,
                           const std::optional<CampaignResult>& campaign, const std::filesystem::path& file,
                           const ReportOptions& options);

}  // namespace dob
