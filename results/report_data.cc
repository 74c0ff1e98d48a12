#include "results/report_data.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "observers/factory.h"
#include "results/claims.h"
#include "results/claims_table.h"
#include "results/data_values.h"
#include "results/metric_fields.h"
#include "results/report_text.h"
#include "results/run_database.h"
#include "results/table.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

constexpr std::array kCellMetrics{
    metric_index("com_error_max_m"),           metric_index("com_error_rms_m"),  metric_index("path_error_max_m"),
    metric_index("foot_error_max_m"),          metric_index("grf_error_mean_N"), metric_index("estimate_rmse_N"),
    metric_index("orientation_error_max_rad"),
};

double with_digits(double x, int digits) {
  return std::stod(fmt::format("{:.{}g}", x, digits));
}

Json seven_digits(const std::optional<double>& x) {
  return x ? Json(with_digits(*x, 7)) : Json();
}

// What a row of the table is called; bytes that are not UTF-8 are replaced in it, as they are in the row.
std::string row_name(const CellKey& key) {
  return one_line({key.scenario, key.variant, key.observer, key.profile, key.gains, key.planner, key.overrides});
}

std::string row_name(const Json& row) {
  return one_line({row.at("scenario"), row.at("variant"), row.at("observer"), row.at("profile"), row.at("gains"),
                   row.at("planner"), row.at("overrides")});
}

void hide_directories(Json& text) {
  if (text.is_string()) text = without_directories(text.get<std::string>());
}

Json cell_json(const CellKey& key, const CellResult* result, const ReportIndex& index) {
  Json json = index.ids(key);
  json["seed"] = key.seed;
  json["outcome"] = result != nullptr ? kOutcomes.at(static_cast<std::size_t>(result->outcome)) : "pending";
  const bool fell = result != nullptr && result->outcome == Outcome::kFell;
  json["fall_time_s"] = fell ? seven_digits(result->simulated_s) : Json();
  json["reason"] = result != nullptr ? without_directories(result->reason) : "";
  for (const std::size_t i : kCellMetrics) {
    const MetricField& field = kMetricFields[i];
    json[std::string(field.name)] = result != nullptr ? seven_digits(field.of(result->metrics)) : Json();
  }
  json["trace"] = Json();
  return json;
}

Json histogram_json(const TimeHistogram& histogram) {
  if (histogram.counts.empty()) return {};
  Json edges = Json::array();
  for (const double edge : histogram.edges_us) edges.push_back(with_digits(edge, 4));
  return {{"edges_us", std::move(edges)}, {"counts", histogram.counts}};
}

std::string number_of(std::size_t n, std::string_view thing) {
  return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

}  // namespace

Json run_json(const Run& run) {
  const RunInfo& info = run.info;
  std::set<int> seeds;
  for (const CellKey& key : info.cells) seeds.insert(key.seed);
  Json notes = Json::array();
  for (const std::string& note : run.notes) notes.push_back(without_directories(note));
  const auto errors = std::count_if(run.cells.begin(), run.cells.end(),
                                    [](const CellResult& cell) { return cell.outcome == Outcome::kError; });
  return {{"command_line", info.command_line},
          {"version", info.version},
          {"commit", info.commit},
          {"build", info.build},
          {"compiler", info.compiler},
          {"flags", without_directories(info.flags)},
          {"date", info.date},
          {"machine", {{"cpu", info.machine.cpu}, {"cores", info.machine.cores}, {"os", info.machine.os}}},
          {"planned", info.cells.size()},
          {"finished", run.cells.size()},
          {"errors", errors},
          {"seeds", seeds},
          {"notes", std::move(notes)}};
}

Json observers_json(const ReportIndex& index) {
  Json list = Json::array();
  for (const CellKey& cell : index.observers()) {
    list.push_back({{"id", index.observer_id(cell)},
                    {"observer", cell.observer},
                    {"profile", cell.profile},
                    {"oracle", is_oracle(cell.observer.substr(0, cell.observer.find(':')))}});
  }
  return list;
}

Json settings_json(const ReportIndex& index) {
  Json list = Json::array();
  for (const CellKey& cell : index.settings()) {
    list.push_back(
        {{"id", list.size()}, {"gains", cell.gains}, {"planner", cell.planner}, {"overrides", cell.overrides}});
  }
  return list;
}

Json rows_json(const Run& run, const ReportIndex& index) {
  std::map<std::string, const CellKey*> keys;
  for (const CellKey& key : run.info.cells.rows()) keys.emplace(row_name(key), &key);
  Json rows = Json::parse(render_table(run, {.format = TableFormat::kJson, .timing = true}));
  for (Json& row : rows) {
    row.update(index.ids(*keys.at(row_name(row))));
    hide_directories(row["fall_reason"]);
    hide_directories(row["error_reason"]);
  }
  return rows;
}

Json cells_json(const Run& run, const ReportIndex& index) {
  std::map<CellKey, const CellResult*> results;
  for (const CellResult& cell : run.cells) results[cell.key] = &cell;
  Json list = Json::array();
  for (const CellKey& key : run.info.cells) {
    const auto result = results.find(key);
    list.push_back(cell_json(key, result == results.end() ? nullptr : result->second, index));
  }
  return list;
}

Json claims_json(const Run& run, std::vector<std::string>& missing) {
  try {
    const ClaimSet set = load_claims(paper_claims_file());
    return Json::parse(render_claims(set, evaluate_claims(set, run), TableFormat::kJson));
  } catch (const InputError& error) {
    missing.push_back(fmt::format("The paper's claims cannot be read ({}).", without_directories(error.what())));
    return Json::array();
  }
}

Json timing_json(const Run& run, const ReportIndex& index) {
  Json list = Json::array();
  for (const CellTiming& timing : run.timings) {
    Json json = index.ids(timing.key);
    json["seed"] = timing.key.seed;
    for (const TimingColumn& column : kTimingColumns) {
      json[std::string(column.name)] = seven_digits(timing.*column.field);
    }
    json["tick_histogram"] = histogram_json(timing.tick_histogram);
    json["qp_histogram"] = histogram_json(timing.qp_histogram);
    list.push_back(std::move(json));
  }
  return list;
}

void note_what_is_missing(const Run& run, std::vector<std::string>& missing) {
  const std::size_t open = run.info.cells.size() - run.cells.size();
  if (open > 0) {
    missing.push_back(
        fmt::format("{} of {} have not been run: the batch is still going on, or was stopped. `dobbench run --resume "
                    "--out DIR` does the rest.",
                    open, number_of(run.info.cells.size(), "cell")));
  }
  if (run.timings.empty()) {
    missing.emplace_back("No tick and QP times: `dobbench timing --out DIR` measures them, one cell after the other.");
  } else if (std::all_of(run.timings.begin(), run.timings.end(),
                         [](const CellTiming& timing) { return timing.tick_histogram.counts.empty(); })) {
    missing.emplace_back(
        "No histograms of tick and QP times: they were measured before these were kept. `dobbench timing --out DIR` "
        "measures again.");
  }
}

}  // namespace dob
