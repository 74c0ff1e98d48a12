#include <utility>

#include <fmt/format.h>

#include "results/data_values.h"
#include "results/table_cells.h"
#include "results/table_formats.h"
#include "results/verification.h"

namespace dob {
namespace {

constexpr std::size_t kNamed = 20;  // cells that are not equal, for readers
constexpr Reproduced kVerdicts[]{Reproduced::kEqual, Reproduced::kDifferent, Reproduced::kFlipped,
                                 Reproduced::kNotVerified};

TableBlock counts_block(const Verification& v) {
  const std::size_t n = v.cells.size();
  const std::string sample = n == v.finished ? "" : fmt::format(" (a sample, seed {})", v.seed);
  TableBlock block{fmt::format("{}: {} of {} finished cells computed again{}", v.dir, n, v.finished, sample),
                   {{"verdict", "", false}, {"cells"}}};
  for (const Reproduced verdict : kVerdicts) {
    block.rows.push_back({std::string(to_string(verdict)), std::to_string(v.count(verdict))});
  }
  if (v.finished < v.planned) {
    block.notes.push_back(fmt::format("{} of {} planned cells are not finished", v.planned - v.finished, v.planned));
  }
  if (!v.across.empty()) block.notes.push_back("across programs or code paths: " + on_one_line(v.across));
  return block;
}

TableBlock cells_block(const Verification& v) {
  TableBlock block{"Not equal",
                   {{"scenario", "", false},
                    {"observer", "", false},
                    {"set", "", false},
                    {"seed"},
                    {"verdict", "", false},
                    {"what", "", false}}};
  std::size_t more = 0;
  for (const VerifiedCell& cell : v.cells) {
    if (cell.verdict == Reproduced::kEqual) continue;
    if (cell.verdict == Reproduced::kDifferent && !v.across.empty()) continue;  // the spreads say how far
    if (block.rows.size() == kNamed) {
      ++more;
      continue;
    }
    block.rows.push_back({scenario_name(cell.key), observer_name(cell.key), on_one_line(set_name(cell.key)),
                          std::to_string(cell.key.seed), std::string(to_string(cell.verdict)),
                          on_one_line(cell.detail)});
  }
  if (more > 0) block.notes.push_back(fmt::format("{} more: --format csv has them all", more));
  return block;
}

std::string relative(double difference) {
  return difference == 0.0 ? "0" : fmt::format("{:.1e}", difference);
}

TableBlock spreads_block(const Verification& v) {
  TableBlock block{
      "Metrics of the cells with the same outcome: largest differences of those that survived, and that fell",
      {{"metric", "", false},
       {"cells"},
       {"different"},
       {"survived, relative"},
       {"fell, relative"},
       {"one has none"},
       {"where the largest is", "", false}}};
  for (const MetricSpread& s : v.spreads) {
    const std::string where =
        s.different == 0 ? "-"
                         : fmt::format("{}, {}, seed {}", scenario_name(s.where), observer_name(s.where), s.where.seed);
    block.rows.push_back({std::string(s.metric), std::to_string(s.cells), std::to_string(s.different),
                          relative(s.largest), relative(s.largest_fell), std::to_string(s.one_sided), where});
  }
  return block;
}

std::string csv(const Verification& v) {
  std::string out = "scenario,variant,observer,profile,gains,planner,overrides,seed,verdict,detail\n";
  for (const VerifiedCell& cell : v.cells) {
    const CellKey& k = cell.key;
    for (const std::string* text : {&k.scenario, &k.variant, &k.observer, &k.profile, &k.gains, &k.planner}) {
      out += csv_value(*text) + ",";
    }
    out += fmt::format("{},{},{},{}\n", csv_value(k.overrides), k.seed, to_string(cell.verdict),
                       csv_value(on_one_line(cell.detail)));
  }
  return out;
}

}  // namespace

std::string verification_text(const Verification& v, TableFormat format) {
  if (format == TableFormat::kCsv) return csv(v);
  std::vector<TableBlock> blocks{counts_block(v)};
  if (TableBlock cells = cells_block(v); !cells.rows.empty()) blocks.push_back(std::move(cells));
  if (!v.spreads.empty()) blocks.push_back(spreads_block(v));
  const std::vector<std::string> legend{
      "equal: state hash of the whole trajectory, outcome, time, reason, metrics, checkpoints and shadow observers, "
      "bit "
      "for bit (docs/repeatability.md)."};
  return format == TableFormat::kMarkdown ? table_markdown(blocks, legend) : table_text(blocks, legend);
}

}  // namespace dob
