// Cubics, swing trajectory, reference path and planner.
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "controller/motion_planner.h"
#include "test/support/standing_dogbot.h"

namespace dob::motion_test {
namespace {

TEST(Cubic, MeetsItsEndsAndIsItsOwnDerivative) {
  const double T = 0.15;
  const auto at = [&](double t) { return cubic_at(t, T, 1.0, -0.3, 2.0, 0.7); };
  EXPECT_DOUBLE_EQ(at(0.0).p, 1.0);
  EXPECT_DOUBLE_EQ(at(0.0).v, -0.3);
  EXPECT_NEAR(at(T - 1e-12).p, 2.0, 1e-10);
  EXPECT_NEAR(at(T - 1e-12).v, 0.7, 1e-9);
  const double h = 1e-6;
  for (const double t : {0.03, 0.07, 0.12}) {
    EXPECT_NEAR((at(t + h).p - at(t - h).p) / (2 * h), at(t).v, 1e-8);
    EXPECT_NEAR((at(t + h).v - at(t - h).v) / (2 * h), at(t).a, 1e-6);
  }
  EXPECT_DOUBLE_EQ(at(T + 0.1).p, 2.0 + 0.07);
}

TEST(SwingTrajectory, LiftsByTheStepHeightAndLandsBelowTheGround) {
  SwingTrajectory swing;
  const SwingOptions options;
  const Vec3 from(0.1, 0.2, 0.028), to(0.15, 0.19, 0.028);
  swing.plan(from, to, 0.115, options);
  EXPECT_TRUE(swing.at(0.0).p.isApprox(from, 1e-12));
  EXPECT_NEAR(swing.at(0.0575).p.z(), 0.028 + 0.05, 1e-12);
  EXPECT_NEAR(swing.at(0.0575).v.z(), 0.0, 1e-12);
  const Motion<Vec3> end = swing.at(0.115);
  EXPECT_TRUE(end.p.isApprox(to - Vec3(0, 0, 0.008), 1e-12));
  EXPECT_NEAR(end.v.head<2>().norm(), 0.0, 1e-12);
  EXPECT_NEAR(swing.at(0.215).p.z(), 0.028 - 0.008 - 0.015, 1e-12);  // late: 0.15 m/s
}

TEST(ReferencePath, OfCaseOneIsAsLongAsItsFiguresSay) {
  const ReferencePath path({{10, 0.12, 0}, {10, 0.12, 0.05}, {5.8, 0.12, 0}, {10, 0.12, -0.05}, {10, 0.12, 0}});
  EXPECT_NEAR(path.length(), 5.496, 1e-12);
  EXPECT_NEAR(path.duration(), 45.8, 1e-12);
  EXPECT_NEAR(path.at(45.8).yaw, 0.0, 1e-12);
  EXPECT_NEAR(path.at(20.0).yaw, 0.5, 1e-12);
  // On the arc: the circle of radius v / yaw rate.
  const Vec2 center(1.2, 0.12 / 0.05);
  for (const double t : {10.0, 13.0, 17.7, 20.0}) EXPECT_NEAR((path.at(t).p - center).norm(), 2.4, 1e-12);
  const double h = 1e-6;
  for (const double t : {3.0, 12.0, 22.0, 30.0}) {
    EXPECT_NEAR(((path.at(t + h).p - path.at(t - h).p) / (2 * h) - path.at(t).v).norm(), 0.0, 1e-8);
  }
}

TEST(ReferencePath, RefusesWhatCannotBeDriven) {
  EXPECT_THROW(ReferencePath({}), std::invalid_argument);
  EXPECT_THROW(ReferencePath({{0.0, 0.1, 0.0}}), std::invalid_argument);
  EXPECT_THROW(ReferencePath({{1.0, std::nan(""), 0.0}}), std::invalid_argument);
}

TEST(ComTrajectory, CubicPiecesAreHermiteSegments) {
  ComTrajectory motion;
  const Vec2 p0(0.1, -0.2), v0(0.3, 0.1), p1(0.15, -0.1), v1(0.0, 0.5);
  motion.start(p0, v0);
  motion.append_cubic(0.15, p1, v1);
  motion.append_constant_velocity(0.1);
  for (const double t : {0.0, 0.04, 0.1, 0.1499}) {
    const Motion<Vec2> expected = cubic_at<Vec2>(t, 0.15, p0, v0, p1, v1);
    EXPECT_NEAR((motion.at(t).p - expected.p).norm(), 0.0, 1e-14);
    EXPECT_NEAR((motion.at(t).v - expected.v).norm(), 0.0, 1e-13);
    EXPECT_NEAR((motion.at(t).a - expected.a).norm(), 0.0, 1e-11);
  }
  EXPECT_NEAR((motion.at(0.2).p - (p1 + 0.05 * v1)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((motion.at(0.5).p - (p1 + 0.35 * v1)).norm(), 0.0, 1e-14);  // after the end: final velocity
  EXPECT_NEAR(motion.duration(), 0.25, 1e-15);
}

TEST(HeightTrajectory, NeverAsksForMoreThanItsAcceleration) {
  for (const double v : {-1.0, -0.15, 0.0, 0.15, 1.0}) {
    for (const double z : {0.35, 0.40, 0.42}) {
      const HeightTrajectory h = HeightTrajectory::plan(z, v, 0.40, 0.15);
      EXPECT_GE(h.duration, 0.15);
      for (double t = 0.0; t < h.duration; t += 0.001) EXPECT_LE(std::abs(h.at(t).a), 3.0 + 1e-9) << z << " " << v;
      EXPECT_NEAR(h.at(h.duration).p, 0.40, 1e-12);
      EXPECT_NEAR(h.at(h.duration).v, 0.0, 1e-12);
    }
  }
  EXPECT_EQ(HeightTrajectory::plan(0.401, 0.0, 0.40, 0.15).duration, 0.15);  // a small error is mended at once
}

class PlannerTest : public ::testing::Test {
 protected:
  Model model = test::dogbot_model();
  PlannerOptions options;
  GaitOptions gait_options;
  ModelTerms m = test::standing_dogbot(model);

  PlannerTest() { options.kind = PlannerKind::kSpline; }

  GaitState footstep() const {
    GaitState gait;
    gait.footstep_begins = true;
    gait.next_swing = {true, false, false, true};
    return gait;
  }
};

TEST_F(PlannerTest, StandingPoseIsTheNominalOne) {
  EXPECT_NEAR((m.p_com - Vec3(0, 0, 0.40)).norm(), 0.0, 1e-10);
  EXPECT_NEAR((m.foot[0].p - Vec3(0.287, 0.187, 0.028)).norm(), 0.0, 1e-10);
  EXPECT_NEAR((m.foot[3].p - Vec3(-0.287, -0.187, 0.028)).norm(), 0.0, 1e-10);
  EXPECT_GT(m.state.p_WB.z(), 0.40);
}

TEST_F(PlannerTest, CentreOfMassCrossesTheSupportingDiagonalInMidSwing) {
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
  planner.reset(m);
  planner.update(10.0, footstep(), m);
  GaitState later;
  const MotionReference& mid = planner.update(10.0 + 0.15 + 0.0575, later, m);
  EXPECT_NEAR((mid.com.p - Vec3(0.0, 0.0, 0.40)).norm(), 0.0, 1e-12);  // diagonal RF, LH: centre at the origin
  EXPECT_NEAR((mid.com.v - Vec3(0.12, 0.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST_F(PlannerTest, FootholdsAdvanceWithThePathAndAnswerToVelocity) {
  options.footsteps.path_feedback = 0.0;
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
  const auto foothold = [&](double v_y) {
    m.v_c.head<3>() = Vec3(0.12, v_y, 0.0);
    planner.reset(m);
    planner.update(10.0, footstep(), m);
    GaitState lift;
    lift.phase[0] = lift.phase[3] = LegPhase::kSwing;
    lift.lift_off[0] = lift.lift_off[3] = true;
    return planner.update(10.15, lift, m).foothold[0];
  };
  const Vec3 nominal(0.287 + 0.12 * 0.265, 0.187, 0.028);
  EXPECT_NEAR((foothold(0.0) - nominal).norm(), 0.0, 1e-12);
  EXPECT_NEAR((foothold(0.2) - nominal - Vec3(0, 0.02, 0)).norm(), 0.0, 1e-12);
}

TEST_F(PlannerTest, PathFeedbackIsBounded) {
  options.footsteps.path_feedback = 1.0;
  options.footsteps.velocity_feedback = 0.0;
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
  planner.reset(m);
  planner.update(50.0, footstep(), m);  // the path is 6 m ahead
  GaitState lift;
  lift.phase[0] = LegPhase::kSwing;
  lift.lift_off[0] = true;
  EXPECT_NEAR(planner.update(50.15, lift, m).foothold[0].x(), 0.287 + 0.12 * 0.265 + 0.02, 1e-9);
}

// Thrown to the left at 0.3 m/s, the spline planner asks for a ZMP far outside the feet; the ZMP planner keeps it in
// and says which rows decided.
TEST_F(PlannerTest, ZmpPlannerDiffersFromTheSplineWhereTheZmpWouldLeaveTheSupport) {
  m.v_c.head<3>() = Vec3(0.12, 0.3, 0.0);
  const auto smallest_margin = [&](PlannerKind kind) {
    options.kind = kind;
    MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
    planner.reset(m);
    planner.update(10.0, footstep(), m);
    PerLeg<Vec2> feet;
    for (int l = 0; l < kLegs; ++l) feet[l] = m.foot[l].p.head<2>();
    const SupportPolygon stance = support_polygon({true, true, true, true}, feet, 0.03);
    double margin = 1.0;
    for (int k = 1; k < 150; ++k) {
      margin = std::min(margin, stance.margin(zero_moment_point(planner.update(10.0 + 1e-3 * k, {}, m).com)));
    }
    return std::pair(margin, planner.zmp_report().active_rows);
  };
  const auto [spline_margin, spline_rows] = smallest_margin(PlannerKind::kSpline);
  const auto [zmp_margin, zmp_rows] = smallest_margin(PlannerKind::kZmp);
  EXPECT_NEAR(spline_margin, 0.187 - 0.4 / kGravity * (4.0 * 0.3 / 0.15), 0.01);  // Hermite: a_0 = -4 v_0 / T
  EXPECT_GT(zmp_margin, -0.002);                                                  // between two samples
  EXPECT_EQ(spline_rows, 0);
  EXPECT_GE(zmp_rows, 3);
}

// Thrown up as well: the height must not be planned so that the ZMP runs away from under a CoM in free fall.
TEST_F(PlannerTest, PlannedZmpStaysInsideFromTheFirstTickWhateverTheHeight) {
  options.kind = PlannerKind::kZmp;
  m.p_com.z() += 0.02;
  m.v_c.head<3>() = Vec3(0.12, 0.1, 0.16);
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
  planner.reset(m);
  PerLeg<Vec2> feet;
  for (int l = 0; l < kLegs; ++l) feet[l] = m.foot[l].p.head<2>();
  const SupportPolygon stance = support_polygon({true, true, true, true}, feet, 0.03);
  for (int k = 0; k < 150; ++k) {
    const MotionReference& r = planner.update(10.0 + 1e-3 * k, k == 0 ? footstep() : GaitState{}, m);
    EXPECT_GT(stance.margin(zero_moment_point(r.com)), -0.002) << k;
    EXPECT_LE(std::abs(r.com.a.z()), 3.0 + 1e-9);
  }
}

TEST_F(PlannerTest, PaperSplitBringsTheCentreOfMassToTheCentreOfTheFourFeetDuringStance) {
  options.kind = PlannerKind::kPaperSplit;
  m.foot[0].p += Vec3(0.04, 0.0, 0.0);
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
  planner.reset(m);
  planner.update(10.0, footstep(), m);
  const MotionReference& end = planner.update(10.15 - 1e-9, {}, m);
  EXPECT_NEAR((end.com.p.head<2>() - Vec2(0.01, 0.0)).norm(), 0.0, 1e-8);
  EXPECT_EQ(planner.zmp_report().status, QpStatus::kInvalidInput);  // not optimised yet
  GaitState lift;
  lift.phase[0] = lift.phase[3] = LegPhase::kSwing;
  lift.lift_off[0] = lift.lift_off[3] = true;
  planner.update(10.15, lift, m);
  EXPECT_EQ(planner.zmp_report().status, QpStatus::kOptimal);
}

TEST_F(PlannerTest, PaperSplitLevelsTheTrunkByACubicFromItsMeasuredAttitude) {
  options.kind = PlannerKind::kPaperSplit;
  RobotState tilted = m.state;
  tilted.R_WB = Eigen::AngleAxisd(0.1, Vec3::UnitX()).toRotationMatrix();
  model.compute(tilted, m);
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.12, 0.0}}));
  planner.reset(m);
  EXPECT_NEAR((planner.update(10.0, footstep(), m).R_WB - tilted.R_WB).norm(), 0.0, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(planner.update(10.075, {}, m).R_WB).angle(), 0.05, 1e-9);
  EXPECT_NEAR((planner.update(10.15, {}, m).R_WB - Mat3::Identity()).norm(), 0.0, 1e-12);
  // Angular velocity and acceleration are the attitude's derivatives (one axis, so exactly).
  planner.reset(m);
  planner.update(10.0, footstep(), m);
  const double h = 1e-5;
  const MotionReference before = planner.update(10.05 - h, {}, m);
  const MotionReference now = planner.update(10.05, {}, m);
  const MotionReference after = planner.update(10.05 + h, {}, m);
  const Eigen::AngleAxisd turn(Mat3(after.R_WB * before.R_WB.transpose()));
  EXPECT_NEAR((turn.angle() * turn.axis() / (2 * h) - now.omega).norm(), 0.0, 1e-6);
  EXPECT_NEAR(((after.omega - before.omega) / (2 * h) - now.alpha).norm(), 0.0, 1e-6);
}

TEST_F(PlannerTest, StandingGaitBringsTheCentreOfMassOverTheFeetAndStays) {
  options.kind = PlannerKind::kZmp;
  m.p_com += Vec3(0.03, 0.02, 0.0);
  MotionPlanner planner(options, gait_options, ReferencePath({{100.0, 0.0, 0.0}}));
  planner.reset(m);
  GaitState stand;
  stand.pattern.gait = Gait::kStand;
  stand.footstep_begins = true;
  planner.update(0.0, stand, m);
  stand.footstep_begins = false;
  const MotionReference& later = planner.update(3.0, stand, m);
  EXPECT_NEAR((later.com.p - Vec3(0.0, 0.0, 0.4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(later.com.v.norm(), 0.0, 1e-12);
}

// The path waits for a robot that stands, so that neither its heading nor its place run away.
TEST_F(PlannerTest, WhileTheGaitStandsThePathWaits) {
  options.kind = PlannerKind::kZmp;
  const ReferencePath path({{100.0, 0.12, 0.05}});
  MotionPlanner planner(options, gait_options, path);
  planner.reset(m);
  GaitState walk = footstep();
  planner.update(0.0, walk, m);
  walk.footstep_begins = false;
  const Vec2 before = planner.update(1.0, walk, m).path;
  EXPECT_NEAR((before - path.at(1.0).p).norm(), 0.0, 1e-12);
  GaitState stand;
  stand.pattern.gait = Gait::kStand;
  stand.footstep_begins = true;
  planner.update(1.0, stand, m);
  stand.footstep_begins = false;
  const MotionReference& standing = planner.update(9.0, stand, m);
  EXPECT_NEAR((standing.path - before).norm(), 0.0, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(standing.R_WB).angle(), 0.05, 1e-12);
  EXPECT_EQ(standing.omega, Vec3(Vec3::Zero()));
  EXPECT_NEAR((planner.update(10.0, walk, m).path - path.at(2.0).p).norm(), 0.0, 1e-12);
}

TEST_F(PlannerTest, RefusesASamplingThatDoesNotFitTheGait) {
  options.kind = PlannerKind::kZmp;
  options.zmp.sample = 0.001;
  EXPECT_THROW(MotionPlanner(options, gait_options, ReferencePath({{1.0, 0.1, 0.0}})), std::invalid_argument);
}

TEST_F(PlannerTest, RefusesOptionsByName) {
  options.footsteps.path_feedback = 2.0;
  EXPECT_THROW(MotionPlanner(options, gait_options, ReferencePath({{1.0, 0.1, 0.0}})), std::invalid_argument);
}

}  // namespace
}  // namespace dob::motion_test
