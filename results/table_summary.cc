#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "results/table_blocks.h"
#include "results/table_cells.h"

namespace dob {
namespace {

using Rows = std::vector<const TableRow*>;

constexpr std::size_t kCom = metric_index("com_error_max_m");
constexpr std::size_t kFoot = metric_index("foot_error_max_m");

// One observer over all scenarios of a set.
struct Line {
  const CellKey* key = nullptr;
  Rows rows;
  int runs = 0, falls = 0, errors = 0;
  bool oracle = false;
  std::optional<double> mean_rank;

  double lost_share() const { return static_cast<double>(falls + errors) / std::max(1, runs + errors); }
};

bool same_set(const CellKey& a, const CellKey& b) {
  return a.gains == b.gains && a.planner == b.planner && a.overrides == b.overrides;
}

bool same_observer(const CellKey& a, const CellKey& b) {
  return a.observer == b.observer && a.profile == b.profile;
}

Line make_line(const Rows& rows) {
  Line line{.key = &rows.front()->key, .rows = rows, .oracle = rows.front()->oracle, .mean_rank = {}};
  double ranks = 0.0;
  int ranked = 0;
  for (const TableRow* row : rows) {
    line.runs += row->runs;
    line.falls += row->falls;
    line.errors += row->errors;
    if (!row->rank) continue;
    ranks += *row->rank;
    ++ranked;
  }
  if (ranked > 0) line.mean_rank = ranks / ranked;
  return line;
}

// Oracles last; those that lost nothing first; then by mean rank.
bool stands_before(const Line& a, const Line& b) {
  if (a.oracle != b.oracle) return b.oracle;
  if (a.lost_share() != b.lost_share()) return a.lost_share() < b.lost_share();
  return a.mean_rank.value_or(HUGE_VAL) < b.mean_rank.value_or(HUGE_VAL);
}

// The largest of the variants' medians; those of fallen runs do not compare with full ones.
std::string worst_median(const Rows& rows, std::size_t metric) {
  std::optional<double> worst;
  for (const TableRow* row : rows) {
    const std::optional<double>& value = row->metrics[metric].median;
    if (value && !row->until_fall) worst = std::max(*value, worst.value_or(*value));
  }
  return worst ? rounded(*worst * 1e3) : "-";
}

// "3/20 17.4 / 2.5": falls where there are any, CoM and foot.
std::string scenario_cell(const Rows& rows) {
  if (rows.empty()) return "";
  const Line line = make_line(rows);
  if (line.runs + line.errors == 0) return "-";
  std::string cell = line.falls > 0 ? fmt::format("{}/{} ", line.falls, line.runs) : "";
  if (line.falls == line.runs) return line.errors > 0 ? cell + "!" : cell.substr(0, cell.size() - 1);
  cell += fmt::format("{} / {}", worst_median(rows, kCom), worst_median(rows, kFoot));
  return line.errors > 0 ? cell + " !" : cell;
}

std::vector<std::string> cells_of(const Line& line, const std::vector<std::string>& scenarios) {
  std::vector<std::string> cells{line.key->observer, line.key->profile,
                                 line.oracle      ? "bound"
                                 : line.mean_rank ? fmt::format("{:.1f}", *line.mean_rank)
                                                  : "-",
                                 fmt::format("{}/{}", line.falls, line.runs)};
  for (const std::string& scenario : scenarios) {
    Rows rows;
    std::copy_if(line.rows.begin(), line.rows.end(), std::back_inserter(rows),
                 [&](const TableRow* row) { return row->key.scenario == scenario; });
    cells.push_back(scenario_cell(rows));
  }
  return cells;
}

std::vector<Line> lines_of(const Rows& rows) {
  std::vector<Rows> groups;
  for (const TableRow* row : rows) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const Rows& other) { return same_observer(other.front()->key, row->key); });
    if (group == groups.end()) {
      groups.push_back({row});
    } else {
      group->push_back(row);
    }
  }
  std::vector<Line> lines;
  std::transform(groups.begin(), groups.end(), std::back_inserter(lines), make_line);
  std::stable_sort(lines.begin(), lines.end(), stands_before);
  return lines;
}

std::vector<std::string> scenarios_of(const Rows& rows) {
  std::vector<std::string> scenarios;
  for (const TableRow* row : rows) {
    if (std::find(scenarios.begin(), scenarios.end(), row->key.scenario) == scenarios.end()) {
      scenarios.push_back(row->key.scenario);
    }
  }
  return scenarios;
}

// A scenario that is about observers of its own says nothing about the others: what counts is what ran in two scenarios
// at least, in those scenarios in which two of these did.
Rows comparable(const Rows& rows) {
  Rows often;
  for (const Line& line : lines_of(rows)) {
    if (scenarios_of(line.rows).size() > 1) often.insert(often.end(), line.rows.begin(), line.rows.end());
  }
  Rows shared;
  for (const TableRow* row : rows) {
    const auto another = [&](const TableRow* other) {
      return other->key.scenario == row->key.scenario && !same_observer(other->key, row->key);
    };
    const bool counts = std::find(often.begin(), often.end(), row) != often.end();
    if (counts && std::any_of(often.begin(), often.end(), another)) shared.push_back(row);
  }
  return shared;
}

TableBlock summary_block(const CellKey& set, const std::vector<Line>& lines,
                         const std::vector<std::string>& scenarios) {
  TableBlock block{on_one_line("summary: " + set_name(set)),
                   {{"observer", "", false}, {"profile", "", false}, {"rank"}, {"falls"}}};
  for (const std::string& scenario : scenarios) block.columns.push_back({scenario, "mm"});
  block.fixed_columns = 4;
  for (const Line& line : lines) {
    if (line.oracle && !block.rows.empty() && block.rules.empty()) block.rules.push_back(block.rows.size());
    block.rows.push_back(cells_of(line, scenarios));
  }
  return block;
}

}  // namespace

std::vector<TableBlock> summary_blocks(const std::vector<TableRow>& rows) {
  std::vector<Rows> sets;
  for (const TableRow& row : rows) {
    const auto set = std::find_if(sets.begin(), sets.end(),
                                  [&](const Rows& other) { return same_set(other.front()->key, row.key); });
    if (set == sets.end()) {
      sets.push_back({&row});
    } else {
      set->push_back(&row);
    }
  }
  std::vector<TableBlock> blocks;
  for (const Rows& whole : sets) {
    const Rows set = comparable(whole);
    const std::vector<Line> lines = lines_of(set);
    const std::vector<std::string> scenarios = scenarios_of(set);
    if (lines.size() > 1 && scenarios.size() > 1) blocks.push_back(summary_block(set.front()->key, lines, scenarios));
  }
  return blocks;
}

std::vector<std::string> summary_legend() {
  return {
      "summary: over all variants of a scenario, \"k/n a / b\": k of n runs fell (left out when none did); a: CoM max, "
      "b: foot max, medians over the seeds, each of its worst variant in which a run survived. !: some runs could not "
      "be run. rank: mean over scenarios and variants. Sorted by the share of runs lost, then by rank; oracles below "
      "the rule. Observers of one scenario only are left out."};
}

}  // namespace dob
