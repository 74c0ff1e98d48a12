#include "results/figure_gnuplot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "results/figure_layout.h"

namespace dob {
namespace {

constexpr double kKeyFont = 7.0, kTickFont = 7.0, kNameFont = 8.0, kSubtitleFont = 5.5;  // [pt]
constexpr double kPointSize = 0.45, kCrossSize = 0.8;
constexpr double kXTickPt = 27.0, kYTickPt = 13.0;  // room for a number on the axis
constexpr double kStripPart = 0.94;                 // of a panel's height, above which disturbances are marked
constexpr const char* kSwingColour = "#E4E9EE";
constexpr const char* kDisturbanceColour = "#E8A13A";
constexpr const char* kFrameColour = "#444444";
constexpr const char* kFillBorder = "#33414E";

// What differs between the terminals: their units, and what a width of 1 is.
struct Terminal {
  std::string line;
  double font = 1.0;   // its number for a font of 1 pt
  double point = 1.0;  // and for a point of size 1
};

Terminal terminal(FigureFormat format, double height_pt) {
  constexpr double kPx = 96.0 / 72.0;     // svg: pixels of CSS
  constexpr double kDots = 300.0 / 72.0;  // png: 300 dpi, of which gnuplot takes 96 for an inch of text
  constexpr double kFont = 300.0 / 96.0;
  switch (format) {
    case FigureFormat::kSvg:
      return {fmt::format("svg size {:.0f},{:.0f} font 'sans-serif,{:.2f}' linewidth 1 background '#ffffff'",
                          kPx * kFigureWidthPt, kPx * height_pt, kPx * kNameFont),
              kPx, 1.0};
    case FigureFormat::kPdf:
      return {fmt::format("pdfcairo size {:.3f}in,{:.3f}in font 'sans,{:.2f}' fontscale 1 linewidth 1.5",
                          kFigureWidthPt / 72.0, height_pt / 72.0, kNameFont),
              1.0, 0.75};
    case FigureFormat::kPng:
      return {fmt::format("pngcairo size {:.0f},{:.0f} font 'sans,{:.2f}' linewidth {:.3f}", kDots * kFigureWidthPt,
                          kDots * height_pt, kFont * kNameFont, kFont),
              kFont, kFont};
  }
  return {};
}

std::string dash_type(const std::vector<double>& dash) {
  if (dash.empty()) return "solid";
  std::string list;
  for (const double length : dash) list += fmt::format("{}{:g}", list.empty() ? "" : ",", length);
  return "(" + list + ")";
}

// 1, 2 or 5 times a power of ten: no more than `most` steps in the range.
double nice_step(const std::array<double, 2>& range, double most) {
  const double least = std::abs(range[1] - range[0]) / std::max(most, 1.0);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

class Script {
 public:
  Script(const Figure& figure, FigureFormat format)
      : figure_(figure), layout_(layout(figure)), terminal_(terminal(format, layout_.height_pt)) {
    add("# {}: drawn by `dobbench figures`; again, after changes, by: gnuplot {}.gp", figure.id, figure.id);
    add("set terminal {}", terminal_.line);
    add("set output '{}.{}'", figure.id, to_string(format));
    add("set encoding utf8\nset termoption noenhanced\nunset key");
    add("set border 31 lw 0.5 lc rgb '{}'\nset tics scale 0.4 nomirror\nset multiplot", kFrameColour);
  }

  GnuplotFiles build() {
    for (std::size_t i = 0; i < figure_.panels.size(); ++i) add_panel(i);
    add("unset multiplot\nunset output");
    return {std::move(text_), std::move(data_)};
  }

 private:
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  std::string font(double size_pt) const { return fmt::format("font ',{:.2f}'", terminal_.font * size_pt); }
  static std::string at_x(double pt) { return fmt::format("screen {:.4f}", pt / kFigureWidthPt); }
  std::string at_y(double pt) const { return fmt::format("screen {:.4f}", pt / layout_.height_pt); }
  std::string at(double x, double y) const { return at_x(x) + "," + at_y(y); }

  // Subtitle and legend, drawn along with the first panel.
  void add_page() {
    for (const PlacedText& line : layout_.subtitle) {
      add("set label {} at {} left {} tc rgb '#555555'", gnuplot_quoted(line.text), at(line.x, line.y),
          font(kSubtitleFont));
    }
    for (const PlacedKey& key : layout_.key) add_key(key);
  }

  void add_key(const PlacedKey& key) {
    const double end = key.x + kKeySamplePt;
    if (key.band != nullptr) {
      add_key_area(key, key.band->disturbance ? kDisturbanceColour : kSwingColour, "noborder");
    } else if (key.line->mark == FigureMark::kFill) {
      add_key_area(key, key.line->look.colour, fmt::format("border lc rgb '{}' lw 0.5", kFillBorder));
    } else {
      if (key.line->mark != FigureMark::kPoints) {
        add("set arrow from {} to {} nohead {}", at(key.x, key.y), at(end, key.y), line_style(key.line->look));
      }
      if (key.line->mark != FigureMark::kLine) {
        add("set label '' at {} point {}", at(key.x + 0.5 * kKeySamplePt, key.y), point_style(key.line->look));
      }
    }
    add("set label {} at {} left {}", gnuplot_quoted(key.label), at(end + 3.0, key.y), font(kKeyFont));
  }

  void add_key_area(const PlacedKey& key, const std::string& colour, const std::string& border) {
    add("set object rect from {} to {} fc rgb '{}' fs solid {}", at(key.x + 3.0, key.y - 3.0),
        at(key.x + kKeySamplePt, key.y + 3.0), colour, border);
  }

  static std::string line_style(const FigureLook& look) {
    return fmt::format("lc rgb '{}' lw {:g} dt {}", look.colour, look.width, dash_type(look.dash));
  }
  std::string point_style(const FigureLook& look) const {
    return fmt::format("pt {} ps {:.3f} lc rgb '{}' lw 1", look.point, kPointSize * terminal_.point, look.colour);
  }

  void add_panel(std::size_t i) {
    const FigurePanel& panel = figure_.panels[i];
    const PlacedPanel& place = layout_.panels[i];
    const char letter = static_cast<char>('a' + i % 26);
    add("\n# ({}) {}", letter, panel.y_axis.empty() ? panel.x_axis : panel.y_axis);
    add("unset label\nunset arrow\nunset object");
    if (i == 0) add_page();
    add("set lmargin at {}\nset rmargin at {}\nset bmargin at {}\nset tmargin at {}", at_x(place.left),
        at_x(place.right), at_y(place.bottom), at_y(place.top));
    add_axes(panel, place);
    add_titles(panel, place, letter);
    for (const FigureBand& band : panel.bands) {
      add("set object rect from {:.7g}, graph {:g} to {:.7g}, graph 1 fc rgb '{}' fs solid noborder behind", band.from,
          band.disturbance ? kStripPart : 0.0, band.to, band.disturbance ? kDisturbanceColour : kSwingColour);
    }
    for (const FigureText& text : panel.texts) {
      add("set label {} at {:.7g},{:.7g} left front", gnuplot_quoted(text.text), text.x, text.y);
    }
    for (const FigureArrow& arrow : panel.arrows) {
      add("set arrow from {:.7g},{:.7g} to {:.7g},{:.7g} filled size screen 0.015,20 lw 1.5 lc rgb '{}' front",
          arrow.from[0], arrow.from[1], arrow.to[0], arrow.to[1], arrow.colour);
    }
    for (const FigureLine& line : panel.lines) add_end(panel, line);
    add_plot(panel, letter);
  }

  void add_axes(const FigurePanel& panel, const PlacedPanel& place) {
    add("{} logscale x\nset xrange [{:.7g}:{:.7g}] noextend\nset yrange [{:.7g}:{:.7g}] noextend",
        panel.log_x ? "set" : "unset", panel.x_range[0], panel.x_range[1], panel.y_range[0], panel.y_range[1]);
    add_x_ticks(panel, place);
    if (panel.y_ticks.empty()) {
      add("set ytics {:g} format '%g' {} offset 0.6,0", nice_step(panel.y_range, (place.top - place.bottom) / kYTickPt),
          font(kTickFont));
    } else {
      add("set ytics ({}) {} offset 0.6,0", names(panel.y_ticks, place.y_names), font(kTickFont));
    }
  }

  void add_x_ticks(const FigurePanel& panel, const PlacedPanel& place) {
    if (!panel.x_ticks.empty()) {
      add("set xtics ({}) {} offset 0,0.4", names(panel.x_ticks, place.x_numbers), font(kTickFont));
      return;
    }
    const std::string step =
        panel.log_x ? "autofreq" : fmt::format("{:g}", nice_step(panel.x_range, (place.right - place.left) / kXTickPt));
    if (place.x_numbers) {
      add("set xtics {} format '%g' {} offset 0,0.4", step, font(kTickFont));
    } else {
      add("set xtics {} format ''", step);
    }
  }

  static std::string names(const std::vector<FigureTick>& ticks, bool shown) {
    std::string list;
    for (const FigureTick& tick : ticks) {
      fmt::format_to(std::back_inserter(list), "{}{} {:.7g}", list.empty() ? "" : ", ",
                     gnuplot_quoted(shown ? tick.text : std::string()), tick.at);
    }
    return list;
  }

  // In several columns there is no room beside the axes: the values' name stands in the title.
  void add_titles(const FigurePanel& panel, const PlacedPanel& place, char letter) {
    const bool beside = figure_.columns == 1 && !panel.y_axis.empty();
    std::string title = fmt::format("({}) {}", letter, panel.title);
    if (!beside && !panel.y_axis.empty()) title += (panel.title.empty() ? "" : ": ") + panel.y_axis;
    if (figure_.panels.size() == 1) title = panel.title;
    if (!title.empty()) {
      add("set label {} at {} left {}", gnuplot_quoted(title), at(place.left, place.top + 5.0), font(kKeyFont + 0.5));
    }
    if (beside) {
      add("set label {} at {} center rotate by 90 {}", gnuplot_quoted(panel.y_axis),
          at(6.5, 0.5 * (place.bottom + place.top)), font(kNameFont - 0.5));
    }
    if (place.x_numbers && !panel.x_axis.empty()) {
      add("set label {} at {} center {}", gnuplot_quoted(panel.x_axis),
          at(0.5 * (place.left + place.right), place.bottom - 14.5), font(kNameFont - 0.5));
    }
  }

  // A line that ends with a fall: a cross where it ends, or at the rim beyond which it ends, and a dashed vertical.
  void add_end(const FigurePanel& panel, const FigureLine& line) {
    if (!line.ended_at) return;
    double y = panel.y_range[0];
    for (const double value : line.y) y = std::isfinite(value) ? value : y;
    y = std::min(std::max(y, panel.y_range[0]), panel.y_range[1]);
    add("set arrow from {:.7g}, graph 0 to {:.7g}, graph 1 nohead lc rgb '{}' lw 1 dt (3,3)", *line.ended_at,
        *line.ended_at, line.look.colour);
    add("set label '' at {:.7g},{:.7g} point pt 2 ps {:.3f} lw 1.5 lc rgb '{}' front", *line.ended_at, y,
        kCrossSize * terminal_.point, line.look.colour);
  }

  void add_plot(const FigurePanel& panel, char letter) {
    std::string parts;
    for (const FigureLine& line : panel.lines) {
      if (line.x.empty()) continue;
      parts += fmt::format("{}'{}.dat' index {} using 1:2 {}", parts.empty() ? "" : ", \\\n     ", figure_.id, blocks_,
                           style(line));
      add_block(line, letter);
    }
    add("plot {}", parts.empty() ? "NaN notitle" : parts);
  }

  std::string style(const FigureLine& line) const {
    switch (line.mark) {
      case FigureMark::kPoints:
        return "with points " + point_style(line.look);
      case FigureMark::kLinePoints:
        return fmt::format("with linespoints {} pt {} ps {:.3f}", line_style(line.look), line.look.point,
                           kPointSize * terminal_.point);
      case FigureMark::kFill:
        return fmt::format("with filledcurves closed fc rgb '{}' fs solid border lc rgb '{}' lw 0.6", line.look.colour,
                           kFillBorder);
      case FigureMark::kLine:
        break;
    }
    return "with lines " + line_style(line.look);
  }

  // Two blank lines part the blocks, one blank line interrupts a line.
  void add_block(const FigureLine& line, char letter) {
    if (blocks_++ > 0) data_ += "\n\n";
    std::string label = gnuplot_quoted(line.label);
    fmt::format_to(std::back_inserter(data_), "# ({}) {}\n", letter, label);
    bool gap = true;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      if (std::isfinite(line.x[i]) && std::isfinite(line.y[i])) {
        fmt::format_to(std::back_inserter(data_), "{:.6g} {:.5g}\n", line.x[i], line.y[i]);
        gap = false;
      } else if (!gap) {
        data_ += '\n';
        gap = true;
      }
    }
    while (data_.size() >= 2 && data_.ends_with("\n\n")) data_.pop_back();
  }

  const Figure& figure_;
  FigureLayout layout_;
  Terminal terminal_;
  std::string text_, data_;
  int blocks_ = 0;
};

}  // namespace

std::string to_string(FigureFormat format) {
  switch (format) {
    case FigureFormat::kSvg:
      return "svg";
    case FigureFormat::kPdf:
      return "pdf";
    case FigureFormat::kPng:
      return "png";
  }
  return "";
}

GnuplotFiles gnuplot_files(const Figure& figure, FigureFormat format) {
  return Script(figure, format).build();
}

// Not in single quotes: of '' at the beginning of a string gnuplot 5.4 makes an empty one.
std::string gnuplot_quoted(const std::string& text) {
  constexpr std::string_view kSpecial = "\"'\\`$@";
  std::string quoted = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      quoted += ' ';
    } else if (kSpecial.find(c) != std::string_view::npos) {
      fmt::format_to(std::back_inserter(quoted), "\\{:03o}", c);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace dob
