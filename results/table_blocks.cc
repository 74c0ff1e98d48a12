#include "results/table_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace dob {
namespace {

struct MetricColumn {
  std::string_view heading, unit;
  std::size_t metric;
  double scale;  // from SI to the unit
};

constexpr std::array kMetricColumns{
    MetricColumn{"CoM max", "mm", metric_index("com_error_max_m"), 1e3},
    MetricColumn{"CoM rms", "mm", metric_index("com_error_rms_m"), 1e3},
    MetricColumn{"foot max", "mm", metric_index("foot_error_max_m"), 1e3},
    MetricColumn{"onset", "mm", metric_index("foot_error_onset_max_m"), 1e3},
    MetricColumn{"GRF err", "N", metric_index("grf_error_mean_N"), 1.0},
    MetricColumn{"est. rmse", "N", metric_index("estimate_rmse_N"), 1.0},
    MetricColumn{"QP fail", "", metric_index("qp_failures"), 1.0},
};

// About three digits: enough to compare, few enough to read.
std::string rounded(double x) {
  if (x == std::floor(x) && std::abs(x) < 1e6) return fmt::format("{:.0f}", x);
  const double size = std::abs(x);
  if (size >= 1e6) return fmt::format("{:.1e}", x);
  return fmt::format("{:.{}f}", x, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

std::string metric_cell(const MetricSummary& metric, double scale, const TableRow& row) {
  if (!metric.median || !metric.worst) return "-";
  std::string cell = rounded(*metric.median * scale);
  if (row.seeds > 1) cell += fmt::format(" ({})", rounded(*metric.worst * scale));
  return row.until_fall ? cell + "*" : cell;
}

std::string falls_cell(const TableRow& row) {
  if (row.runs == 0) return "-";
  const std::string share = fmt::format("{}/{}", row.falls, row.runs);
  return row.fall_time_median_s ? fmt::format("{} ({:.1f} s)", share, *row.fall_time_median_s) : share;
}

std::string scenario_name(const CellKey& key) {
  return key.variant.empty() ? key.scenario : key.scenario + " / " + key.variant;
}

std::string observer_name(const CellKey& key) {
  return fmt::format("{} ({})", key.observer, key.profile);
}

// What a block's title says; rows of one block agree in it.
std::string block_title(const CellKey& key, TableOrder order) {
  const std::string head = order == TableOrder::kByObserver ? observer_name(key) : scenario_name(key);
  const std::string set = key.overrides.empty() ? "" : fmt::format(", set {}", key.overrides);
  return fmt::format("{}: gains {}, planner {}{}", head, key.gains, key.planner, set);
}

std::vector<BlockColumn> make_columns(const TableOptions& options) {
  const bool by_observer = options.order == TableOrder::kByObserver;
  std::vector<BlockColumn> columns{{by_observer ? "scenario" : "observer", "", false},
                                   {by_observer ? "variant" : "profile", "", false},
                                   {"falls", "", true}};
  for (const MetricColumn& column : kMetricColumns) {
    columns.push_back({std::string(column.heading), std::string(column.unit), true});
  }
  if (options.timing) columns.push_back({"speed", "x real", true});
  return columns;
}

std::vector<std::string> make_cells(const TableRow& row, const TableOptions& options) {
  const bool by_observer = options.order == TableOrder::kByObserver;
  std::vector<std::string> cells{by_observer ? row.key.scenario : row.key.observer,
                                 by_observer ? row.key.variant : row.key.profile, falls_cell(row)};
  for (const MetricColumn& column : kMetricColumns) {
    cells.push_back(metric_cell(row.metrics[column.metric], column.scale, row));
  }
  if (options.timing) cells.push_back(row.real_time_factor ? rounded(*row.real_time_factor) : "-");
  return cells;
}

// Reasons come from anywhere: one line each, whatever they hold.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

void add_notes(const TableRow& row, TableOrder order, std::vector<std::string>& notes) {
  const std::string who = order == TableOrder::kByObserver ? scenario_name(row.key) : observer_name(row.key);
  if (row.falls > 0) notes.push_back(on_one_line(fmt::format("{}: fell: {}", who, row.fall_reason)));
  if (row.errors > 0) {
    notes.push_back(
        on_one_line(fmt::format("{}: {} of {} could not be run: {}", who, row.errors, row.seeds, row.error_reason)));
  }
  if (const int missing = row.seeds - row.runs - row.errors; missing > 0) {
    notes.push_back(fmt::format("{}: {} of {} not run yet", who, missing, row.seeds));
  }
}

}  // namespace

std::vector<TableBlock> make_blocks(const Run& run, const TableOptions& options) {
  std::vector<TableBlock> blocks;
  for (const TableRow& row : build_rows(run, options.order)) {
    const std::string title = on_one_line(block_title(row.key, options.order));
    if (blocks.empty() || blocks.back().title != title) blocks.push_back({title, make_columns(options), {}, {}});
    blocks.back().rows.push_back(make_cells(row, options));
    add_notes(row, options.order, blocks.back().notes);
  }
  return blocks;
}

std::vector<std::string> table_legend(const TableOptions& options) {
  std::vector<std::string> legend{
      "CoM: distance to the planner's reference. foot: error in swing, apart from swings that meet the onset of a "
      "disturbance within 20 ms of lift-off (onset). GRF err: commanded minus measured ground reaction force. "
      "est. rmse: estimated minus true force at its point. QP fail: solves that did not end optimal.",
      "a (b): median and worst over the seeds. falls k/n: k of n runs fell, at the median time given. Figures are "
      "those of the runs that survived; *: every run fell, figures up to the fall, not comparable with full runs. "
      "-: does not apply. Definitions: docs/metrics.md."};
  if (options.timing) legend.emplace_back("speed: simulated time over wall time of the trial, median.");
  return legend;
}

}  // namespace dob
