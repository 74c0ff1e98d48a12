#include "results/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/campaign_samples.h"
#include "test/results/figure_samples.h"

namespace dob::figures_test {
namespace {

using std::pair;
using test::FigureRun;
using test::key;
using ::testing::HasSubstr;
using ::testing::Not;

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

TEST(Figures, ThoseOfACampaignAreListedWithTheirBlocks) {
  const std::vector<CampaignFigure> figures = campaign_figures(test::map_result(), {});
  const std::string index = figure_index(made_figures(figures), FigureFormat::kPdf, "dir");
  EXPECT_THAT(index, HasSubstr("| - | [map01.pdf](map01.pdf) | Share of falls, case1/tip_lateral, gains paper"));
  EXPECT_THAT(index, Not(HasSubstr("Not drawn")));
}

TEST(Figures, NoTextBreaksTheTableOfTheIndex) {
  FigureSpec spec;
  spec.id = "f";
  spec.caption = "a | b\n<script>";
  const std::string index = figure_index({{&spec, {}, "c | d"}}, FigureFormat::kSvg, "dir");
  EXPECT_THAT(index, HasSubstr("| - | f | a \\| b \\<script> | c \\| d |"));
}

}  // namespace
}  // namespace dob::figures_test
