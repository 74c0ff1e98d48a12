// A figure as plain data: panels with lines, ready to be drawn by whatever draws (results/figure_gnuplot.h).
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dob {

// How a line is drawn: colour, dash and point tell observers apart, each alone.
struct FigureLook {
  std::string colour = "#000000";  // #RRGGBB
  std::vector<double> dash;        // lengths of stroke, gap, stroke, ... in widths of the line; empty: solid
  int point = 7;                   // gnuplot's number: circle, square, ...
  double width = 1.0;              // of the line, 1 is 0.75 pt
};

enum class FigureMark { kLine, kPoints, kLinePoints, kFill };

// Interrupts a line.
inline constexpr double kFigureGap = std::numeric_limits<double>::quiet_NaN();

struct FigureLine {
  std::string label;  // for the legend; "": not in it
  FigureLook look;
  FigureMark mark = FigureMark::kLine;
  std::vector<double> x, y;        // equally long
  std::optional<double> ended_at;  // [x] where it ends before its time, with a fall: drawn as a cross and a dashed end
};

// A stretch of the x axis, shaded over the height of the panel.
struct FigureBand {
  double from = 0.0, to = 0.0;
  bool disturbance = false;  // else a swing
};

struct FigureTick {
  double at = 0.0;
  std::string text;
};

struct FigureText {
  double x = 0.0, y = 0.0;
  std::string text;
};

struct FigureArrow {
  std::array<double, 2> from{}, to{};
  std::string colour;
};

struct FigurePanel {
  std::string title;  // behind the letter
  std::string x_axis, y_axis;
  std::array<double, 2> x_range{}, y_range{};  // x may descend
  bool log_x = false;
  bool equal_axes = false;          // one unit is as long along y as along x: decides the height
  double height_pt = 0.0;           // 0: as the layout has it
  std::vector<FigureTick> x_ticks;  // names instead of numbers
  std::vector<FigureTick> y_ticks;
  std::vector<FigureBand> bands;  // behind the lines
  std::vector<FigureLine> lines;  // the first one at the bottom
  std::vector<FigureText> texts;
  std::vector<FigureArrow> arrows;
};

struct Figure {
  std::string id;
  std::string subtitle;            // what is shown: scenario, observer, profile, gains, planner, seed
  std::vector<std::string> cells;  // the same, one each
  std::vector<std::string> notes;  // what is missing in it
  int columns = 1;
  std::vector<FigurePanel> panels;  // row by row
};

}  // namespace dob
