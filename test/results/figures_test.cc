#include "results/figures.h"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/figure_samples.h"

namespace dob {
namespace {

using std::pair;
using test::FigureRun;
using test::key;
using ::testing::HasSubstr;
using ::testing::Not;

Figure one_line(const std::string& label, std::vector<double> y) {
  Figure figure;
  figure.id = "f";
  figure.panels.emplace_back();
  figure.panels[0].x_range = figure.panels[0].y_range = {0.0, 10.0};
  FigureLine line;
  line.label = label;
  line.y = std::move(y);
  for (std::size_t i = 0; i < line.y.size(); ++i) line.x.push_back(static_cast<double>(i));
  figure.panels[0].lines = {line};
  return figure;
}

TEST(GnuplotQuoted, NothingEndsTheTextBeforeItsEnd) {
  EXPECT_EQ(gnuplot_quoted("a_b@c^{d}"), R"("a_b\100c^{d}")");
  EXPECT_EQ(gnuplot_quoted("it's; system('x')"), R"q("it\047s; system(\047x\047)")q");
  EXPECT_EQ(gnuplot_quoted("a\"b\\ `c` $d"), R"q("a\042b\134 \140c\140 \044d")q");
  EXPECT_EQ(gnuplot_quoted("two\nlines\r\t"), R"("two lines  ")");
}

TEST(GnuplotFiles, AGapInALineIsABlankLine) {
  const GnuplotFiles files = gnuplot_files(one_line("a", {1, std::numeric_limits<double>::quiet_NaN(), 3}), {});
  EXPECT_EQ(files.data, "# (a) \"a\"\n0 1\n\n2 3\n");
}

TEST(GnuplotFiles, AreTheSameForTheSameFigure) {
  for (const FigureFormat format : {FigureFormat::kSvg, FigureFormat::kPdf, FigureFormat::kPng}) {
    const GnuplotFiles a = gnuplot_files(one_line("a", {1, 2}), format);
    const GnuplotFiles b = gnuplot_files(one_line("a", {1, 2}), format);
    EXPECT_EQ(a.script, b.script);
    EXPECT_THAT(a.script, HasSubstr("set output 'f." + to_string(format)));
  }
}

TEST(GnuplotFiles, ANewLineInANameStaysInItsComment) {
  const GnuplotFiles files = gnuplot_files(one_line("a\n1 2", {5}), {});
  EXPECT_EQ(files.data, "# (a) \"a 1 2\"\n0 5\n");
}

TEST(Figures, WhatIsMissingIsListedWithTheReason) {
  FigureRun run;
  run.add(test::survived(key("case6", "", "momentum", "tuned", 1), 0.01),
          test::trace_of(50, pair("com_error_m", [](float t) { return t; })));
  FigureCells cells(run.dir(), run.run, {});
  const FigureSet set = load_figures(paper_figures_file());
  const std::vector<MadeFigure> made = make_figures(set, cells);
  EXPECT_EQ(made.size(), set.figures.size());
  const std::string index = figure_index(made, FigureFormat::kSvg, run.dir());
  EXPECT_THAT(index, HasSubstr("| 20 | [fig20.svg](fig20.svg) |"));
  EXPECT_THAT(index, HasSubstr("case6 momentum@tuned gains paper planner spline seed 1"));
  EXPECT_THAT(index, HasSubstr("| 5 | fig05 |"));
  EXPECT_THAT(index, HasSubstr("case1/knee_lateral or case1/tip_lateral: not part of the run"));
  EXPECT_THAT(index, Not(HasSubstr("(fig05.svg)")));
  EXPECT_THAT(index, HasSubstr("`dobbench report`"));
}

TEST(Figures, ARunWithNothingToDrawIsRefused) {
  FigureRun run;
  run.run.info.cells = {key("case6", "", "momentum", "tuned", 1)};
  FigureCells cells(run.dir(), run.run, {});
  const FigureSet set = load_figures(paper_figures_file());
  EXPECT_THAT(test::store_error([&] { make_figures(set, cells); }), HasSubstr("no figure can be drawn"));
}

TEST(Figures, NoTextBreaksTheTableOfTheIndex) {
  FigureSpec spec;
  spec.id = "f";
  spec.caption = "a | b\n<script>";
  const std::string index = figure_index({{&spec, {}, "c | d"}}, FigureFormat::kSvg, "dir");
  EXPECT_THAT(index, HasSubstr("| - | f | a \\| b \\<script> | c \\| d |"));
}

}  // namespace
}  // namespace dob
