#include "results/figure_style.h"

#include <array>

namespace dob {
namespace {

const std::vector<double> kSolid{}, kDashed{5, 2}, kDotted{2, 2}, kDashDot{6, 2, 1.5, 2}, kLongDash{9, 2};

const std::map<std::string, FigureLook>& own_looks() {
  static const std::map<std::string, FigureLook> looks{
      {"none", {"#777777", kDotted, 2}},
      {"momentum", {"#0072B2", kSolid, 7}},
      {"com_wrench", {"#E69F00", kDashed, 9}},
      {"nonlinear_dob", {"#009E73", kDashDot, 5}},
      {"momentum_com", {"#D55E00", kLongDash, 13}},
      {"oracle_full", {"#000000", kDashed, 1}},
  };
  return looks;
}

// Six colours, five dashes, nine points: dashes start anew with each round of the colours, one further on, so that 30
// observers differ in colour or dash and 18 in colour or point.
FigureLook other_look(std::size_t number) {
  static const std::array<std::string, 6> colours{"#CC79A7", "#56B4E9", "#B8A900", "#8C564B", "#4C4C9D", "#66A61E"};
  static const std::array<std::vector<double>, 5> dashes{kSolid, kDashed, kDashDot, kDotted, kLongDash};
  static const std::array<int, 9> points{11, 6, 4, 8, 10, 12, 3, 14, 15};
  const std::size_t colour = number % colours.size(), round = number / colours.size();
  return {colours[colour], dashes[(colour + round) % dashes.size()], points[number % points.size()]};
}

}  // namespace

std::map<std::string, FigureLook> observer_looks(const std::vector<std::string>& observers) {
  std::map<std::string, FigureLook> looks = own_looks();
  std::size_t others = 0;
  for (const bool with_options : {false, true}) {  // NAME:key=value: many of them must not take the others' looks
    for (const std::string& observer : observers) {
      if (looks.contains(observer) || with_options != (observer.find(':') != std::string::npos)) continue;
      looks[observer] = other_look(others++);
    }
  }
  return looks;
}

FigureLook numbered_look(std::size_t number) {
  static const std::array<FigureLook, 5> looks{{{"#0072B2", kSolid, 7},
                                                {"#E69F00", kDashed, 9},
                                                {"#009E73", kDashDot, 5},
                                                {"#CC79A7", kDotted, 13},
                                                {"#4C4C9D", kLongDash, 11}}};
  return looks[number % looks.size()];
}

FigureLook truth_look() {
  return {.colour = "#000000", .dash = {}, .point = 1, .width = 1.6};
}

}  // namespace dob
