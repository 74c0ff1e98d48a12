// A load on the trunk: what the feet carry, how it moves with the trunk, and that it leaves nothing behind.
#include "sim/payload.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/disturbance_schedule.h"
#include "sim/simulator.h"
#include "test/sim/hand_built_robot.h"

namespace dob::payload_test {
namespace {

constexpr PerLeg<double> kStanding{-1.0, -1.0, -1.0, -1.0};

// Vertical force of all feet and its moments about the origin of W, mean over the last 0.5 s of `seconds` [N; N m].
Vec3 supported(Simulator& simulator, const RobotDescription& robot, const RobotState& start, double seconds) {
  Vec3 sum = Vec3::Zero();
  const int steps = static_cast<int>(std::lround(seconds * 1e3));
  for (int k = 0; k < steps; ++k) {
    const RobotState state = simulator.state();
    const StepResult step = simulator.step(test::hold(start.q, state));
    if (k < steps - 500) continue;
    for (int leg = 0; leg < kLegs; ++leg) {
      const double f = step.foot_force_W[static_cast<std::size_t>(leg)].z() / 500.0;
      const Vec3 foot = test::foot_center(robot, state, leg);
      sum += Vec3(f, f * foot.y(), -f * foot.x());
    }
  }
  return sum;
}

// The same of the weights of all links [N; N m].
Vec3 weights(const RobotDescription& robot, const RobotState& state) {
  const auto motions = link_motions(robot, state);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < kLinks; ++i) {
    const double f = kGravity * link_description(robot, i).inertia.mass;
    const Vec3& p = motions[static_cast<std::size_t>(i)].p_com;
    sum += Vec3(f, f * p.y(), -f * p.x());
  }
  return sum;
}

// Statics: in equilibrium the feet carry the load's m g besides the robot's weight, and its moment where it stands.
TEST(Payload, AtRestTheFeetCarryItsWeightWhereItIs) {
  const RobotDescription robot = test::hand_built_robot();
  const RobotState start = test::standing_state(robot);
  Simulator simulator(robot, {});
  simulator.add_payload({.start_s = 2.0, .mass = 3.0, .p_B = {0.2, 0.1, 0.08}});
  simulator.reset(start);
  const Vec3 without = supported(simulator, robot, start, 2.0);
  EXPECT_LT((without - weights(robot, simulator.state())).norm(), 0.05);
  const Vec3 with = supported(simulator, robot, start, 4.0);
  const RobotState state = simulator.state();
  const Vec3 p = state.p_WB + state.R_WB * Vec3(0.2, 0.1, 0.08);
  const double f = 3.0 * kGravity;
  EXPECT_NEAR(with[0] - without[0], f, 0.05);
  EXPECT_LT((with - weights(robot, state) - Vec3(f, f * p.y(), -f * p.x())).norm(), 0.05);
}

// Without gravity and contacts a robot that moves as one goes on as it did: the load had its speed already.
TEST(Payload, IsPutOnWithoutAnImpact) {
  SimOptions options;
  options.contacts = false;
  options.gravity = 0.0;
  Simulator simulator(test::hand_built_robot(), {}, options);
  simulator.add_payload({.start_s = 0.01, .mass = 3.0, .p_B = {0.2, 0.1, 0.08}});
  RobotState start = test::standing_state(test::hand_built_robot());
  start.v_WB = {0.3, -0.2, 0.1};
  simulator.reset(start);
  for (int k = 0; k < 100; ++k) simulator.step(Vec12::Zero());
  EXPECT_LT((simulator.state().v_WB - start.v_WB).norm(), 1e-9);
  EXPECT_LT(simulator.state().qd.norm(), 1e-9);
}

TEST(Payload, IsPutOnAtTheFirstStepNotBeforeItsStart) {
  SimOptions options;
  options.contacts = false;
  const auto speeds_after = [&](int steps, bool loaded) {
    Simulator simulator(test::hand_built_robot(), {}, options);
    if (loaded) simulator.add_payload({.start_s = 0.01, .mass = 3.0, .p_B = {0.2, 0.1, 0.08}});
    simulator.reset(test::standing_state(test::hand_built_robot()));
    for (int k = 0; k < steps; ++k) simulator.step(Vec12::Constant(1.0));
    return simulator.state().qd;
  };
  EXPECT_EQ(speeds_after(10, true), speeds_after(10, false));
  EXPECT_NE(speeds_after(11, true), speeds_after(11, false));
}

TEST(Payload, LeavesNothingBehindAfterAReset) {
  const RobotDescription robot = test::hand_built_robot();
  const RobotState start = test::standing_state(robot);
  Simulator simulator(robot, {});
  simulator.add_payload({.start_s = 0.1, .mass = 3.0, .p_B = {0.0, 0.0, 0.08}});
  const auto run = [&] {
    simulator.reset(start);
    for (int k = 0; k < 300; ++k) simulator.step(test::hold(start.q, simulator.state()));
    return simulator.state();
  };
  const RobotState first = run();
  const RobotState second = run();
  EXPECT_EQ(first.q, second.q);
  EXPECT_EQ(first.qd, second.qd);
  EXPECT_EQ(first.p_WB, second.p_WB);
  EXPECT_EQ(first.v_WB, second.v_WB);
}

TEST(Payload, IsAForceOfTheTruthButNoneToBeApplied) {
  Disturbance push;
  push.profile.amplitude_N = 7.0;
  DisturbanceSchedule schedule({push}, {{.start_s = 0.002, .mass = 3.0, .p_B = {0.1, 0.0, 0.08}}}, 10.0);
  schedule.update(0.001, kStanding, {});
  EXPECT_EQ(schedule.true_forces().size(), 1u);
  schedule.update(0.002, kStanding, {});
  EXPECT_TRUE(schedule.began());
  ASSERT_EQ(schedule.forces().size(), 1u);
  EXPECT_EQ(schedule.forces()[0].force_W, Vec3(7.0, 0.0, 0.0));
  ASSERT_EQ(schedule.true_forces().size(), 2u);
  EXPECT_EQ(schedule.true_forces()[1].force_W, Vec3(0.0, 0.0, -30.0));
  EXPECT_EQ(schedule.true_forces()[1].p_L, Vec3(0.1, 0.0, 0.08));
  EXPECT_EQ(schedule.true_forces()[1].leg, AppliedForce::kTrunk);
  schedule.update(0.003, kStanding, {});
  EXPECT_FALSE(schedule.began());
}

TEST(Payload, NamesWhatIsNotPhysical) {
  Simulator simulator(test::hand_built_robot(), {});
  EXPECT_THAT([&] { simulator.add_payload({.mass = 0.0}); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("mass = 0, must be finite and > 0")));
  EXPECT_THAT(
      [&] {
        simulator.add_payload({.mass = 1.0, .p_B = {0.0, NAN, 0.0}});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("p_B = nan")));
}

}  // namespace
}  // namespace dob::payload_test
