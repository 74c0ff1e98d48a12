// Cells of a run on their way into a figure.
#include "results/figure_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/figure_samples.h"

namespace dob::figure_data_test {
namespace {

using std::pair;
using test::FigureRun;
using test::key;
using test::trace_of;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TimeFigureTest : public ::testing::Test {
 protected:
  FigureRun files;
  FigureSet set{{test::quantity({"x"})}, {}};
  FigureSpec spec;

  TimeFigureTest() {
    spec.id = "f";
    spec.cells = {"case1/knee"};
    spec.observers = {"momentum", "none"};
    spec.panels.emplace_back();
    spec.panels[0].quantity = "q";
  }

  static Trace trace(float value, std::size_t rows = 200) {
    return trace_of(rows, pair("x", [value](float t) { return value + t; }));
  }

  Figure draw(const FigureRequest& request = {}) {
    FigureCells cells(files.dir(), files.run, request);
    return time_figure(set, spec, cells);
  }
  std::string error(const FigureRequest& request = {}) {
    return test::store_error([&] { draw(request); });
  }
};

TEST_F(TimeFigureTest, ALineIsTheColumnOfTheTrace) {
  files.add(test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01), trace(1.0F));
  files.add(test::survived(key("case1", "knee", "none", "-", 1), 0.01), trace(2.0F));
  const Figure figure = draw();
  ASSERT_EQ(figure.panels.size(), 1U);
  ASSERT_EQ(figure.panels[0].lines.size(), 2U);
  const FigureLine& line = figure.panels[0].lines[1];
  EXPECT_EQ(line.label, "none");
  const Trace none = trace(2.0F);
  ASSERT_EQ(line.y.size(), none.rows());
  for (std::size_t i = 0; i < none.rows(); ++i) EXPECT_EQ(line.y[i], 1000.0 * none.columns[1][i]);
  EXPECT_TRUE(figure.notes.empty());
  EXPECT_THAT(figure.subtitle, HasSubstr("momentum@tuned"));
}

TEST_F(TimeFigureTest, ShowsTheTunedProfileUnlessAnotherIsWishedFor) {
  spec.observers = {"momentum"};
  files.add(test::survived(key("case1", "knee", "momentum", "paper", 1), 0.01), trace(1.0F));
  files.add(test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01), trace(2.0F));
  EXPECT_FLOAT_EQ(static_cast<float>(draw().panels[0].lines[0].y[0]), 2000.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(draw({.profile = "paper"}).panels[0].lines[0].y[0]), 1000.0F);
  EXPECT_THAT(error({.profile = "matched"}), HasSubstr("--profile matched: the run has paper, tuned"));
  EXPECT_THAT(error({.observers = {"kalman"}}), HasSubstr("--observer kalman: the run has momentum"));
}

TEST_F(TimeFigureTest, ShowsTheFirstScenarioThatTheRunHasAndItsFirstSeed) {
  spec.cells = {"case9", "case1/knee"};
  spec.observers = {"momentum"};
  files.add(test::survived(key("case1", "knee", "momentum", "tuned", 4), 0.01), trace(4.0F));
  files.add(test::survived(key("case1", "knee", "momentum", "tuned", 3), 0.01), trace(3.0F));
  EXPECT_FLOAT_EQ(static_cast<float>(draw().panels[0].lines[0].y[0]), 3000.0F);
}

TEST_F(TimeFigureTest, WhatIsMissingIsANoteAndWithoutAnythingTheReason) {
  files.add(test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01), trace(1.0F));
  EXPECT_THAT(draw().notes, ElementsAre(HasSubstr("case1/knee, none: not part of the run with profile tuned")));
  spec.observers = {"none"};
  EXPECT_THAT(error(), HasSubstr("not part of the run"));
  files.add(test::failed(key("case1", "knee", "none", "-", 1), "crash: signal 11"));
  EXPECT_THAT(error(), HasSubstr("could not be run: crash: signal 11"));
  files.run.cells.pop_back();
  EXPECT_THAT(error(), HasSubstr("has not been run yet"));
  files.run.cells.push_back(test::survived(key("case1", "knee", "none", "-", 1), 0.01));
  EXPECT_THAT(error(), HasSubstr("--keep"));
}

TEST_F(TimeFigureTest, ADamagedOrOlderTraceIsNamed) {
  spec.observers = {"momentum"};
  const CellResult& cell = files.add(test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01),
                                     trace_of(9, pair("y", [](float) { return 1; })));
  EXPECT_THAT(error(), AllOf(HasSubstr("no column 'x'"), HasSubstr(cell.trace)));
  std::filesystem::resize_file(files.dir() / cell.trace, 40);
  EXPECT_THAT(error(), HasSubstr(cell.trace));
}

TEST_F(TimeFigureTest, AFallIsMarkedAndItsLastSecondDoesNotStretchTheRange) {
  spec.observers = {"momentum"};
  const Trace blows_up = trace_of(300, pair("x", [](float t) { return t < 2.5F ? 0.01F : 1.0F; }));
  files.add(test::fell(key("case1", "knee", "momentum", "tuned", 1), 3.0, 0.01), blows_up);
  const FigurePanel panel = draw().panels[0];
  EXPECT_EQ(panel.lines[0].ended_at, 3.0);
  EXPECT_NEAR(panel.y_range[1], 10.6, 1e-3);
  spec.panels[0].time_s = {0.0, 1.0};
  EXPECT_EQ(draw().panels[0].lines[0].ended_at, std::nullopt);  // not in what is shown
}

TEST_F(TimeFigureTest, EachObserverMayHaveAPanelOfItsOwnWithTheSameRanges) {
  spec.panels[0].each_observer = true;
  files.add(test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01), trace(1.0F));
  files.add(test::survived(key("case1", "knee", "none", "-", 1), 0.01), trace(2.0F));
  const Figure figure = draw();
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_EQ(figure.panels[1].title, "none");
  EXPECT_EQ(figure.panels[0].y_range, figure.panels[1].y_range);
}

}  // namespace
}  // namespace dob::figure_data_test
