#include "results/figure_style.h"

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace dob::figure_style_test {
namespace {

// The colours that the report page's source gives observers by name.
std::map<std::string, std::string> colours_of_the_page() {
  std::ifstream in(std::string(DOB_SOURCE_DIR) + "/results/report/src/colors.ts");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::map<std::string, std::string> colours;
  const std::regex entry("\n  (\\w+): \"(#[0-9A-F]{6})\"");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), entry); it != std::sregex_iterator(); ++it) {
    colours[(*it)[1]] = (*it)[2];
  }
  return colours;
}

TEST(ObserverLooks, HaveTheColoursOfTheReportPage) {
  const std::map<std::string, std::string> page = colours_of_the_page();
  EXPECT_GE(page.size(), 5U);
  const auto looks = observer_looks({});
  for (const auto& [name, colour] : page) EXPECT_EQ(looks.at(name).colour, colour) << name;
}

TEST(ObserverLooks, OfTheOthersFollowTheirOrder) {
  const auto looks = observer_looks({"none", "momentum", "kalman", "com_wrench", "eso"});
  EXPECT_EQ(looks.at("none").colour, "#777777");
  EXPECT_EQ(looks.at("momentum").colour, "#0072B2");
  EXPECT_EQ(looks.at("com_wrench").colour, "#E69F00");
  EXPECT_EQ(looks.at("nonlinear_dob").colour, "#009E73");
  EXPECT_EQ(looks.at("momentum_com").colour, "#D55E00");
  EXPECT_EQ(looks.at("oracle_full").colour, "#000000");
  EXPECT_EQ(looks.at("kalman").colour, "#CC79A7");  // the others in their order
  EXPECT_EQ(looks.at("eso").colour, "#56B4E9");
}

TEST(ObserverLooks, OfAnObserverWithOptionsTakeNoOthersLook) {
  const auto looks = observer_looks({"momentum:gains=6.28", "kalman"});
  EXPECT_EQ(looks.at("kalman").colour, "#CC79A7");
  EXPECT_EQ(looks.at("momentum:gains=6.28").colour, "#56B4E9");
}

TEST(ObserverLooks, OfAsManyObserversAsThereAreDifferAsLinesAndAsPoints) {
  std::vector<std::string> names;
  for (char name = 'a'; name < 'a' + 18; ++name) names.emplace_back(1, name);
  const auto looks = observer_looks(names);
  std::set<std::pair<std::string, std::vector<double>>> lines;
  std::set<std::pair<std::string, int>> points;
  for (const auto& [name, look] : looks) {
    EXPECT_TRUE(lines.emplace(look.colour, look.dash).second) << name;
    EXPECT_TRUE(points.emplace(look.colour, look.point).second) << name;
  }
}

TEST(NumberedLooks, DifferInColourAndDash) {
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_NE(numbered_look(a).colour, numbered_look(b).colour);
      EXPECT_NE(numbered_look(a).dash, numbered_look(b).dash);
    }
  }
}

}  // namespace
}  // namespace dob::figure_style_test
