#include "results/figure_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/data_directory.h"

namespace dob::figure_robot_test {
namespace {

constexpr int kFromTheRight = 1, kFromAbove = 2;

double area(const std::vector<std::array<double, 2>>& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& a = p[i];
    const auto& b = p[(i + 1) % p.size()];
    sum += 0.5 * (a[0] * b[1] - b[0] * a[1]);
  }
  return sum;
}

TEST(Outline, OfATiltedBoxIsExact) {
  const CollisionShape box{CollisionShape::Kind::kBox, Vec3(0.2, 0.5, 0.2), Vec3::Zero(), Mat3::Identity()};
  const Mat3 tilted = Eigen::AngleAxisd(0.25 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix();
  const auto corners = outline(box, tilted, Vec3(1.0, 2.0, 3.0), kFromTheRight);
  EXPECT_EQ(corners.size(), 4U);  // a square on its corner
  EXPECT_NEAR(area(corners), 0.04, 1e-12);
  double top = 0.0;
  for (const auto& c : corners) top = std::max(top, c[1]);
  EXPECT_NEAR(top, 3.0 + 0.1 * std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(area(outline(box, Mat3::Identity(), Vec3::Zero(), kFromAbove)), 0.1, 1e-12);
}

TEST(Outline, OfACylinderIsARectangleFromTheSideAndRoundFromItsEnd) {
  const CollisionShape cylinder{CollisionShape::Kind::kCylinder, Vec3(0.1, 0.6, 0.0), Vec3::Zero(), Mat3::Identity()};
  EXPECT_NEAR(area(outline(cylinder, Mat3::Identity(), Vec3::Zero(), kFromTheRight)), 0.12, 1e-12);
  const double circle = 0.01 * std::numbers::pi;
  EXPECT_NEAR(area(outline(cylinder, Mat3::Identity(), Vec3::Zero(), kFromAbove)), circle, 0.01 * circle);
}

TEST(Outline, OfASphereIsACircleHoweverItIsTurned) {
  const CollisionShape sphere{CollisionShape::Kind::kSphere, Vec3(0.1, 0.0, 0.0), Vec3(0.0, 0.0, 1.0),
                              Mat3::Identity()};
  const Mat3 turned = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix();
  for (const auto& p : outline(sphere, turned, Vec3::Zero(), kFromTheRight)) {
    EXPECT_NEAR(std::hypot(p[0] - 1.0, p[1]), 0.1, 1e-12);
  }
}

TEST(RobotFigure, StandsOnTheGroundWithItsCentreOfMassAboveTheOrigin) {
  const Figure figure = robot_figure("f", {scenario_file("undisturbed"), scenario_file("case1")});
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_EQ(figure.panels[0].title, "from the right");
  EXPECT_EQ(figure.subtitle, "dogbot, 21.3 kg; axes x red, y green, z blue");
  double lowest = 1.0;
  for (const FigureLine& line : figure.panels[0].lines) {
    if (line.mark != FigureMark::kFill) continue;
    lowest = std::min(lowest, *std::min_element(line.y.begin(), line.y.end()));
  }
  EXPECT_NEAR(lowest, 0.0, 1e-9);
  const FigureLine& com = figure.panels[0].lines.back();
  EXPECT_NEAR(com.x[0], 0.0, 1e-9);
  EXPECT_GT(com.y[0], 0.3);
}

TEST(RobotFigure, OfARunWithTwoRobotsShowsEach) {
  const Figure figure = robot_figure("f", {scenario_file("undisturbed"), scenario_file("quad12_undisturbed")});
  EXPECT_EQ(figure.subtitle, "dogbot, 21.3 kg; quad12, 12.8 kg; axes x red, y green, z blue");
  ASSERT_EQ(figure.panels.size(), 4U);
  EXPECT_EQ(figure.panels[2].title, "the robot of quad12_undisturbed, from the right");
  EXPECT_NEAR(figure.panels[2].lines.back().y[0], 0.28, 1e-9);  // its CoM
  EXPECT_NEAR(figure.panels[0].lines.back().y[0], 0.40, 1e-9);
}

}  // namespace
}  // namespace dob::figure_robot_test
