#include "results/campaign_text.h"

#include <cmath>

#include <fmt/format.h>

#include "results/table_cells.h"

namespace dob {
namespace {

bool rising(const CampaignAxis& axis) {
  return axis.levels.back() > axis.levels.front();
}

// A level of the threshold, and on which side of an end of the ladder it is.
std::string level_cell(double level, const FallThreshold& threshold, const CampaignAxis& axis) {
  const bool milder = threshold.below && level == axis.levels.front();
  const bool harder = threshold.above && level == axis.levels.back();
  const char* side = milder ? (rising(axis) ? "< " : "> ") : harder ? (rising(axis) ? "> " : "< ") : "";
  return fmt::format("{}{}", side, three_digits(level));
}

}  // namespace

std::string kind_name(CampaignKind kind) {
  switch (kind) {
    case CampaignKind::kLimit:
      return "limit";
    case CampaignKind::kMap:
      return "map";
    case CampaignKind::kBreakdown:
      return "breakdown";
    default:
      return "factorial";
  }
}

std::string three_digits(double x) {
  const double size = std::abs(x);
  if (size >= 1e6) return fmt::format("{:.3g}", x);
  return x == std::floor(x) || size >= 100.0 ? fmt::format("{:.0f}", x) : fmt::format("{:.3g}", x);
}

std::string estimate_cell(const FallThreshold& threshold, const CampaignAxis& axis) {
  return level_cell(threshold.estimate, threshold, axis);
}

std::string interval_cell(const FallThreshold& threshold, const CampaignAxis& axis) {
  const Interval& interval = threshold.interval;
  if (interval.low == interval.high) return level_cell(interval.low, threshold, axis);
  return fmt::format("[{}, {}]", level_cell(interval.low, threshold, axis), level_cell(interval.high, threshold, axis));
}

std::string falls_cell(int falls, int trials) {
  return trials == 0 ? "-" : fmt::format("{}/{}", falls, trials);
}

std::string axis_name(const CampaignAxis& axis) {
  return axis.unit.empty() ? axis.name : fmt::format("{} [{}]", axis.name, axis.unit);
}

std::string campaign_heading(const CampaignResult& result) {
  int trials = 0, falls = 0, errors = 0;
  for (const CurveResult& curve : result.curves) {
    trials += curve.trials;
    falls += curve.falls;
    errors += curve.errors;
  }
  const Campaign& campaign = result.campaign;
  return on_one_line(fmt::format("{} {}{}{}: {} trials of {} planned cells, {} fell{}", kind_name(campaign.kind),
                                 campaign.name, campaign.summary.empty() ? "" : ": ", campaign.summary, trials,
                                 result.planned, falls,
                                 errors == 0 ? "" : fmt::format(", {} could not be run", errors)));
}

}  // namespace dob
