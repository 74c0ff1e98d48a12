#include "sim/forward_kinematics.h"

#include <random>

#include <gtest/gtest.h>

#include "robot/model.h"
#include "test/sim/hand_built_robot.h"
#include "test/support/random_state.h"

namespace dob::forward_kinematics_test {
namespace {

TEST(LinkMotions, PutTheFootOfAStraightLegBelowTheHip) {
  const RobotDescription robot = test::hand_built_robot();
  const auto motions = link_motions(robot, RobotState{});
  const LinkMotion& lower = motions[static_cast<std::size_t>(link_index(0, 2))];
  EXPECT_LT((lower.p_WL - Vec3(0.2875, 0.088 + 0.09875, -0.315)).norm(), 1e-15);
  EXPECT_LT((lower.p_com - lower.p_WL - Vec3(0.029, 0.0, -0.1439)).norm(), 1e-15);
}

TEST(LinkMotions, VelocitiesAreTheTimeDerivativesOfThePositions) {
  const RobotDescription robot = test::hand_built_robot();
  std::mt19937_64 random(3);
  const RobotState now = test::random_state(random);
  const double h = 1e-6;
  const auto moved = [&](double t) {
    RobotState state = now;
    state.p_WB += t * now.v_WB;
    state.R_WB = Eigen::AngleAxisd(t * now.omega_WB.norm(), now.omega_WB.normalized()) * now.R_WB;
    state.q += t * now.qd;
    return link_motions(robot, state);
  };
  const auto before = moved(-h);
  const auto after = moved(h);
  const auto motions = link_motions(robot, now);
  for (std::size_t i = 0; i < kLinks; ++i) {
    const Vec3 velocity = (after[i].p_com - before[i].p_com) / (2.0 * h);
    const Mat3 R_dot = (after[i].R_WL - before[i].R_WL) / (2.0 * h);
    EXPECT_LT((velocity - motions[i].v_com).norm(), 1e-8) << i;
    EXPECT_LT((R_dot - skew(motions[i].omega) * motions[i].R_WL).norm(), 1e-8) << i;
  }
}

TEST(LinkMotions, AgreeWithTheDynamicsModel) {
  const RobotDescription robot = test::hand_built_robot();
  const Model model(robot);
  ModelTerms terms;
  std::mt19937_64 random(4);
  for (int n = 0; n < 100; ++n) {
    const RobotState state = test::random_state(random);
    model.compute(state, terms);
    const auto motions = link_motions(robot, state);
    Vec3 momentum = Vec3::Zero();
    for (int i = 0; i < kLinks; ++i) {
      momentum += link_description(robot, i).inertia.mass * motions[static_cast<std::size_t>(i)].v_com;
    }
    EXPECT_LT((momentum - terms.p_b.head<3>()).norm(), 1e-11);
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      EXPECT_LT((test::foot_center(robot, state, static_cast<int>(leg)) - terms.foot[leg].p).norm(), 1e-13);
    }
  }
}

}  // namespace
}  // namespace dob::forward_kinematics_test
