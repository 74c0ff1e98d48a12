#include "results/figure_summary.h"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/figure_samples.h"

namespace dob::figure_summary_test {
namespace {

using test::FigureRun;
using test::key;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const FigureLine& line_of(const FigurePanel& panel, const std::string& label) {
  return *std::find_if(panel.lines.begin(), panel.lines.end(), [&](const FigureLine& l) { return l.label == label; });
}

TEST(ErrorsFigure, ShowsTheMedianOfThoseThatSurvivedAndTheShareThatFell) {
  FigureRun files;
  for (const double error : {0.001, 0.002, 0.009}) {
    files.add(test::survived(key("case1", "knee", "momentum", "tuned", static_cast<int>(1e3 * error)), error));
  }
  files.add(test::fell(key("case1", "tip", "momentum", "tuned", 1), 3.0, 0.5));
  files.add(test::survived(key("case1", "knee", "momentum", "paper", 1), 0.7));
  files.add(test::survived(key("order_study", "", "other", "tuned", 1), 0.7));
  const FigureCells cells(files.dir(), files.run, {});
  FigureSpec spec;
  spec.leave_out = {"order_study"};
  const Figure figure = errors_figure(spec, cells);
  ASSERT_EQ(figure.panels.size(), 3U);
  EXPECT_THAT(line_of(figure.panels[0], "momentum").x, ElementsAre(2.0));
  EXPECT_THAT(line_of(figure.panels[2], "momentum").x, ElementsAre(25.0));
  ASSERT_EQ(figure.panels[0].y_ticks.size(), 1U);
  EXPECT_EQ(figure.panels[0].y_ticks[0].text, "case1");
}

TEST(ErrorsFigure, ShowsEachScenarioWithItsOwnGainsUnlessSomeAreWishedFor) {
  FigureRun files;
  const auto add = [&files](const char* scenario, const char* gains, double error) {
    CellKey cell = key(scenario, "knee", "momentum", "tuned", 1);
    cell.gains = gains;
    files.add(test::survived(cell, error));
  };
  add("mine", "own", 0.001);
  add("case1", "stiff", 0.002);
  add("case1", "paper", 0.003);
  const FigureCells cells(files.dir(), files.run, {});
  EXPECT_EQ(cells.request().gains, "own, paper");
  EXPECT_THAT(line_of(errors_figure({}, cells).panels[0], "momentum").x, ElementsAre(1.0, 3.0));
  FigureRequest stiff;
  stiff.gains = "stiff";
  const FigureCells wished(files.dir(), files.run, stiff);
  EXPECT_EQ(wished.request().gains, "stiff");
  EXPECT_THAT(line_of(errors_figure({}, wished).panels[0], "momentum").x, ElementsAre(2.0));
  FigureRequest none;
  none.gains = "soft";
  EXPECT_THAT(test::store_error([&] { FigureCells(files.dir(), files.run, none); }),
              HasSubstr("--gains soft: the run has"));
}

TEST(ErrorsFigure, NeedsACell) {
  FigureRun files;
  files.run.info.cells = {key("case1", "knee", "momentum", "tuned", 1)};
  const FigureCells cells(files.dir(), files.run, {});
  EXPECT_THAT(test::store_error([&] { errors_figure({}, cells); }), HasSubstr("has been run"));
}

class SurvivalFigure : public ::testing::Test {
 protected:
  FigureRun files;

  void add(CellResult cell, double amplitude_N) {
    const std::string name = "s" + std::to_string(files.run.cells.size());
    std::filesystem::create_directories(files.dir() / "scenarios");
    std::ofstream(files.dir() / "scenarios" / (name + ".toml"))
        << "[[disturbance]]\namplitude_N = " << std::fixed << amplitude_N << "\n";
    files.add(std::move(cell));
    files.run.info.sources.push_back({name, ""});
  }
};

TEST_F(SurvivalFigure, CountsWhoSurvivedAtEachAmplitude) {
  add(test::survived(key("sweep", "a", "momentum", "tuned", 1), 0.01), 20.0);
  add(test::survived(key("sweep", "b", "momentum", "tuned", 1), 0.01), 40.0);
  add(test::fell(key("sweep", "b", "momentum", "tuned", 2), 3.0, 0.01), 40.0);
  const Figure figure = survival_figure({}, FigureCells(files.dir(), files.run, {}));
  ASSERT_EQ(figure.panels.size(), 1U);
  EXPECT_EQ(figure.panels[0].title, "sweep");
  EXPECT_THAT(figure.panels[0].lines[0].x, ElementsAre(20.0, 40.0));
  EXPECT_THAT(figure.panels[0].lines[0].y, ElementsAre(100.0, 50.0));
}

TEST_F(SurvivalFigure, OverridesOfTheAmplitudeMakeOneCurveAndOthersAnother) {
  for (const double amplitude : {20.0, 40.0}) {
    for (const char* other : {"", "; sim.dt_s=0.002"}) {
      CellResult cell = test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01);
      cell.key.overrides = "disturbance.0.amplitude_N=" + std::to_string(amplitude) + other;
      add(std::move(cell), amplitude);
    }
  }
  const Figure figure = survival_figure({}, FigureCells(files.dir(), files.run, {}));
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_EQ(figure.panels[0].title, "case1");
  EXPECT_EQ(figure.panels[1].title, "case1, sim.dt_s=0.002");
}

TEST_F(SurvivalFigure, OneAmplitudeIsNotEnough) {
  add(test::survived(key("case1", "knee", "momentum", "tuned", 1), 0.01), 20.0);
  add(test::survived(key("case3", "", "momentum", "tuned", 1), 0.01), 80.0);
  const FigureCells cells(files.dir(), files.run, {});
  EXPECT_THAT(test::store_error([&] { survival_figure({}, cells); }), HasSubstr("several amplitudes"));
}

}  // namespace
}  // namespace dob::figure_summary_test
