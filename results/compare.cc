#include "results/compare.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "results/table_blocks.h"
#include "results/table_cells.h"
#include "results/table_formats.h"

namespace dob {
namespace {

constexpr double kTolerance = 0.05;  // share by which every one of a few pairs must be worse

using CellsByKey = std::map<CellKey, const CellResult*>;

std::string regression_of(const ComparedRow& row, const std::vector<FigurePair>& pairs) {
  if (row.errors_b > row.errors_a) return "more cells could not be run";
  if (row.falls_b > row.falls_a) return "more falls";
  if (row.difference.ci95) return row.difference.ci95->low > 0.0 ? "the whole interval is above zero" : "";
  const auto worse = [](const FigurePair& pair) { return pair.b > (1.0 + kTolerance) * pair.a; };
  const bool all = !pairs.empty() && std::all_of(pairs.begin(), pairs.end(), worse);
  return all ? fmt::format("every run is worse by more than {:.0f} %", 100.0 * kTolerance) : "";
}

ComparedRow compare_row(const CellKey& key, const std::vector<std::pair<const CellResult*, const CellResult*>>& cells,
                        const MetricField& metric) {
  ComparedRow row{.key = key, .difference = {}, .regression = {}};
  std::vector<FigurePair> pairs;
  std::vector<double> differences;
  for (const auto& [a, b] : cells) {
    ++row.cells;
    row.falls_a += a->outcome == Outcome::kFell ? 1 : 0;
    row.falls_b += b->outcome == Outcome::kFell ? 1 : 0;
    row.errors_a += a->outcome == Outcome::kError ? 1 : 0;
    row.errors_b += b->outcome == Outcome::kError ? 1 : 0;
    const std::optional<FigurePair> pair = paired_figures(*a, *b, metric);
    if (!pair) continue;
    pairs.push_back(*pair);
    differences.push_back(pair->b - pair->a);
  }
  row.difference = summarise_differences(differences);
  row.regression = regression_of(row, pairs);
  return row;
}

CellsByKey cells_of(const Run& run) {
  CellsByKey cells;
  for (const CellResult& cell : run.cells) cells[cell.key] = &cell;
  return cells;
}

// From SI to what readers get.
struct ShownUnit {
  std::string name;
  double scale;
};

ShownUnit unit_of(std::string_view metric) {
  if (metric.ends_with("_m")) return {"mm", 1e3};
  if (metric.ends_with("_Nm")) return {"N m", 1.0};
  if (metric.ends_with("_N")) return {"N", 1.0};
  if (metric.ends_with("_rad")) return {"rad", 1.0};
  return {"", 1.0};
}

TableBlock block_of(const Comparison& comparison) {
  const ShownUnit unit = unit_of(comparison.metric);
  TableBlock block{fmt::format("B - A, {}", comparison.metric),
                   {{"scenario", "", false},
                    {"observer", "", false},
                    {"set", "", false},
                    {"falls A"},
                    {"falls B"},
                    {"pairs"},
                    {"B - A", unit.name},
                    {"", "", false}}};
  for (const ComparedRow& row : comparison.rows) {
    const auto falls = [&](int k, int errors) { return fmt::format("{}/{}", k, row.cells - errors); };
    block.rows.push_back({scenario_name(row.key), observer_name(row.key), on_one_line(set_name(row.key)),
                          falls(row.falls_a, row.errors_a), falls(row.falls_b, row.errors_b),
                          std::to_string(row.difference.pairs), difference_cell(row.difference, unit.scale),
                          row.regression.empty() ? "" : "worse: " + row.regression});
  }
  const auto note = [&](const CellKey& key, const char* where) {
    block.notes.push_back(on_one_line(
        fmt::format("only in {}: {}, {}: {}", where, scenario_name(key), observer_name(key), set_name(key))));
  };
  for (const CellKey& key : comparison.only_a) note(key, "A");
  for (const CellKey& key : comparison.only_b) note(key, "B");
  return block;
}

}  // namespace

bool Comparison::regression() const noexcept {
  return std::any_of(rows.begin(), rows.end(), [](const ComparedRow& row) { return !row.regression.empty(); });
}

Comparison compare_runs(const Run& a, const Run& b, const MetricField& metric) {
  const CellsByKey cells_a = cells_of(a), cells_b = cells_of(b);
  std::map<CellKey, std::vector<std::pair<const CellResult*, const CellResult*>>> shared;
  for (const auto& [key, cell] : cells_a) {
    if (const auto other = cells_b.find(key); other != cells_b.end()) {
      shared[without_seed(key)].emplace_back(cell, other->second);
    }
  }
  if (shared.empty()) throw std::invalid_argument("the two runs share no cell, so there is nothing to compare");
  Comparison comparison{metric.name, {}, {}, {}};
  for (const TableRow& row : build_rows(a, TableOrder::kByScenario)) {
    const auto cells = shared.find(row.key);
    if (cells == shared.end()) {
      comparison.only_a.push_back(row.key);
    } else {
      comparison.rows.push_back(compare_row(row.key, cells->second, metric));
    }
  }
  for (const TableRow& row : build_rows(b, TableOrder::kByScenario)) {
    if (!shared.contains(row.key)) comparison.only_b.push_back(row.key);
  }
  return comparison;
}

std::string comparison_text(const Comparison& comparison) {
  const auto worse = std::count_if(comparison.rows.begin(), comparison.rows.end(),
                                   [](const ComparedRow& row) { return !row.regression.empty(); });
  return table_text(
      {block_of(comparison)},
      {"B - A: median difference run by run [95 % interval, from 8 pairs on], on the time that both stood "
       "where the metric has checkpoints, else over pairs that survived. Definitions: docs/metrics.md.",
       fmt::format("{} of {} rows are worse in B.", worse, comparison.rows.size())});
}

}  // namespace dob
