// Where the parts of a figure stand on the page. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/figure.h"

namespace dob {

inline constexpr double kFigureWidthPt = 238.0;  // 84 mm

struct PlacedText {
  double x = 0.0, y = 0.0;  // [pt] left end, from the figure's lower left corner
  std::string text;
};

struct PlacedKey {
  double x = 0.0, y = 0.0;  // [pt] left end of the sample
  std::string label;
  const FigureLine* line = nullptr;  // or one of the bands
  const FigureBand* band = nullptr;
};

struct PlacedPanel {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;  // [pt] of the plot itself
  bool x_numbers = true;                                    // numbers and name below the axis
  bool y_names = true;                                      // numbers, or names, beside it
};

struct FigureLayout {
  double height_pt = 0.0;
  std::vector<PlacedText> subtitle;  // its lines
  std::vector<PlacedKey> key;        // one for each label and each kind of band
  std::vector<PlacedPanel> panels;   // of the figure's
};

inline constexpr double kKeySamplePt = 14.0;

FigureLayout layout(const Figure& figure);

}  // namespace dob
