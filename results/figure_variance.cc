#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "results/figure_campaign_parts.h"

namespace dob {
namespace {

constexpr double kBarPt = 10.0, kHalfShare = 0.32;
constexpr const char* kBar = "#8FC0E2";
constexpr const char* kResidual = "#D5DADF";

FigureLine bar(const VarianceShare& share, double y) {
  FigureLine line;
  line.look.colour = share.factor == "residual" ? kResidual : kBar;
  line.mark = FigureMark::kFill;
  const double x = 100.0 * share.share;
  line.x = {0.0, x, x, 0.0, 0.0};
  line.y = {y - kHalfShare, y - kHalfShare, y + kHalfShare, y + kHalfShare, y - kHalfShare};
  return line;
}

FigurePanel panel_of(const FactorialResult& result) {
  FigurePanel panel;
  panel.title = result.response;
  panel.x_axis = "share of the variance [%]";
  const auto n = static_cast<double>(result.shares.size());
  panel.y_range = {0.5 - std::max(1.0, n), 0.5};
  panel.height_pt = kBarPt * std::max(1.0, n);
  FigureLine intervals;
  intervals.look = {.colour = "#111111", .dash = {}, .point = 1, .width = 0.8};
  double highest = 0.0;
  for (const VarianceShare& share : result.shares) {
    const double y = -static_cast<double>(panel.y_ticks.size());
    panel.y_ticks.push_back({y, share.factor});
    panel.lines.push_back(bar(share, y));
    highest = std::max(highest, 100.0 * share.share);
    if (!share.interval) continue;
    intervals.x.insert(intervals.x.end(), {100.0 * share.interval->low, 100.0 * share.interval->high, kFigureGap});
    intervals.y.insert(intervals.y.end(), {y, y, kFigureGap});
    highest = std::max(highest, 100.0 * share.interval->high);
  }
  panel.lines.push_back(std::move(intervals));
  panel.x_range = {0.0, std::clamp(1.05 * highest, 1.0, 102.0)};
  return panel;
}

}  // namespace

Figure variance_figure(const CampaignResult& result) {
  Figure figure;
  figure.subtitle = result.campaign.name + ": sums of squares between the levels over the total; lines: 95 %";
  figure.cells = {result.campaign.name};
  for (const FactorialResult& response : result.factorial) {
    figure.subtitle += fmt::format("; {} of {} trials", response.response, response.trials);
    if (response.left_out > 0) figure.subtitle += fmt::format(", {} left out", response.left_out);
    figure.panels.push_back(panel_of(response));
  }
  return figure;
}

}  // namespace dob
