#include "results/campaign_table_blocks.h"

#include <fmt/format.h>

#include "results/campaign_text.h"
#include "results/table_cells.h"

namespace dob {
namespace {

TableBlock map_block(const CurveResult& curve, const CampaignAxis& down, const CampaignAxis& across) {
  const CellKey& key = curve.curve.key;
  TableBlock block;
  block.title = on_one_line(fmt::format("{}: {}: {}: falls/trials, {} down, {} across", scenario_name(key),
                                        observer_name(key), set_name(key), axis_name(down), axis_name(across)));
  block.columns = {{down.name, down.unit}};
  block.fixed_columns = 1;
  for (const double level : across.levels) block.columns.push_back({three_digits(level), across.unit});
  for (const double level : down.levels) {
    block.rows.emplace_back(across.levels.size() + 1, "-");
    block.rows.back()[0] = three_digits(level);
  }
  for (const LevelResult& level : curve.levels) {
    block.rows[static_cast<std::size_t>(level.level[0])][static_cast<std::size_t>(level.level[1]) + 1] =
        falls_cell(level.falls, level.trials);
  }
  if (curve.errors > 0) block.notes.push_back(fmt::format("{} could not be run", curve.errors));
  return block;
}

// Of a share of 1.
std::string percent(double share) {
  return fmt::format("{:.1f}", 100.0 * share);
}

TableBlock factorial_block(const FactorialResult& result) {
  TableBlock block;
  block.title = fmt::format("Share of the variance of {}: {} trials, {} cells left out", result.response, result.trials,
                            result.left_out);
  block.columns = {{"factor", "", false}, {"levels"}, {"share", "%"}, {"95 %", "%"}};
  for (const VarianceShare& share : result.shares) {
    const std::string interval =
        share.interval ? fmt::format("[{}, {}]", percent(share.interval->low), percent(share.interval->high)) : "-";
    block.rows.push_back(
        {share.factor, share.levels == 0 ? "-" : std::to_string(share.levels), percent(share.share), interval});
  }
  if (result.shares.empty()) {
    block.notes.emplace_back(result.trials == 0 ? "no complete part of the design has been run" : "no trial differs");
  }
  return block;
}

std::vector<std::string> threshold_legend() {
  return {
      "50 % fall, 5 % fall: level at which that share of the trials falls, median of its posterior and 95 % interval, "
      "for a logistic share of falls with lapses; < or >: beyond an end of the ladder, where nothing was tried. rank: "
      "a "
      "harder level of 50 % falls first, within the block; rows whose intervals overlap may as well stand in the other "
      "order; bound: an oracle, not ranked. -: no trial."};
}

}  // namespace

std::vector<TableBlock> map_blocks(const CampaignResult& result) {
  std::vector<TableBlock> blocks;
  for (const CurveResult& curve : result.curves) {
    blocks.push_back(map_block(curve, result.campaign.axes[static_cast<std::size_t>(curve.curve.axes.at(0))],
                               result.campaign.axes[static_cast<std::size_t>(curve.curve.axes.at(1))]));
  }
  return blocks;
}

std::vector<TableBlock> factorial_blocks(const CampaignResult& result) {
  std::vector<TableBlock> blocks;
  for (const FactorialResult& response : result.factorial) blocks.push_back(factorial_block(response));
  return blocks;
}

std::vector<TableBlock> campaign_table_blocks(const CampaignResult& result) {
  switch (result.campaign.kind) {
    case CampaignKind::kLimit:
      return limit_blocks(result);
    case CampaignKind::kMap:
      return map_blocks(result);
    case CampaignKind::kBreakdown:
      return breakdown_blocks(result);
    default:
      return factorial_blocks(result);
  }
}

std::vector<std::string> campaign_legend(CampaignKind kind) {
  std::vector<std::string> legend;
  switch (kind) {
    case CampaignKind::kLimit:
      legend = threshold_legend();
      legend.emplace_back(
          "errors: cells that could not be run, in nothing else. not monotone: seeds that fell at a level "
          "and survived a harder one.");
      return legend;
    case CampaignKind::kBreakdown:
      legend = threshold_legend();
      legend.emplace_back("k/n x: k of n trials fell at that level; x: median CoM max of those that survived [mm].");
      return legend;
    case CampaignKind::kMap:
      return {"k/n: k of n trials fell. -: no trial."};
    default:
      return {
          "share: sum of squares between the levels of a factor over the total (eta squared); a x b: what two factors "
          "do "
          "together beyond what each does alone; residual: interactions of more, and those with the seed. 95 %: "
          "bootstrap "
          "over seeds; chance alone makes shares above 0. In log CoM error a fall counts as the largest error of any "
          "survivor. left out: cells without a trial, and levels or seeds that are not complete because of them."};
  }
}

}  // namespace dob
