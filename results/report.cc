#include "results/report.h"

#include <fmt/format.h>

#include "results/report_campaign.h"
#include "results/report_data.h"
#include "results/report_index.h"
#include "results/report_page.h"
#include "results/report_robot.h"
#include "results/report_terrain.h"
#include "results/report_traces.h"
#include "results/whole_file.h"
#include "scenarios/data_root.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr int kSchema = 3;
constexpr std::size_t kReserve = 4096;  // of the page, for lists that grow while traces are taken

std::string title_of(const fs::path& dir) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(dir, error);
  return (error ? dir : whole).filename().string();
}

// What the page is made of. Of a campaign `shown` is but a part, see run_with_series.
struct Content {
  const Run& run;
  const Run& shown;
  const std::optional<CampaignResult>& campaign;
  ReportIndex index = ReportIndex(shown.info.cells);
};

void note_what_is_missing(const Content& content, std::vector<std::string>& missing) {
  if (!content.campaign) {
    note_what_is_missing(content.run, missing);
  } else if (content.shown.cells.empty()) {
    missing.emplace_back("No plots over time and no replay: this campaign kept no time series.");
  }
}

// All but the time series and what is said about them. A campaign's rows would be one for each level and the paper's
// claims are about other experiments: it has neither.
Json data_without_traces(const fs::path& dir, const Content& content, const ReportOptions& options,
                         std::vector<std::string>& missing) {
  const auto& [run, shown, campaign, index] = content;
  note_what_is_missing(content, missing);
  const std::vector<ReportScenario> scenarios = load_report_scenarios(dir, shown.info, index, missing);
  Json data{{"schema", kSchema}, {"title", title_of(dir)}, {"run", run_json(run)}};
  data["written_by"] = {{"version", options.version}, {"commit", options.commit}};
  data["campaign"] = campaign_json(campaign, run);
  data["observers"] = observers_json(index);
  data["settings"] = settings_json(index);
  data["scenarios"] = scenarios_json(scenarios, index);
  data["rows"] = campaign ? Json::array() : rows_json(run, index);
  data["cells"] = cells_json(shown, index);
  data["claims"] = campaign ? Json::array() : claims_json(run, missing);
  data["timing"] = timing_json(shown, index);
  data["robots"] = report_robots(scenarios, data["scenarios"], missing);
  data["traces"] = Json::array();
  data["left_out"] = Json::array();
  data["missing"] = missing;
  return data;
}

void add_traces(Json& data, const ReportTraces& traces, std::vector<std::string>& missing) {
  for (std::size_t i = 0; i < traces.descriptions.size(); ++i) {
    data["cells"][traces.descriptions[i]["cell"].get<std::size_t>()]["trace"] = i;
  }
  missing.insert(missing.end(), traces.missing.begin(), traces.missing.end());
  data["traces"] = traces.descriptions;
  data["left_out"] = traces.left_out;
  data["missing"] = missing;
}

}  // namespace

fs::path report_template_file() {
  return data_root() / "results" / "report" / "template.html";
}

ReportSummary write_report(const fs::path& dir, const fs::path& file, const ReportOptions& options) {
  const Run run = read_run(dir);
  const std::optional<Campaign> campaign = read_campaign(dir);
  return write_report(dir, run, campaign ? std::optional(campaign_result(*campaign, run)) : std::nullopt, file,
                      options);
}

ReportSummary write_report(const fs::path& dir, const Run& run, const std::optional<CampaignResult>& campaign,
                           const fs::path& file, const ReportOptions& options) {
  const PageTemplate page(options.page_template);
  const Run part = campaign ? run_with_series(run, campaign->campaign) : Run{};
  const Content content{run, campaign ? part : run, campaign};
  ReportSummary summary;
  Json data = data_without_traces(dir, content, options, summary.missing);

  const auto most = static_cast<std::size_t>(1e6 * options.max_megabytes);
  const std::size_t least = page.size() + data_element(data).size() + kReserve;
  if (least > most) {
    throw StoreError(fmt::format("{}: the page takes {:.2f} MB without any time series; allowed: {} MB (--max-size)",
                                 file.string(), 1e-6 * static_cast<double>(least), options.max_megabytes));
  }
  const ReportTraces traces = take_traces(dir, content.shown, content.index, most - least,
                                          fmt::format("size limit {} MB", options.max_megabytes));
  add_traces(data, traces, summary.missing);
  const std::string text = page.with(data, traces.payloads);
  write_whole_file(file, text);

  summary.bytes = text.size();
  summary.traces = traces.payloads.size();
  for (const Json& entry : traces.left_out) {
    summary.left_out.push_back(
        fmt::format("{}: {}", entry["what"].get<std::string>(), entry["why"].get<std::string>()));
  }
  return summary;
}

}  // namespace dob
