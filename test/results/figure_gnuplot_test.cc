#include "results/figure_gnuplot.h"

#include <array>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::figure_gnuplot_test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

Figure one_line(const std::string& label, std::vector<double> y) {
  Figure figure{"f", {}, {}, {}, 1, {}};
  figure.panels.emplace_back();
  figure.panels[0].x_range = figure.panels[0].y_range = {0.0, 10.0};
  FigureLine line;
  line.label = label;
  line.y = std::move(y);
  for (std::size_t i = 0; i < line.y.size(); ++i) line.x.push_back(static_cast<double>(i));
  figure.panels[0].lines = {line};
  return figure;
}

struct Quoted {
  const char* text;
  const char* quoted;
};

TEST(GnuplotQuoted, NothingEndsTheTextBeforeItsEnd) {
  constexpr std::array kTexts{
      Quoted{"a_b@c^{d}", R"q("a_b\100c^{d}")q"},
      Quoted{"it's; system('x')", R"q("it\047s; system(\047x\047)")q"},
      Quoted{"a\"b\\ `c` $d", R"q("a\042b\134 \140c\140 \044d")q"},
      Quoted{"two\nlines\r\t", R"q("two lines  ")q"},
  };
  for (const Quoted& q : kTexts) EXPECT_EQ(gnuplot_quoted(q.text), q.quoted);
}

TEST(GnuplotFiles, AGapInALineIsABlankLine) {
  const GnuplotFiles files = gnuplot_files(one_line("a", {1, std::numeric_limits<double>::quiet_NaN(), 3}), {});
  EXPECT_EQ(files.data, "# (a) \"a\"\n0 1\n\n2 3\n");
}

TEST(GnuplotFiles, AnAxisMayDescend) {
  Figure figure = one_line("a", {1, 2});
  figure.panels[0].x_range = {10.0, 0.0};
  const GnuplotFiles files = gnuplot_files(figure, {});
  EXPECT_THAT(files.script, HasSubstr("set xrange [10:0] noextend"));
  EXPECT_THAT(files.script, HasSubstr("set xtics 2 "));
}

TEST(GnuplotFiles, NamesStandInThePlaceOfNumbersOnEitherAxis) {
  Figure figure = one_line("a", {1, 2});
  figure.panels[0].x_ticks = {{0.0, "mild"}, {1.0, "har\"d"}};
  EXPECT_THAT(gnuplot_files(figure, {}).script, HasSubstr(R"(set xtics ("mild" 0, "har\042d" 1) )"));
}

TEST(GnuplotFiles, AFilledAreaIsAnAreaInTheLegend) {
  Figure figure = one_line("many", {1, 2, 1});
  figure.panels[0].lines[0].mark = FigureMark::kFill;
  figure.panels[0].lines[0].look.colour = "#123456";
  EXPECT_THAT(gnuplot_files(figure, {}).script, ContainsRegex("set object rect from .* fc rgb '#123456'"));
}

TEST(GnuplotFiles, AreTheSameForTheSameFigure) {
  for (const FigureFormat format : {FigureFormat::kSvg, FigureFormat::kPdf, FigureFormat::kPng}) {
    const GnuplotFiles a = gnuplot_files(one_line("a", {1, 2}), format);
    const GnuplotFiles b = gnuplot_files(one_line("a", {1, 2}), format);
    EXPECT_EQ(a.script, b.script);
    std::string output = "set output 'f.";
    output += to_string(format);
    EXPECT_THAT(a.script, HasSubstr(output));
  }
}

TEST(GnuplotFiles, ANewLineInANameStaysInItsComment) {
  const GnuplotFiles files = gnuplot_files(one_line("a\n1 2", {5}), {});
  EXPECT_EQ(files.data, "# (a) \"a 1 2\"\n0 5\n");
}

}  // namespace
}  // namespace dob::figure_gnuplot_test
