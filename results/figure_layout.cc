#include "results/figure_layout.h"

#include <algorithm>

namespace dob {
namespace {

// [pt]
constexpr double kSubtitleLine = 7.0, kSubtitleCharacter = 3.15;  // text of 5.5 pt
constexpr double kKeyLine = 10.0, kKeyCharacter = 4.6;            // text of 7 pt
constexpr double kTickCharacter = 3.9;                            // text of 7 pt
constexpr double kTitle = 12.0;                                   // above a panel
constexpr double kXNumbers = 9.0, kXName = 9.0;                   // below it
constexpr double kEdge = 5.0, kYName = 10.0, kYNumbers = 17.0, kGap = 8.0;
constexpr double kPanel = 66.0, kPanelOfTwoColumns = 46.0;

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > width) {
    std::size_t end = rest.rfind(' ', width);
    if (end == std::string::npos || end == 0) end = width;
    while (end > 1 && (static_cast<unsigned char>(rest[end]) & 0xC0U) == 0x80U) --end;  // not within a character
    lines.push_back(rest.substr(0, end));
    rest.erase(0, rest[end] == ' ' ? end + 1 : end);
  }
  lines.push_back(rest);
  return lines;
}

bool same_range(const FigurePanel& a, const FigurePanel& b) {
  return a.x_range == b.x_range && a.x_axis == b.x_axis;
}

class Layout {
 public:
  explicit Layout(const Figure& figure)
      : figure_(figure), columns_(std::min(static_cast<std::size_t>(figure.columns), figure.panels.size())) {}

  // From the top down, y negative until the height is known.
  FigureLayout build() {
    y_ = -kEdge;
    place_subtitle();
    place_key();
    for (std::size_t first = 0; first < figure_.panels.size(); first += columns_) place_row(first);
    out_.height_pt = kEdge - y_;
    for (PlacedText& text : out_.subtitle) text.y += out_.height_pt;
    for (PlacedKey& key : out_.key) key.y += out_.height_pt;
    for (PlacedPanel& panel : out_.panels) {
      panel.bottom += out_.height_pt;
      panel.top += out_.height_pt;
    }
    return std::move(out_);
  }

 private:
  void place_subtitle() {
    const auto width = static_cast<std::size_t>((kFigureWidthPt - 2 * kEdge) / kSubtitleCharacter);
    for (const std::string& line : wrapped(figure_.subtitle, width)) {
      y_ -= kSubtitleLine;
      out_.subtitle.push_back({kEdge, y_ + 0.5 * kSubtitleLine, line});
    }
  }

  void add_key(const std::string& label, const FigureLine* line, const FigureBand* band) {
    const auto known = [&](const PlacedKey& key) { return key.label == label; };
    if (label.empty() || std::any_of(out_.key.begin(), out_.key.end(), known)) return;
    out_.key.push_back({0.0, 0.0, label, line, band});
  }

  void place_key() {
    for (const FigurePanel& panel : figure_.panels) {
      for (const FigureLine& line : panel.lines) add_key(line.label, &line, nullptr);
    }
    for (const FigurePanel& panel : figure_.panels) {
      for (const FigureBand& band : panel.bands) add_key(band.disturbance ? "disturbance" : "swing", nullptr, &band);
    }
    if (out_.key.empty()) return;
    y_ -= 2.0;
    double x = kFigureWidthPt;
    for (PlacedKey& key : out_.key) {
      const double width = kKeySamplePt + 3.0 + kKeyCharacter * static_cast<double>(key.label.size()) + 6.0;
      if (x + width > kFigureWidthPt) {
        x = kEdge;
        y_ -= kKeyLine;
      }
      key.x = x;
      key.y = y_ + 0.5 * kKeyLine;
      x += width;
    }
  }

  // Beside the plots of a row: all names of the leftmost ones.
  double left_margin() const {
    std::size_t longest = 0;
    for (const FigureTick& tick : figure_.panels.front().y_ticks) longest = std::max(longest, tick.text.size());
    if (longest > 0) return kEdge + kTickCharacter * static_cast<double>(longest) + 2.0;
    return kEdge + kYNumbers + (columns_ == 1 ? kYName : 0.0);
  }

  bool needs_x_numbers(std::size_t i) const {
    const std::size_t below = i + columns_;
    return below >= figure_.panels.size() || !same_range(figure_.panels[i], figure_.panels[below]);
  }

  void place_row(std::size_t first) {
    const std::size_t end = std::min(first + columns_, figure_.panels.size());
    const bool names = !figure_.panels.front().y_ticks.empty();
    const double gap = names ? kGap : kGap + kYNumbers;
    const double left = left_margin();
    const double width =
        (kFigureWidthPt - kGap - left - gap * static_cast<double>(columns_ - 1)) / static_cast<double>(columns_);
    double height = 0.0;
    bool numbers = false;
    for (std::size_t i = first; i < end; ++i) {
      height = std::max(height, height_of(figure_.panels[i], width));
      numbers = numbers || needs_x_numbers(i);
    }
    y_ -= kTitle + height;
    for (std::size_t i = first; i < end; ++i) {
      const double x = left + static_cast<double>(i - first) * (width + gap);
      out_.panels.push_back({x, x + width, y_, y_ + height, numbers, i == first || !names});
    }
    y_ -= numbers ? kXNumbers : 0.0;
    y_ -= numbers && !figure_.panels[first].x_axis.empty() ? kXName : 0.0;
  }

  double height_of(const FigurePanel& panel, double width) const {
    if (panel.equal_axes) {
      return width * (panel.y_range[1] - panel.y_range[0]) / (panel.x_range[1] - panel.x_range[0]);
    }
    if (panel.height_pt > 0.0) return panel.height_pt;
    return columns_ == 1 ? kPanel : kPanelOfTwoColumns;
  }

  const Figure& figure_;
  std::size_t columns_;
  FigureLayout out_;
  double y_ = 0.0;
};

}  // namespace

FigureLayout layout(const Figure& figure) {
  return Layout(figure).build();
}

}  // namespace dob
