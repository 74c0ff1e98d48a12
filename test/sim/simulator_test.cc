#include "sim/simulator.h"

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/sim/hand_built_robot.h"
#include "test/support/random_state.h"

namespace dob::simulator_test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Vec18 velocity(const RobotState& state) {
  Vec18 v;
  v << state.v_WB, state.omega_WB, state.qd;
  return v;
}

// A walk-like mess: a drop onto boxes and ground, changing torques, a push. Returns every number of the run.
std::vector<double> recorded_run(Simulator& simulator, const RobotState& start) {
  simulator.reset(start);
  std::vector<double> record;
  for (int k = 0; k < 400; ++k) {
    const RobotState state = simulator.state();
    const Vec12 torque = test::hold(start.q, state) + Vec12::Constant(10.0 * std::sin(0.05 * k));
    const AppliedForce push{1, LegLink::kUpper, {0.0, 0.0, -0.1}, {20.0, 10.0, 0.0}};
    const StepResult step = simulator.step(torque, {&push, 1});
    const Vec18 v = velocity(state);
    record.insert(record.end(), v.begin(), v.end());
    record.insert(record.end(), state.p_WB.begin(), state.p_WB.end());
    record.insert(record.end(), state.R_WB.reshaped().begin(), state.R_WB.reshaped().end());
    record.insert(record.end(), state.q.begin(), state.q.end());
    record.insert(record.end(), step.joint_torque.begin(), step.joint_torque.end());
    for (const Vec3& force : step.foot_force_W) record.insert(record.end(), force.begin(), force.end());
  }
  return record;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

Terrain boxes_under_two_feet() {
  Terrain terrain;
  terrain.boxes = {{{0.3, 0.2, 0.0}, {0.4, 0.3, 0.03}, 0.2, 0.5}, {{-0.3, -0.2, 0.0}, {0.4, 0.3, 0.05}, 0.0, 0.8}};
  return terrain;
}

TEST(Simulator, ReturnsTheStateItWasResetTo) {
  Simulator simulator(test::hand_built_robot(), {});
  std::mt19937_64 random(1);
  for (int n = 0; n < 100; ++n) {
    const RobotState state = test::random_state(random);
    simulator.reset(state);
    const RobotState read = simulator.state();
    EXPECT_LT((read.p_WB - state.p_WB).norm(), 1e-14);
    EXPECT_LT((read.R_WB - state.R_WB).norm(), 1e-14);
    EXPECT_LT((read.q - state.q).norm(), 1e-13);
    EXPECT_LT((velocity(read) - velocity(state)).norm(), 1e-13);
    EXPECT_LT((read.R_WB * read.R_WB.transpose() - Mat3::Identity()).norm(), 1e-14);
  }
}

TEST(Simulator, ReportsTheBaseOriginAlsoWhenTheTrunksCentreOfMassLiesElsewhere) {
  RobotDescription robot = test::hand_built_robot();
  robot.trunk.inertia.com = {0.05, -0.02, 0.03};
  Simulator simulator(robot, {});
  std::mt19937_64 random(2);
  const RobotState state = test::random_state(random);
  simulator.reset(state);
  EXPECT_LT((simulator.state().p_WB - state.p_WB).norm(), 1e-14);
  EXPECT_LT((simulator.state().v_WB - state.v_WB).norm(), 1e-14);
}

TEST(Simulator, CountsTimeInWholeSteps) {
  SimOptions options;
  options.dt = 0.002;
  options.contacts = false;
  Simulator simulator(test::hand_built_robot(), {}, options);
  for (int k = 0; k < 500; ++k) simulator.step(Vec12::Zero());
  EXPECT_DOUBLE_EQ(simulator.time(), 1.0);
  simulator.reset(RobotState{});
  EXPECT_EQ(simulator.time(), 0.0);
}

TEST(Simulator, RepeatsItselfBitForBit) {
  const RobotDescription robot = test::hand_built_robot();
  const RobotState start = test::standing_state(robot, 0.05);
  Simulator first(robot, boxes_under_two_feet());
  Simulator second(robot, boxes_under_two_feet());
  const auto record = recorded_run(first, start);
  EXPECT_TRUE(same_bits(record, recorded_run(second, start)));
}

TEST(Simulator, RepeatsItselfBitForBitAfterAReset) {
  const RobotDescription robot = test::hand_built_robot();
  const RobotState start = test::standing_state(robot, 0.05);
  Simulator fresh(robot, boxes_under_two_feet());
  Simulator used(robot, boxes_under_two_feet());
  std::mt19937_64 random(5);
  recorded_run(used, test::random_state(random));  // ends in the middle of contacts and motion
  EXPECT_TRUE(same_bits(recorded_run(fresh, start), recorded_run(used, start)));
}

TEST(Simulator, TellsTwoDifferentRunsApart) {  // the comparison above can fail
  const RobotDescription robot = test::hand_built_robot();
  RobotState start = test::standing_state(robot, 0.05);
  Simulator simulator(robot, boxes_under_two_feet());
  const auto record = recorded_run(simulator, start);
  start.qd[7] = 1e-12;
  EXPECT_FALSE(same_bits(record, recorded_run(simulator, start)));
}

TEST(Simulator, SimulatorsSideBySideDoNotInfluenceEachOther) {
  const RobotDescription robot = test::hand_built_robot();
  const RobotState start = test::standing_state(robot, 0.05);
  Simulator alone(robot, boxes_under_two_feet());
  const auto expected = recorded_run(alone, start);
  Simulator one(robot, boxes_under_two_feet());
  {
    Simulator other(robot, {});
    recorded_run(other, start);
  }
  EXPECT_TRUE(same_bits(expected, recorded_run(one, start)));
}

TEST(Simulator, ClampsTorquesAtTheEffortLimitAndReportsWhatItApplied) {
  RobotDescription robot = test::hand_built_robot();
  robot.legs[2].joints[1].effort_limit = 10.0;
  SimOptions options;
  options.contacts = false;
  Simulator simulator(robot, {}, options);
  Vec12 commanded = Vec12::Zero();
  commanded << 61.0, -75.0, 5.0, 0, 0, 0, 0, 12.0, 0, 0, 0, -60.0;
  Vec12 allowed = commanded;
  allowed[0] = 60.0;
  allowed[1] = -60.0;
  allowed[7] = 10.0;
  EXPECT_EQ(simulator.step(commanded).joint_torque, allowed);
  const RobotState saturated = simulator.state();
  simulator.reset(RobotState{});
  simulator.step(allowed);
  EXPECT_EQ(simulator.state().qd, saturated.qd);
}

TEST(Simulator, StopsJointsAtTheirLimitsOnlyWhenAskedTo) {
  const RobotDescription robot = test::hand_built_robot();
  SimOptions options;
  options.contacts = false;
  const auto roll_after_half_a_second = [&](bool stops) {
    options.joint_stops = stops;
    Simulator simulator(robot, {}, options);
    Vec12 torque = Vec12::Zero();
    torque[0] = 2.0;
    double furthest = 0.0;
    for (int k = 0; k < 500; ++k) {
      simulator.step(torque);
      furthest = std::max(furthest, simulator.state().q[0]);
    }
    return furthest;
  };
  EXPECT_GT(roll_after_half_a_second(false), 2.0);
  EXPECT_LT(roll_after_half_a_second(true), 1.7453 + 0.01);
}

TEST(Simulator, RefusesWhatIsNotFinite) {
  Simulator simulator(test::hand_built_robot(), {});
  Vec12 torque = Vec12::Zero();
  torque[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(simulator.step(torque), std::invalid_argument);
  AppliedForce force;
  force.force_W.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(simulator.step(Vec12::Zero(), {&force, 1}), std::invalid_argument);
  force = {4, LegLink::kHip, Vec3::Zero(), Vec3::Zero()};
  EXPECT_THROW(simulator.step(Vec12::Zero(), {&force, 1}), std::invalid_argument);
  EXPECT_EQ(simulator.time(), 0.0);
}

TEST(Simulator, NamesTheOptionThatIsNotPhysical) {
  const auto with = [](const std::function<void(SimOptions&)>& change) {
    return [change] {
      SimOptions options;
      change(options);
      Simulator(test::hand_built_robot(), {}, options);
    };
  };
  const auto message = [](const char* text) { return ThrowsMessage<std::invalid_argument>(HasSubstr(text)); };
  EXPECT_THAT(with([](SimOptions& o) { o.dt = 0.0; }), message("dt = 0, must be finite and > 0"));
  EXPECT_THAT(with([](SimOptions& o) { o.erp = 1.5; }), message("erp = 1.5, must be between 0 and 1"));
  EXPECT_THAT(with([](SimOptions& o) { o.contact_cfm = -1.0; }), message("contact_cfm = -1"));
  EXPECT_THAT(with([](SimOptions& o) { o.robot_friction = -0.1; }), message("robot_friction = -0.1"));
}

TEST(Simulator, NamesTheBoxThatIsNotPhysical) {
  Terrain terrain;
  terrain.boxes.resize(2);
  terrain.boxes[1].size.y() = 0.0;
  const auto build = [&terrain] { Simulator(test::hand_built_robot(), terrain); };
  EXPECT_THAT(build, ThrowsMessage<std::invalid_argument>(HasSubstr("boxes[1].size[1] = 0")));
  terrain.boxes[1].size.y() = 1.0;
  terrain.boxes[0].friction = -2.0;
  EXPECT_THAT(build, ThrowsMessage<std::invalid_argument>(HasSubstr("boxes[0].friction = -2")));
}

TEST(Simulator, NamesTheLinkWithoutMass) {
  RobotDescription robot = test::hand_built_robot();
  robot.legs[1].links[2].inertia.mass = 0.0;
  robot.legs[1].links[2].name = "shank";
  EXPECT_THAT([&] { Simulator(robot, {}); }, ThrowsMessage<std::invalid_argument>(HasSubstr("'shank'")));
}

}  // namespace
}  // namespace dob::simulator_test
