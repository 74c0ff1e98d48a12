#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "results/figure_campaign_parts.h"

namespace dob {
namespace {

constexpr double kAxisMargin = 0.04;  // of the axis, on either side
constexpr double kSpread = 0.26;      // of the smallest step between levels: curves stand side by side in it
constexpr double kLanePt = 9.0;       // [pt] height of an observer among the thresholds
constexpr double kHalfLane = 0.2;     // the thresholds of 50 % stand above the middle of their lane, those of 5 % below
constexpr double kHalfBar = 0.16;     // height of the bars of 50 %
constexpr double kWhisker = 0.6;      // width of a line
constexpr std::size_t kMostLogNames = 7;  // of levels along a logarithmic axis

class FallCurves {
 public:
  FallCurves(const Campaign& campaign, const CampaignBlock& block)
      : axis_(campaign.axes.at(static_cast<std::size_t>(block.axes.at(0)))), block_(block), looks_(curve_looks(block)) {
    const double first = on_scale(axis_.levels.front()), last = on_scale(axis_.levels.back());
    step_ = last - first;
    for (std::size_t i = 1; i < axis_.levels.size(); ++i) {
      const double step = on_scale(axis_.levels[i]) - on_scale(axis_.levels[i - 1]);
      if (std::abs(step) < std::abs(step_)) step_ = step;
    }
    from_ = first - kAxisMargin * (last - first);
    to_ = last + kAxisMargin * (last - first);
  }

  Figure build(const Campaign& campaign) const {
    Figure figure;
    figure.subtitle = fmt::format("{}: {}", campaign.name, block_name(block_, campaign));
    figure.cells = {figure.subtitle};
    figure.panels = {falls(), thresholds(), errors()};
    return figure;
  }

 private:
  double on_scale(double level) const { return axis_.logarithmic ? std::log(level) : level; }
  double off_scale(double x) const { return axis_.logarithmic ? std::exp(x) : x; }

  FigurePanel panel(const std::string& title, const std::string& y_axis) const {
    FigurePanel panel;
    panel.title = title;
    panel.x_axis = axis_name(axis_);
    panel.y_axis = y_axis;
    panel.x_range = {off_scale(from_), off_scale(to_)};
    panel.log_x = axis_.logarithmic;
    if (axis_.logarithmic) panel.x_ticks = level_ticks();
    return panel;
  }

  // Less than a power of ten would have one number, or none.
  std::vector<FigureTick> level_ticks() const {
    const std::size_t every = (axis_.levels.size() + kMostLogNames - 1) / kMostLogNames;
    std::vector<FigureTick> ticks;
    for (std::size_t i = 0; i < axis_.levels.size(); i += every) {
      ticks.push_back({axis_.levels[i], fmt::format("{:.3g}", axis_.levels[i])});
    }
    return ticks;
  }

  // Where a curve has its points of a level, so that none hides another's interval.
  double beside(std::size_t curve, int level) const {
    const auto n = static_cast<double>(looks_.size());
    const double share = (static_cast<double>(curve) + 0.5) / n - 0.5;
    return off_scale(on_scale(axis_.levels.at(static_cast<std::size_t>(level))) + kSpread * step_ * share);
  }

  FigureLine line(std::size_t curve, FigureMark mark, double width) const {
    FigureLine line;
    line.look = looks_[curve].look;
    line.look.width = width;
    line.mark = mark;
    if (mark == FigureMark::kLine) line.look.dash.clear();
    return line;
  }

  // A line through the points and, under it, an upright for each interval.
  template <typename Value, typename Ends>
  void add_curve(FigurePanel& panel, std::size_t curve, Value value, Ends ends) const {
    FigureLine uprights = line(curve, FigureMark::kLine, kWhisker);
    FigureLine points = line(curve, FigureMark::kLinePoints, 1.0);
    points.label = looks_[curve].label;
    for (const LevelResult& level : block_.curves[curve]->levels) {
      const std::optional<double> y = value(level);
      if (!y) continue;
      const double x = beside(curve, level.level[0]);
      points.x.push_back(x);
      points.y.push_back(*y);
      if (const std::optional<Interval> interval = ends(level)) {
        uprights.x.insert(uprights.x.end(), {x, x, kFigureGap});
        uprights.y.insert(uprights.y.end(), {interval->low, interval->high, kFigureGap});
      }
    }
    panel.lines.push_back(std::move(uprights));
    panel.lines.push_back(std::move(points));
  }

  FigurePanel falls() const {
    FigurePanel falls = panel("", "falls [%]");
    falls.y_range = {-6.0, 106.0};
    const auto share = [](const LevelResult& level) {
      return level.trials == 0 ? std::nullopt : std::optional(100.0 * level.falls / level.trials);
    };
    const auto ends = [](const LevelResult& level) {
      return level.falls_ci ? std::optional(Interval{100.0 * level.falls_ci->low, 100.0 * level.falls_ci->high})
                            : std::nullopt;
    };
    for (std::size_t i = 0; i < looks_.size(); ++i) add_curve(falls, i, share, ends);
    return falls;
  }

  FigurePanel errors() const {
    FigurePanel errors = panel("", "CoM error [mm]");
    const auto median = [](const LevelResult& level) {
      return level.com_error_m ? std::optional(1e3 * *level.com_error_m) : std::nullopt;
    };
    const auto ends = [](const LevelResult& level) {
      return level.com_error_ci ? std::optional(Interval{1e3 * level.com_error_ci->low, 1e3 * level.com_error_ci->high})
                                : std::nullopt;
    };
    for (std::size_t i = 0; i < looks_.size(); ++i) add_curve(errors, i, median, ends);
    double highest = 0.0;
    for (const FigureLine& curve : errors.lines) {
      for (const double y : curve.y) highest = std::isfinite(y) ? std::max(highest, y) : highest;
    }
    errors.y_range = {0.0, highest > 0.0 ? 1.08 * highest : 1.0};
    return errors;
  }

  // The part of an interval that the panel shows; one that says no more than "milder" or "harder" runs to the rim.
  Interval shown(const FallThreshold& threshold) const {
    const bool ascends = from_ < to_;
    const bool open_low = ascends ? threshold.below : threshold.above;
    const bool open_high = ascends ? threshold.above : threshold.below;
    return {open_low ? off_scale(std::min(from_, to_)) : within(threshold.interval.low),
            open_high ? off_scale(std::max(from_, to_)) : within(threshold.interval.high)};
  }

  double within(double level) const {
    return off_scale(std::clamp(on_scale(level), std::min(from_, to_), std::max(from_, to_)));
  }

  // An estimate beyond the levels has no mark: the interval runs to the rim.
  bool is_within(double level) const {
    const auto [low, high] = std::minmax(axis_.levels.front(), axis_.levels.back());
    return level >= low && level <= high;
  }

  // A bar, with an upright at the estimate.
  void add_half(FigurePanel& panel, std::size_t curve, double y) const {
    const std::optional<FallThreshold>& threshold = block_.curves[curve]->half;
    if (!threshold) return;
    const auto [low, high] = shown(*threshold);
    FigureLine bar = line(curve, FigureMark::kFill, 1.0);
    bar.x = {low, high, high, low, low};
    bar.y = {y - kHalfBar, y - kHalfBar, y + kHalfBar, y + kHalfBar, y - kHalfBar};
    panel.lines.push_back(std::move(bar));
    if (!is_within(threshold->estimate)) return;
    FigureLine upright;
    upright.look.width = 1.4;
    upright.x = {threshold->estimate, threshold->estimate};
    upright.y = {y - 1.4 * kHalfBar, y + 1.4 * kHalfBar};
    panel.lines.push_back(std::move(upright));
  }

  // A line, with a point at the estimate.
  void add_twentieth(FigurePanel& panel, std::size_t curve, double y) const {
    const std::optional<FallThreshold>& threshold = block_.curves[curve]->twentieth;
    if (!threshold) return;
    const auto [low, high] = shown(*threshold);
    FigureLine interval = line(curve, FigureMark::kLine, 1.0);
    interval.x = {low, high};
    interval.y = {y, y};
    panel.lines.push_back(std::move(interval));
    if (!is_within(threshold->estimate)) return;
    FigureLine point = line(curve, FigureMark::kPoints, 1.0);
    point.x = {threshold->estimate};
    point.y = {y};
    panel.lines.push_back(std::move(point));
  }

  FigurePanel thresholds() const {
    const auto n = static_cast<double>(looks_.size());
    FigurePanel lanes = panel("where 50 % (bars) and 5 % (lines) fall", "");
    lanes.y_range = {0.5 - n, 0.5};
    lanes.height_pt = std::max(14.0, kLanePt * n);
    lanes.y_ticks = {{0.5 - n, ""}};  // no numbers
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      const double y = -static_cast<double>(i);
      add_half(lanes, i, y + kHalfLane);
      add_twentieth(lanes, i, y - kHalfLane);
    }
    return lanes;
  }

  const CampaignAxis& axis_;
  const CampaignBlock& block_;
  std::vector<CurveLook> looks_;
  double from_ = 0.0, to_ = 0.0, step_ = 0.0;  // on the axis' scale; from the mildest level to the hardest
};

}  // namespace

Figure fall_curves_figure(const Campaign& campaign, const CampaignBlock& block) {
  return FallCurves(campaign, block).build(campaign);
}

}  // namespace dob
