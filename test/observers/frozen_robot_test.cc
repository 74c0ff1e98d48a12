#include "observers/frozen_robot.h"

#include <gtest/gtest.h>

#include "test/support/standing_dogbot.h"

namespace dob::frozen_robot_test {
namespace {

// Every velocity-dependent term that the plant sets, against the model's own at that pose and velocity.
TEST(FrozenRobot, AgreesWithTheModelInEveryTermThatIsLinearInVelocity) {
  const Model model = test::dogbot_model();
  const ModelTerms pose = test::standing_dogbot(model);
  FrozenRobot robot(pose);
  robot.leg_torque.setLinSpaced(-2.0, 3.0);
  robot.com_wrench << 5.0, -3.0, 8.0, 1.0, -2.0, 0.5;
  for (int k = 0; k < 50; ++k) robot.advance(1e-3);
  const ModelTerms& t = robot.terms();
  ModelTerms expected;
  model.compute(t.state, expected);
  const auto same = [](const auto& a, const auto& b) { return (a - b).cwiseAbs().maxCoeff() < 1e-11; };
  EXPECT_TRUE(same(t.rho, expected.rho));
  EXPECT_TRUE(same(t.p_q, expected.p_q));
  EXPECT_TRUE(same(t.p_b, expected.p_b));
  EXPECT_TRUE(same(t.v_c, expected.v_c));
  EXPECT_TRUE(same(t.L, expected.L));
  for (int l = 0; l < kLegs; ++l) {
    EXPECT_TRUE(same(t.foot[l].v, expected.foot[l].v));
    EXPECT_TRUE(same(t.contact[l].v, expected.contact[l].v));
  }
  // The laws it was driven by.
  EXPECT_TRUE(same(expected.rho, 0.05 * robot.leg_torque));
  Vec6 momentum = 0.05 * robot.com_wrench;
  momentum[2] -= 0.05 * pose.mass * kGravity;
  EXPECT_TRUE(same(expected.mass * expected.v_c.head<3>(), momentum.head<3>()));
  EXPECT_TRUE(same(expected.L, momentum.tail<3>()));
}

TEST(FrozenRobot, HandsOverTheModelAtBothEndsOfTheInterval) {
  const ModelTerms pose = test::standing_dogbot(test::dogbot_model());
  FrozenRobot robot(pose);
  robot.leg_torque.setConstant(1.0);
  robot.advance(1e-3);
  const Vec12 before = robot.terms().rho;
  const ObserverInput input = robot.advance(2e-3);
  EXPECT_EQ(input.start.rho, before);
  EXPECT_TRUE((input.now.rho - before - 2e-3 * robot.leg_torque).isZero(1e-15));
  EXPECT_EQ(input.dt, 2e-3);
}

}  // namespace
}  // namespace dob::frozen_robot_test
