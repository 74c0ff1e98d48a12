#include "results/figure_campaign.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/campaign_samples.h"

namespace dob::figure_campaign_test {
namespace {

using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const FigureLine& line_of(const FigurePanel& panel, const std::string& label) {
  const auto named = [&](const FigureLine& line) { return line.label == label; };
  const auto found = std::find_if(panel.lines.begin(), panel.lines.end(), named);
  if (found == panel.lines.end()) throw std::runtime_error("no line " + label);
  return *found;
}

FigurePanel panel_of(const CampaignResult& result, std::size_t panel, std::size_t figure = 0) {
  return campaign_figures(result, {}).at(figure).figure.panels.at(panel);
}

TEST(FallCurves, ShowSharesWithTheirIntervalsOverTheLevel) {
  const std::vector<CampaignFigure> figures = campaign_figures(test::limit_result(), {});
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].spec.id, "limit01");
  EXPECT_EQ(figures[0].figure.id, "limit01");
  EXPECT_THAT(figures[0].spec.caption, HasSubstr("case1/tip_lateral, gains paper, planner spline; amplitude [N]"));
  const FigurePanel& falls = figures[0].figure.panels.at(0);
  EXPECT_TRUE(falls.log_x);
  EXPECT_THAT(line_of(falls, "momentum").y, ElementsAre(0.0, 50.0, 100.0));
  EXPECT_THAT(line_of(falls, "none").y, ElementsAre(0.0, 0.0));
  EXPECT_NEAR(line_of(falls, "none").x[1], 80.0, 12.0);
  EXPECT_LT(line_of(falls, "momentum").x[2], line_of(falls, "none").x[1]) << "side by side";
  const FigureLine& uprights = falls.lines[0];
  ASSERT_THAT(uprights.y, SizeIs(9));
  EXPECT_EQ(uprights.x[3], line_of(falls, "momentum").x[1]);
  EXPECT_NEAR(uprights.y[3], 25.4, 0.05);
  EXPECT_NEAR(uprights.y[4], 74.6, 0.05);
  EXPECT_TRUE(std::isnan(uprights.y[5]));
}

TEST(FallCurves, ShowThresholdsAsBarsThatAreOpenWhereTheTrialsSayNoMore) {
  const FigurePanel lanes = panel_of(test::limit_result(), 1);
  ASSERT_THAT(lanes.lines, SizeIs(5));  // 50 % and 5 % of momentum with their marks; 50 % of none
  EXPECT_EQ(lanes.lines[0].mark, FigureMark::kFill);
  EXPECT_NEAR(lanes.lines[0].x[0], 34.0, 1e-9);
  EXPECT_NEAR(lanes.lines[0].x[1], 47.0, 1e-9);
  EXPECT_THAT(lanes.lines[1].x, Each(40.0));
  EXPECT_NEAR(lanes.lines[2].x[0], lanes.x_range[0], 1e-9) << "reaches the mildest level";
  EXPECT_NEAR(lanes.lines[2].x[1], 35.0, 1e-9);
  EXPECT_THAT(lanes.lines[3].x, ElementsAre(28.0));
  EXPECT_NEAR(lanes.lines[4].x[1], lanes.x_range[1], 1e-9) << "reaches the hardest level; its estimate lies beyond";
  EXPECT_GT(lanes.lines[0].y[0], lanes.lines[2].y[0]);
}

TEST(FallCurves, ShowTheMedianErrorOfThoseThatSurvived) {
  const FigurePanel errors = panel_of(test::limit_result(), 2);
  EXPECT_THAT(line_of(errors, "momentum").y, ElementsAre(DoubleNear(10.0, 1e-9), DoubleNear(30.0, 1e-9)));
  EXPECT_GT(errors.y_range[1], 50.0 * 1.3);
}

TEST(FallCurves, AnAxisThatDescendsRunsFromTheMildestLevelToTheHardest) {
  CampaignResult result = test::limit_result();
  result.campaign.kind = CampaignKind::kBreakdown;
  result.campaign.axes[0].levels = {80.0, 40.0, 20.0};
  const CampaignFigure made = campaign_figures(result, {}).front();
  EXPECT_EQ(made.spec.id, "breakdown01");
  const FigurePanel& lanes = made.figure.panels.at(1);
  EXPECT_GT(lanes.x_range[0], 80.0);
  EXPECT_LT(lanes.x_range[1], 20.0);
  EXPECT_NEAR(lanes.lines[2].x[1], lanes.x_range[0], 1e-9) << "the mildest level has the largest number";
}

TEST(FallCurves, ProfilesOfAnObserverAreToldApart) {
  CampaignResult result = test::limit_result();
  result.curves.push_back(result.curves[0]);
  result.curves.back().curve.key.profile = "paper";
  const FigurePanel falls = panel_of(result, 0);
  const FigureLine& tuned = line_of(falls, "momentum@tuned");
  const FigureLine& paper = line_of(falls, "momentum@paper");
  EXPECT_EQ(tuned.look.colour, paper.look.colour);
  EXPECT_NE(tuned.look.dash, paper.look.dash);
  EXPECT_EQ(line_of(falls, "none").label, "none");
}

TEST(HeatMap, APairOfLevelsIsASquareInTheColourOfItsShareAndACrossWhereNothingRan) {
  const std::vector<CampaignFigure> figures = campaign_figures(test::map_result(), {});
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].spec.id, "map01");
  EXPECT_EQ(figures[1].spec.id, "map01_com");
  const FigurePanel& falls = figures[0].figure.panels.at(0);
  EXPECT_EQ(falls.title, "momentum");
  EXPECT_EQ(falls.x_axis, "delay [ms]");
  EXPECT_THAT(figures[0].figure.subtitle, HasSubstr("upwards: bandwidth [rad/s]"));
  EXPECT_EQ(falls.x_ticks[1].text, "4");
  EXPECT_EQ(falls.y_ticks[1].text, "10");
  EXPECT_THAT(line_of(falls, "0 %").x, ElementsAre(-0.5, 0.5, 0.5, -0.5, -0.5));
  EXPECT_THAT(line_of(falls, "to 40 %").y, Contains(1.5));
  EXPECT_THAT(line_of(falls, "100 %").x, Contains(1.5));
  EXPECT_THAT(line_of(falls, "to 20 %").x, IsEmpty());
  EXPECT_THAT(line_of(falls, "not run").x, ElementsAre(1.0));
  EXPECT_THAT(line_of(falls, "not run").y, ElementsAre(1.0));
}

TEST(HeatMap, ErrorsHaveClassesUpToTheLargest) {
  const FigurePanel errors = panel_of(test::map_result(), 0, 1);
  EXPECT_THAT(line_of(errors, "to 5 mm").x, SizeIs(5));
  EXPECT_THAT(line_of(errors, "to 50 mm").x, SizeIs(5));
  EXPECT_THAT(line_of(errors, "none survived, or not run").x, SizeIs(2));
}

TEST(VarianceShares, AreBarsWithTheirIntervals) {
  const CampaignFigure made = campaign_figures(test::factorial_result(), {}).front();
  EXPECT_EQ(made.spec.id, "factorial");
  const FigurePanel& panel = made.figure.panels.at(0);
  EXPECT_EQ(panel.title, "falls");
  EXPECT_THAT(made.figure.subtitle, HasSubstr("falls of 480 trials, 20 left out"));
  EXPECT_EQ(panel.y_ticks[0].text, "leg estimator");
  EXPECT_THAT(panel.lines[0].x, Contains(61.0));
  EXPECT_NE(panel.lines[1].look.colour, panel.lines[0].look.colour) << "the residual is no factor";
  EXPECT_THAT(panel.lines[2].x, SizeIs(3));
  EXPECT_NEAR(panel.lines[2].x[1], 66.0, 1e-9);
}

TEST(CampaignFigures, ShowWhatIsAskedFor) {
  FigureRequest request;
  request.observers = {"none"};
  request.profile = "tuned";
  const std::vector<CampaignFigure> figures = campaign_figures(test::limit_result(), request);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_THROW(line_of(figures[0].figure.panels[0], "momentum"), std::runtime_error);
  EXPECT_THAT(line_of(figures[0].figure.panels[0], "none").y, Each(0.0));
  request.gains = "stiff";
  EXPECT_THAT(test::store_error([&] { campaign_figures(test::limit_result(), request); }), HasSubstr("has no curve"));
}

}  // namespace
}  // namespace dob::figure_campaign_test
