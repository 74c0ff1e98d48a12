#include "results/table_blocks.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/table_cells.h"

namespace dob {
namespace {

struct Column {
  BlockColumn head;
  std::function<std::string(const TableRow&)> cell;
};

struct MetricColumn {
  const char *heading, *unit;
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

std::string rank_cell(const TableRow& row) {
  if (row.oracle) return "bound";
  return row.rank ? std::to_string(*row.rank) : "-";
}

std::string falls_cell(const TableRow& row) {
  if (row.runs == 0) return "-";
  const std::string share = fmt::format("{}/{}", row.falls, row.runs);
  return row.fall_time_median_s ? fmt::format("{} ({:.1f} s)", share, *row.fall_time_median_s) : share;
}

std::string falls_interval_cell(const TableRow& row) {
  return row.falls_ci95 ? fmt::format("{:.0f}-{:.0f}", 100.0 * row.falls_ci95->low, 100.0 * row.falls_ci95->high) : "-";
}

std::string metric_cell(const TableRow& row, const MetricColumn& column) {
  const std::string cell = median_and_worst(row.metrics[column.metric], column.scale);
  return row.until_fall && cell != "-" ? cell + "*" : cell;
}

std::vector<Column> name_columns(TableOrder order) {
  if (order == TableOrder::kByObserver) {
    return {{{"scenario", "", false}, [](const TableRow& row) { return row.key.scenario; }},
            {{"variant", "", false}, [](const TableRow& row) { return row.key.variant; }}};
  }
  return {{{"observer", "", false}, [](const TableRow& row) { return row.key.observer; }},
          {{"profile", "", false}, [](const TableRow& row) { return row.key.profile; }}};
}

bool any(const std::vector<TableRow>& rows, bool (*has)(const TableRow&)) {
  return std::any_of(rows.begin(), rows.end(), has);
}

bool has_falls_interval(const TableRow& row) {
  return row.falls_ci95.has_value();
}

bool has_pairs(const TableRow& row) {
  return row.paired.front().pairs > 0;
}

std::vector<Column> comparison_columns(const std::vector<TableRow>& rows, TableOrder order) {
  std::vector<Column> columns = name_columns(order);
  columns.push_back({{"rank"}, rank_cell});
  columns.push_back({{"falls"}, falls_cell});
  if (any(rows, has_falls_interval)) columns.push_back({{"95 %", "%"}, falls_interval_cell});
  for (const MetricColumn& metric : kMetricColumns) {
    columns.push_back(
        {{metric.heading, metric.unit}, [&metric](const TableRow& row) { return metric_cell(row, metric); }});
  }
  if (any(rows, has_pairs)) {
    columns.push_back({{"paired", "mm"}, [](const TableRow& row) { return difference_cell(row.paired.front(), 1e3); }});
  }
  return columns;
}

std::vector<Column> timing_columns(TableOrder order) {
  const auto figure = [](double TimingSummary::*field) {
    return [field](const TableRow& row) { return row.timing ? rounded(*row.timing.*field) : "-"; };
  };
  std::vector<Column> columns = name_columns(order);
  columns.push_back({{"tick p50", "us"}, figure(&TimingSummary::tick_p50_us)});
  columns.push_back({{"tick p99", "us"}, figure(&TimingSummary::tick_p99_us)});
  columns.push_back({{"tick max", "us"}, figure(&TimingSummary::tick_max_us)});
  columns.push_back({{"QP p50", "us"}, figure(&TimingSummary::qp_p50_us)});
  columns.push_back({{"QP p99", "us"}, figure(&TimingSummary::qp_p99_us)});
  columns.push_back({{"QP max", "us"}, figure(&TimingSummary::qp_max_us)});
  columns.push_back({{"speed", "x real"}, figure(&TimingSummary::real_time_factor)});
  return columns;
}

// What a block's title says; rows of one block agree in it.
std::string block_title(const CellKey& key, TableOrder order) {
  const std::string head = order == TableOrder::kByObserver ? observer_name(key) : scenario_name(key);
  return on_one_line(fmt::format("{}: {}", head, set_name(key)));
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

TableBlock empty_block(std::string title, const std::vector<Column>& columns) {
  TableBlock block{std::move(title), {}};
  for (const Column& column : columns) block.columns.push_back(column.head);
  return block;
}

std::vector<std::string> cells_of(const TableRow& row, const std::vector<Column>& columns) {
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const Column& column : columns) cells.push_back(column.cell(row));
  return cells;
}

// The row's block, the last one or a new one.
TableBlock& block_for(const std::string& title, const std::vector<Column>& columns, std::vector<TableBlock>& blocks) {
  if (blocks.empty() || blocks.back().title != title) blocks.push_back(empty_block(title, columns));
  return blocks.back();
}

}  // namespace

std::vector<TableBlock> comparison_blocks(const std::vector<TableRow>& rows, TableOrder order) {
  const std::vector<Column> columns = comparison_columns(rows, order);
  std::vector<TableBlock> blocks;
  for (const TableRow& row : rows) {
    TableBlock& block = block_for(block_title(row.key, order), columns, blocks);
    block.rows.push_back(cells_of(row, columns));
    add_notes(row, order, block.notes);
  }
  return blocks;
}

std::vector<TableBlock> timing_blocks(const std::vector<TableRow>& rows, TableOrder order) {
  const std::vector<Column> columns = timing_columns(order);
  std::vector<TableBlock> blocks;
  for (const TableRow& row : rows) {
    if (!row.timing) continue;
    block_for("time, " + block_title(row.key, order), columns, blocks).rows.push_back(cells_of(row, columns));
  }
  return blocks;
}

std::vector<std::string> comparison_legend(const std::vector<TableRow>& rows) {
  std::vector<std::string> legend{
      "CoM: distance to the planner's reference. foot: error in swing, apart from swings that meet the onset of a "
      "disturbance within 20 ms of lift-off (onset). GRF err: commanded minus measured ground reaction force. "
      "est. rmse: estimated minus true force at its point. QP fail: solves that did not end optimal.",
      "a / b: median and worst over the seeds, one figure where they are the same. falls k/n: k of n runs fell, at the "
      "median time given. Figures are those of the runs that survived; *: every run fell, figures up to the fall, not "
      "comparable with full runs. rank: fewer falls first, then the smaller CoM max (where every run fell, the later "
      "fall); bound: an oracle, not ranked. -: "
      "does not apply. Definitions: docs/metrics.md."};
  if (any(rows, has_falls_interval)) legend.emplace_back("95 %: Wilson interval of the share of runs that fall.");
  if (any(rows, has_pairs)) {
    std::set<std::string> references;
    for (const TableRow& row : rows) {
      if (has_pairs(row)) references.insert(row.reference);
    }
    legend.push_back(fmt::format(
        "paired: CoM max minus that of {}, run by run on the time that both stood, falls "
        "included: median{}.",
        fmt::join(references, " or "),
        any(rows, [](const TableRow& row) { return row.paired.front().ci95.has_value(); }) ? " [95 % interval]" : ""));
  }
  return legend;
}

std::vector<std::string> timing_legend() {
  return {
      "tick: one control tick (model, observer, gait, planner, QP, torques). QP: one solve. speed: simulated time over "
      "wall time of the trial. From a serial pass: medians over the seeds, of tick max and QP max the largest."};
}

}  // namespace dob
