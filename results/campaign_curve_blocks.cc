#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/campaign_ranks.h"
#include "results/campaign_table_blocks.h"
#include "results/campaign_text.h"
#include "results/table_cells.h"

namespace dob {
namespace {

const CampaignAxis& axis_of(const CurveResult& curve, const Campaign& campaign) {
  return campaign.axes[static_cast<std::size_t>(curve.curve.axes.at(0))];
}

// Indices of the curves of each block, blocks and curves in the order of the tables.
std::vector<std::vector<std::size_t>> blocks_of(const CampaignResult& result) {
  std::vector<std::vector<std::size_t>> blocks;
  for (std::size_t i = 0; i < result.curves.size(); ++i) {
    const auto own = std::find_if(blocks.begin(), blocks.end(), [&](const std::vector<std::size_t>& block) {
      return same_campaign_block(result.curves[block.front()], result.curves[i]);
    });
    own == blocks.end() ? blocks.push_back({i}) : own->push_back(i);
  }
  return blocks;
}

// Title and the columns that name a row and say its thresholds.
TableBlock begin_block(const CurveResult& first, const CampaignAxis& axis) {
  const CellKey& key = first.curve.key;
  TableBlock block;
  block.title = on_one_line(fmt::format("{}, {}: {}", scenario_name(key), axis_name(axis), set_name(key)));
  block.columns = {
      {"observer", "", false}, {"profile", "", false}, {"rank"}, {"50 % fall", axis.unit}, {"95 %", axis.unit}};
  return block;
}

std::vector<std::string> begin_row(const CurveResult& curve, const std::optional<int>& rank, const CampaignAxis& axis) {
  const CellKey& key = curve.curve.key;
  const std::string place = rank ? std::to_string(*rank) : curve.half ? "bound" : "-";
  return {key.observer, key.profile, place, curve.half ? estimate_cell(*curve.half, axis) : "-",
          curve.half ? interval_cell(*curve.half, axis) : "-"};
}

void add_notes(const CurveResult& curve, const CampaignAxis& axis, std::vector<std::string>& notes) {
  const std::string who = observer_name(curve.curve.key);
  if (curve.errors > 0) notes.push_back(on_one_line(fmt::format("{}: {} could not be run", who, curve.errors)));
  if (curve.non_monotone.empty()) return;
  std::vector<std::string> seeds;
  for (const NonMonotoneSeed& seed : curve.non_monotone) {
    seeds.push_back(fmt::format("seed {} fell at {}, survived {}", seed.seed, three_digits(seed.fell_at),
                                three_digits(seed.survived_at)));
  }
  notes.push_back(on_one_line(fmt::format("{}: not monotone{}: {}", who,
                                          axis.unit.empty() ? "" : " [" + axis.unit + "]", fmt::join(seeds, "; "))));
}

std::vector<std::string> limit_row(const CurveResult& curve, const std::optional<int>& rank, const CampaignAxis& axis) {
  std::vector<std::string> row = begin_row(curve, rank, axis);
  row.push_back(curve.twentieth ? estimate_cell(*curve.twentieth, axis) : "-");
  row.push_back(curve.twentieth ? interval_cell(*curve.twentieth, axis) : "-");
  for (const int count : {curve.trials, curve.falls, curve.errors, curve.seeds}) row.push_back(std::to_string(count));
  row.push_back(std::to_string(curve.non_monotone.size()));
  return row;
}

// "2/8 31.2": falls of trials, then the median CoM max of the survivors [mm].
std::vector<std::string> level_cells(const CurveResult& curve, const CampaignAxis& axis) {
  std::vector<std::string> cells(axis.levels.size(), "-");
  for (const LevelResult& level : curve.levels) {
    std::string& cell = cells[static_cast<std::size_t>(level.level[0])];
    cell = falls_cell(level.falls, level.trials);
    if (level.com_error_m) cell += fmt::format(" {}", three_digits(1e3 * *level.com_error_m));
  }
  return cells;
}

}  // namespace

std::vector<TableBlock> limit_blocks(const CampaignResult& result) {
  const std::vector<std::optional<int>> ranks = campaign_ranks(result);
  std::vector<TableBlock> blocks;
  for (const std::vector<std::size_t>& members : blocks_of(result)) {
    const CampaignAxis& axis = axis_of(result.curves[members.front()], result.campaign);
    TableBlock& block = blocks.emplace_back(begin_block(result.curves[members.front()], axis));
    block.columns.push_back({"5 % fall", axis.unit});
    block.columns.push_back({"95 %", axis.unit});
    for (const char* heading : {"trials", "falls", "errors", "seeds", "not monotone"})
      block.columns.push_back({heading});
    for (const std::size_t i : members) {
      block.rows.push_back(limit_row(result.curves[i], ranks[i], axis));
      add_notes(result.curves[i], axis, block.notes);
    }
  }
  return blocks;
}

std::vector<TableBlock> breakdown_blocks(const CampaignResult& result) {
  const std::vector<std::optional<int>> ranks = campaign_ranks(result);
  std::vector<TableBlock> blocks;
  for (const std::vector<std::size_t>& members : blocks_of(result)) {
    const CampaignAxis& axis = axis_of(result.curves[members.front()], result.campaign);
    TableBlock& block = blocks.emplace_back(begin_block(result.curves[members.front()], axis));
    block.fixed_columns = block.columns.size();
    for (const double level : axis.levels) block.columns.push_back({three_digits(level), axis.unit});
    for (const std::size_t i : members) {
      std::vector<std::string> row = begin_row(result.curves[i], ranks[i], axis);
      const std::vector<std::string> levels = level_cells(result.curves[i], axis);
      row.insert(row.end(), levels.begin(), levels.end());
      block.rows.push_back(std::move(row));
      add_notes(result.curves[i], axis, block.notes);
    }
  }
  return blocks;
}

}  // namespace dob
