#include "controller/support_polygon.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace dob::support_polygon_test {
namespace {

const PerLeg<Vec2> kNominal{Vec2(0.287, 0.187), Vec2(0.287, -0.187), Vec2(-0.287, 0.187), Vec2(-0.287, -0.187)};

TEST(SupportPolygon, OfFourFeetIsTheirRectangle) {
  const SupportPolygon p = support_polygon({true, true, true, true}, kNominal, 0.03);
  EXPECT_EQ(p.edges, 4);
  EXPECT_NEAR(p.margin(Vec2::Zero()), 0.187, 1e-12);
  EXPECT_NEAR(p.margin({0.28, 0.0}), 0.007, 1e-12);
  EXPECT_NEAR(p.margin({0.0, -0.2}), -0.013, 1e-12);
}

TEST(SupportPolygon, OfThreeFeetIsTheirTriangleWhicheverFootIsUp) {
  for (int up = 0; up < kLegs; ++up) {
    PerLeg<bool> stance{true, true, true, true};
    stance[up] = false;
    const SupportPolygon p = support_polygon(stance, kNominal, 0.03);
    EXPECT_EQ(p.edges, 3);
    EXPECT_NEAR(p.margin(Vec2::Zero()), 0.0, 1e-12);  // on the diagonal
    EXPECT_LT(p.margin(0.1 * kNominal[up]), -0.01);
    EXPECT_GT(p.margin(-0.1 * kNominal[up]), 0.01);
  }
}

TEST(SupportPolygon, OfTwoFeetIsTheLineWidenedByTheGivenHalfWidth) {
  const SupportPolygon p = support_polygon({true, false, false, true}, kNominal, 0.03);
  EXPECT_EQ(p.edges, 4);
  EXPECT_NEAR(p.margin(Vec2::Zero()), 0.03, 1e-12);
  const Vec2 along = kNominal[0].normalized();
  const Vec2 across(-along.y(), along.x());
  EXPECT_NEAR(p.margin(0.04 * across), -0.01, 1e-12);
  EXPECT_NEAR(p.margin(along * (kNominal[0].norm() + 0.02)), -0.02, 1e-12);
}

TEST(SupportPolygon, WithoutFeetHoldsNothing) {
  EXPECT_LT(support_polygon({}, kNominal, 0.03).margin(Vec2::Zero()), -1e300);
}

TEST(SupportPolygon, FootInsideTheTriangleOfTheOthersAddsNoEdge) {
  PerLeg<Vec2> feet = kNominal;
  feet[3] = {0.0, 0.05};
  const SupportPolygon p = support_polygon({true, true, true, true}, feet, 0.03);
  EXPECT_EQ(p.edges, 3);
  EXPECT_GT(p.margin(feet[3]), 0.0);
}

// Against membership by barycentric coordinates of the triangles that four points span.
TEST(SupportPolygon, AgreesWithTheUnionOfTrianglesAtRandomPoints) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  const auto in_triangle = [&](const Vec2& x, const Vec2& a, const Vec2& b, const Vec2& c) {
    const double u = cross(b - a, x - a), v = cross(c - b, x - b), w = cross(a - c, x - c);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  };
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    PerLeg<Vec2> f;
    for (Vec2& foot : f) foot = {uniform(random), uniform(random)};
    const Vec2 x{uniform(random), uniform(random)};
    const bool expected = in_triangle(x, f[0], f[1], f[2]) || in_triangle(x, f[0], f[1], f[3]) ||
                          in_triangle(x, f[0], f[2], f[3]) || in_triangle(x, f[1], f[2], f[3]);
    EXPECT_EQ(support_polygon({true, true, true, true}, f, 0.03).margin(x) >= 0.0, expected) << i;
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 200);
}

TEST(SupportPolygon, MoveInsideLeavesInnerPointsAloneAndBringsOthersToTheMargin) {
  const SupportPolygon p = support_polygon({true, true, true, false}, kNominal, 0.03);
  const Vec2 inner(0.1, 0.1);
  ASSERT_GT(p.margin(inner), 0.05);
  EXPECT_EQ(move_inside(p, inner, 0.05), inner);
  for (const Vec2& x : {Vec2(0.0, 0.0), Vec2(-0.2, -0.2), Vec2(0.5, 0.3), Vec2(0.3, -0.3)}) {
    EXPECT_GT(p.margin(move_inside(p, x, 0.05)), 0.05 - 1e-6);
  }
  EXPECT_TRUE(move_inside(p, {3.0, 3.0}, 0.5).allFinite());  // no such point: anything near, but a number
}

}  // namespace
}  // namespace dob::support_polygon_test
