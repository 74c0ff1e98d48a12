// What feet, trunk and legs meet, and the forces that hold them up.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/simulator.h"
#include "test/sim/hand_built_robot.h"

namespace dob::contact_test {
namespace {

double vertical_force(const StepResult& step) {
  double sum = 0.0;
  for (const Vec3& force : step.foot_force_W) sum += force.z();
  return sum;
}

// Holds the posture for the given time; the last step's result.
StepResult stand(Simulator& simulator, const RobotState& start, double seconds) {
  StepResult step;
  for (int k = 0; k < std::lround(seconds / SimOptions{}.dt); ++k) {
    step = simulator.step(test::hold(start.q, simulator.state()));
  }
  return step;
}

TEST(Contact, FeetCarryTheWeightAtRest) {
  const RobotDescription robot = test::hand_built_robot();
  Simulator simulator(robot, {});
  const RobotState start = test::standing_state(robot);
  simulator.reset(start);
  const StepResult step = stand(simulator, start, 5.0);
  const double weight = test::mass_of(robot) * kGravity;
  EXPECT_NEAR(vertical_force(step), weight, 1e-3 * weight);
  EXPECT_EQ(step.foot_contact, (PerLeg<bool>{true, true, true, true}));
  EXPECT_FALSE(step.trunk_contact);
  EXPECT_FALSE(step.leg_contact);
  for (int leg = 0; leg < kLegs; ++leg) {
    EXPECT_LT(step.foot_slip_W[static_cast<std::size_t>(leg)].norm(), 1e-6);
    // The sphere rests on the plane but for the penetration of a soft contact, about f dt cfm / erp:
    // micrometres.
    EXPECT_NEAR(test::foot_center(robot, simulator.state(), leg).z(), 0.028, 1e-5);
  }
}

TEST(Contact, NothingTouchesInTheAir) {
  const RobotDescription robot = test::hand_built_robot();
  Simulator simulator(robot, {});
  simulator.reset(test::standing_state(robot, 0.5));
  const StepResult step = simulator.step(Vec12::Zero());
  EXPECT_EQ(step.foot_contact, PerLeg<bool>{});
  EXPECT_EQ(vertical_force(step), 0.0);
  EXPECT_FALSE(step.trunk_contact || step.leg_contact);
}

TEST(Contact, AFootThatLeavesTheGroundReportsNoForceAnyMore) {
  const RobotDescription robot = test::hand_built_robot();
  Simulator simulator(robot, {});
  const RobotState start = test::standing_state(robot);
  simulator.reset(start);
  stand(simulator, start, 0.5);
  RobotState lifted = start;
  lifted.p_WB.z() += 0.1;
  simulator.reset(lifted);
  const StepResult step = simulator.step(Vec12::Zero());
  EXPECT_EQ(step.foot_contact, PerLeg<bool>{});
  EXPECT_EQ(vertical_force(step), 0.0);
}

TEST(Contact, FeetStandOnBoxes) {
  const RobotDescription robot = test::hand_built_robot();
  const double height = 0.04;
  RobotState start = test::standing_state(robot, height);
  Terrain terrain;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vec3 foot = test::foot_center(robot, start, leg);
    terrain.boxes.push_back({{foot.x(), foot.y(), 0.5 * height}, {0.2, 0.15, height}, 0.3, 1.0});
  }
  Simulator simulator(robot, terrain);
  simulator.reset(start);
  const StepResult step = stand(simulator, start, 5.0);
  const double weight = test::mass_of(robot) * kGravity;
  EXPECT_NEAR(vertical_force(step), weight, 1e-3 * weight);
  for (int leg = 0; leg < kLegs; ++leg) {
    EXPECT_NEAR(test::foot_center(robot, simulator.state(), leg).z(), height + 0.028, 1e-5);
  }
}

TEST(Contact, ABoxTurnedByItsYawIsFeltOnlyWhereItIs) {
  const RobotDescription robot = test::hand_built_robot();
  const RobotState start = test::standing_state(robot, 0.04);
  const Vec3 foot = test::foot_center(robot, start, 0);
  const double quarter = std::numbers::pi / 2.0;
  const auto touches = [&](double yaw) {
    Terrain terrain;  // a strip 0.3 m away from the foot, across it only when turned
    terrain.boxes = {{{foot.x() + 0.3, foot.y(), 0.02}, {0.1, 1.0, 0.045}, yaw, 1.0}};
    Simulator simulator(robot, terrain);
    simulator.reset(start);
    return simulator.step(Vec12::Zero()).foot_contact[0];
  };
  EXPECT_FALSE(touches(0.0));
  EXPECT_TRUE(touches(quarter));
}

TEST(Contact, ADroppedRobotReportsTrunkAndLegs) {
  const RobotDescription robot = test::hand_built_robot();
  Simulator simulator(robot, {});
  simulator.reset(test::standing_state(robot));
  bool trunk = false;
  bool leg = false;
  for (int k = 0; k < 2000; ++k) {
    const StepResult step = simulator.step(Vec12::Zero());
    trunk |= step.trunk_contact;
    leg |= step.leg_contact;
  }
  EXPECT_TRUE(trunk);
  EXPECT_TRUE(leg);
  EXPECT_GT(simulator.state().p_WB.z(), 0.04);  // and the trunk, 0.11 m high, lies on the ground, not in it
}

TEST(Contact, CanBeSwitchedOff) {
  const RobotDescription robot = test::hand_built_robot();
  SimOptions options;
  options.contacts = false;
  Simulator simulator(robot, {}, options);
  simulator.reset(test::standing_state(robot));
  for (int k = 0; k < 500; ++k) EXPECT_EQ(simulator.step(Vec12::Zero()).foot_contact, PerLeg<bool>{});
  EXPECT_LT(simulator.state().p_WB.z(), 0.0);
}

}  // namespace
}  // namespace dob::contact_test
