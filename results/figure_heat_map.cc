#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "results/figure_campaign_parts.h"

namespace dob {
namespace {

constexpr std::size_t kMostNames = 7;  // of levels along an axis; more would run into each other
constexpr double kPanelPt = 84.0;

// A value above `bound` of the class before and up to its own.
struct ColourClass {
  double bound = 0.0;
  std::string label, colour;
};

// From white to a dark orange red, even in lightness, and from white to a dark blue.
constexpr std::array kFallColours{"#FFFFFF", "#FDE3CF", "#FBC199", "#F29A62", "#DD6F2D", "#B84A00", "#6E2B00"};
constexpr std::array kErrorColours{"#EAF3FA", "#C3DDF0", "#8FC0E2", "#4F9BCC", "#1F72AE", "#0B4A7F", "#052A4C"};

std::vector<ColourClass> fall_classes() {
  return {{0.0, "0 %", kFallColours[0]},     {0.2, "to 20 %", kFallColours[1]},
          {0.4, "to 40 %", kFallColours[2]}, {0.6, "to 60 %", kFallColours[3]},
          {0.8, "to 80 %", kFallColours[4]}, {0.9999, "below 100 %", kFallColours[5]},
          {1.0, "100 %", kFallColours[6]}};
}

// 1, 2 or 5 times a power of ten: the smallest that is not below x > 0.
double nice_above(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= x * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

// [m], each twice as high as the one before or so; the highest ones where there would be too many.
std::vector<ColourClass> error_classes(const CampaignBlock& block) {
  std::vector<double> bounds;
  for (const CurveResult* curve : block.curves) {
    for (const LevelResult& level : curve->levels) {
      if (level.com_error_m && *level.com_error_m > 0.0) bounds.push_back(nice_above(*level.com_error_m));
    }
  }
  if (bounds.empty()) return {};
  const auto [least, most] = std::minmax_element(bounds.begin(), bounds.end());
  std::vector<double> ladder{*least};
  while (ladder.back() < *most * (1.0 - 1e-9)) ladder.push_back(nice_above(1.5 * ladder.back()));
  if (ladder.size() > kErrorColours.size()) ladder.erase(ladder.begin(), ladder.end() - kErrorColours.size());
  std::vector<ColourClass> classes;
  for (std::size_t i = 0; i < ladder.size(); ++i) {
    const std::size_t colour = i * (kErrorColours.size() - 1) / std::max<std::size_t>(1, ladder.size() - 1);
    classes.push_back({ladder[i], fmt::format("to {:g} mm", 1e3 * ladder[i]), kErrorColours[colour]});
  }
  return classes;
}

std::optional<double> value_of(const LevelResult& level, HeatMapValue value) {
  if (level.trials == 0) return std::nullopt;
  if (value == HeatMapValue::kComError) return level.com_error_m;
  return static_cast<double>(level.falls) / level.trials;
}

void add_square(FigureLine& line, const std::array<int, 2>& level) {
  const double x = level[0], y = level[1];
  if (!line.x.empty()) {
    line.x.push_back(std::nan(""));
    line.y.push_back(std::nan(""));
  }
  line.x.insert(line.x.end(), {x - 0.5, x + 0.5, x + 0.5, x - 0.5, x - 0.5});
  line.y.insert(line.y.end(), {y - 0.5, y - 0.5, y + 0.5, y + 0.5, y - 0.5});
}

std::vector<FigureTick> level_names(const CampaignAxis& axis) {
  const std::size_t every = (axis.levels.size() + kMostNames - 1) / kMostNames;
  std::vector<FigureTick> ticks;
  for (std::size_t i = 0; i < axis.levels.size(); ++i) {
    ticks.push_back({static_cast<double>(i), i % every == 0 ? fmt::format("{:.3g}", axis.levels[i]) : ""});
  }
  return ticks;
}

std::array<double, 2> rim_to_rim(const CampaignAxis& axis) {
  return {-0.5, static_cast<double>(axis.levels.size()) - 0.5};
}

FigurePanel empty_panel(const CampaignAxis& across, const CampaignAxis& up, const std::string& title) {
  FigurePanel panel;
  panel.title = title;
  panel.x_axis = axis_name(across);
  panel.x_range = rim_to_rim(across);
  panel.y_range = rim_to_rim(up);
  panel.x_ticks = level_names(across);
  panel.y_ticks = level_names(up);
  panel.height_pt = kPanelPt;
  return panel;
}

std::size_t class_of(double value, const std::vector<ColourClass>& classes) {
  const auto is_in = [&](const ColourClass& c) { return value <= c.bound * (1.0 + 1e-9); };
  const auto found = std::find_if(classes.begin(), classes.end(), is_in);
  return std::min(static_cast<std::size_t>(found - classes.begin()), classes.size() - 1);
}

// All classes are in every panel, so that the legend has them in their order; then the crosses.
void add_empty_lines(FigurePanel& panel, const std::vector<ColourClass>& classes, HeatMapValue value) {
  for (const ColourClass& one : classes) {
    FigureLine& line = panel.lines.emplace_back();
    line.label = one.label;
    line.look.colour = one.colour;
    line.mark = FigureMark::kFill;
  }
  FigureLine& crosses = panel.lines.emplace_back();
  crosses.label = value == HeatMapValue::kFalls ? "not run" : "none survived, or not run";
  crosses.look = {.colour = "#777777", .dash = {}, .point = 2, .width = 1.0};
  crosses.mark = FigureMark::kPoints;
}

void add_squares(FigurePanel& panel, const CurveResult& curve, const std::vector<ColourClass>& classes,
                 HeatMapValue value) {
  add_empty_lines(panel, classes, value);
  std::map<std::array<int, 2>, double> values;
  for (const LevelResult& level : curve.levels) {
    if (const std::optional<double> v = value_of(level, value)) values[level.level] = *v;
  }
  for (int x = 0; x < static_cast<int>(panel.x_ticks.size()); ++x) {
    for (int y = 0; y < static_cast<int>(panel.y_ticks.size()); ++y) {
      const auto found = values.find({x, y});
      if (found != values.end() && !classes.empty()) {
        add_square(panel.lines[class_of(found->second, classes)], found->first);
      } else {
        panel.lines.back().x.push_back(x);
        panel.lines.back().y.push_back(y);
      }
    }
  }
}

}  // namespace

Figure heat_map_figure(const Campaign& campaign, const CampaignBlock& block, HeatMapValue value) {
  const CampaignAxis& across = campaign.axes.at(static_cast<std::size_t>(block.axes.at(0)));
  const CampaignAxis& up = campaign.axes.at(static_cast<std::size_t>(block.axes.at(1)));
  const std::vector<ColourClass> classes = value == HeatMapValue::kFalls ? fall_classes() : error_classes(block);
  const std::vector<CurveLook> looks = curve_looks(block);
  Figure figure;
  figure.columns = 2;
  figure.cells = {fmt::format("{}: {}", campaign.name, block_name(block, campaign))};
  figure.subtitle = fmt::format("{}; upwards: {}", figure.cells.front(), axis_name(up));
  for (std::size_t i = 0; i < block.curves.size(); ++i) {
    figure.panels.push_back(empty_panel(across, up, looks[i].label));
    add_squares(figure.panels.back(), *block.curves[i], classes, value);
  }
  return figure;
}

}  // namespace dob
