#include "controller/footstep_plan.h"

#include <gtest/gtest.h>

#include "test/support/standing_dogbot.h"

namespace dob::footstep_plan_test {
namespace {

class FootstepPlanTest : public ::testing::Test {
 protected:
  Model model = test::dogbot_model();
  ModelTerms m = test::standing_dogbot(model);
  FootstepOptions options;
  ReferencePath path{{{100.0, 0.12, 0.0}}};

  void SetUp() override { m.v_c.head<3>() = Vec3(0.12, 0.0, 0.0); }

  GaitState gait(Gait kind, int step) const {
    GaitState state;
    state.pattern.gait = kind;
    if (kind == Gait::kCrawl) {
      state.pattern.stance_duration = 0.5;
      state.pattern.swing_duration = 0.3;
    }
    state.step = step;
    state.footstep_begins = true;
    state.next_swing = swing_legs(kind, step);
    return state;
  }

  Vec2 nominal(int leg) const {
    return {leg < 2 ? options.foot_offset_x : -options.foot_offset_x,
            leg % 2 == 0 ? options.foot_offset_y : -options.foot_offset_y};
  }
};

TEST_F(FootstepPlanTest, TrotBodyInMidSwingIsTheCentreOfTheSupportingDiagonal) {
  m.foot[1].p += Vec3(0.02, -0.01, 0.0);
  const FootstepPlan plan = plan_footsteps(options, path, {.t = 10.0}, gait(Gait::kTrot, 0), m, 1);
  ASSERT_EQ(plan.count, 1);
  EXPECT_NEAR((plan.steps[0].body - Vec2(0.01, -0.005)).norm(), 0.0, 1e-12);
}

TEST_F(FootstepPlanTest, FootstepsOfTheHorizonFollowOneAnother) {
  options.path_feedback = 0.0;
  const FootstepPlan plan = plan_footsteps(options, path, {.t = 10.0}, gait(Gait::kTrot, 0), m, 3);
  ASSERT_EQ(plan.count, 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(plan.steps[k].swings, swing_legs(Gait::kTrot, k));
    if (k > 0) {
      EXPECT_EQ(plan.steps[k].feet, plan.steps[k - 1].footholds);
    }
    // Each footstep of a steady trot carries the body on by speed x footstep period.
    EXPECT_NEAR((plan.steps[k].body - Vec2(0.12 * 0.265 * k, 0.0)).norm(), 0.0, 1e-12) << k;
  }
}

// In a steady crawl every foot is nominal in the middle of its support, so the body that the standing feet tell is the
// path's, whichever foot swings, and a plan of the next footholds keeps it so.
TEST_F(FootstepPlanTest, SteadyCrawlKeepsTheBodyOnThePath) {
  const double speed = 0.05, t = 40.0;
  const ReferencePath slow({{100.0, speed, 0.0}});
  options.velocity_feedback = 0.0;
  for (int step = 0; step < 4; ++step) {
    const GaitState state = gait(Gait::kCrawl, step);
    const double T = state.pattern.footstep_duration(), lift_off = t + state.pattern.stance_duration;
    FootstepStart start{.t = t};
    for (int l = 0; l < kLegs; ++l) {
      int until = 0;
      while (!swing_legs(Gait::kCrawl, step + until)[l]) ++until;
      start.support_mid[l] = lift_off + until * T - 0.5 * state.pattern.support_duration();
      m.foot[l].p.head<2>() = slow.at(start.support_mid[l]).p + nominal(l);
    }
    const FootstepPlan plan = plan_footsteps(options, slow, start, state, m, 3);
    for (int k = 0; k < 3; ++k) {
      const double mid = lift_off + k * T + 0.5 * state.pattern.swing_duration;
      EXPECT_NEAR((plan.steps[k].body - slow.at(mid).p).norm(), 0.0, 1e-9) << step << " " << k;
    }
  }
}

// A crawl that begins on the feet of a trot: what counts is when each foot is nominal, not what the new gait's timing
// would have it be.
TEST_F(FootstepPlanTest, FirstCrawlFootstepsKeepTheBodyOnThePathWhateverGaitPlacedTheFeet) {
  options.velocity_feedback = 0.0;
  const double t = 20.0;
  FootstepStart start{.t = t, .support_mid = {t - 0.06, t + 0.2, t + 0.2, t - 0.06}};
  for (int l = 0; l < kLegs; ++l) m.foot[l].p.head<2>() = path.at(start.support_mid[l]).p + nominal(l);
  const FootstepPlan plan = plan_footsteps(options, path, start, gait(Gait::kCrawl, 0), m, 3);
  for (int k = 0; k < 3; ++k) {
    const double mid = t + 0.5 + 0.8 * k + 0.15;
    EXPECT_NEAR((plan.steps[k].body - path.at(mid).p).norm(), 0.0, 1e-9) << k;
  }
}

TEST_F(FootstepPlanTest, AFootholdBeyondTheLegsReachIsClampedAndSaysSo) {
  EXPECT_FALSE(plan_footsteps(options, path, {.t = 10.0}, gait(Gait::kTrot, 0), m, 1).steps[0].clamped[0]);
  m.v_c.head<2>() = Vec2(0.12, 6.0);  // thrown to the left: velocity feedback asks for 0.6 m
  const Footstep step = plan_footsteps(options, path, {.t = 10.0}, gait(Gait::kTrot, 0), m, 1).steps[0];
  EXPECT_TRUE(step.clamped[0]);
  EXPECT_FALSE(step.clamped[1]);  // does not swing
  // As seen from the hip of the body on its path, the stretched leg reaches the foothold; the wanted one, 0.6 m
  // further, it would not.
  const Vec3& hip = m.link[0][1].p_WL;
  const double length = (m.link[0][2].p_WL - hip).norm() + (m.foot[0].p - m.link[0][2].p_WL).norm();
  const Vec2 from_hip = step.footholds[0] - hip.head<2>() - Vec2(0.12 * 0.265, 0.0);
  // Stretched to max_reach, less what the body moves ahead in half the foot's time on the ground.
  const double reach = std::sqrt(std::pow(options.max_reach * length, 2) - std::pow(hip.z() - 0.028, 2));
  EXPECT_NEAR(from_hip.norm(), reach - 0.5 * 0.12 * 0.415, 1e-9);
}

TEST_F(FootstepPlanTest, StandingAndAnEmptyHorizonPlanNothing) {
  EXPECT_EQ(plan_footsteps(options, path, {.t = 1.0}, gait(Gait::kStand, 0), m, 2).count, 0);
  EXPECT_EQ(plan_footsteps(options, path, {.t = 1.0}, gait(Gait::kTrot, 0), m, 0).count, 0);
}

}  // namespace
}  // namespace dob::footstep_plan_test
