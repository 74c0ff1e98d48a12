// Slipping of a sled: the standing robot with its joints locked by stops, pushed at the height of the ground.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "sim/simulator.h"
#include "test/sim/hand_built_robot.h"

namespace dob::friction_test {
namespace {

class Sled {
 public:
  Sled(const Terrain& terrain, double robot_friction, double ground = 0.0) : robot_(test::hand_built_robot()) {
    const RobotState start = test::standing_state(robot_, ground);
    for (int joint = 0; joint < kJoints; ++joint) {
      auto& description = robot_.legs[static_cast<std::size_t>(joint / 3)].joints[static_cast<std::size_t>(joint % 3)];
      description.lower = description.upper = start.q[joint];
    }
    SimOptions options;
    options.joint_stops = true;
    options.robot_friction = robot_friction;
    simulator_ = std::make_unique<Simulator>(robot_, terrain, options);
    simulator_->reset(start);
    ground_ = ground;
    for (int k = 0; k < 500; ++k) simulator_->step(Vec12::Zero());
  }

  double weight() const { return test::mass_of(robot_) * kGravity; }

  // Mean acceleration over 0.1 s under a push with the given force [m/s^2].
  Vec3 acceleration(const Vec3& force) {
    const Vec3 before = simulator_->state().v_WB;
    for (int k = 0; k < 100; ++k) {
      const double height = simulator_->state().p_WB.z() - ground_;
      const AppliedForce push{AppliedForce::kTrunk, LegLink::kHip, {0.0, 0.0, -height}, force};
      last_ = simulator_->step(Vec12::Zero(), {&push, 1});
    }
    return (simulator_->state().v_WB - before) / 0.1;
  }

  const StepResult& last() const { return last_; }

 private:
  RobotDescription robot_;
  std::unique_ptr<Simulator> simulator_;
  double ground_ = 0.0;
  StepResult last_;
};

Terrain ground(double friction) {
  Terrain terrain;
  terrain.ground_friction = friction;
  return terrain;
}

constexpr double kMu = 0.1;

class FrictionAxis : public ::testing::TestWithParam<Vec3> {};

TEST_P(FrictionAxis, HoldsBelowTheLimitAndSlidesAboveIt) {
  const Vec3 axis = GetParam();
  Sled below(ground(kMu), 1.0);
  EXPECT_LT(below.acceleration(0.99 * kMu * below.weight() * axis).norm(), 1e-5);
  EXPECT_LT(below.last().foot_slip_W[0].norm(), 1e-6);

  Sled above(ground(kMu), 1.0);
  const double excess = 0.1;  // of the limit; accelerates the sled by excess mu g
  const Vec3 expected = excess * kMu * kGravity * axis;
  const Vec3 measured = above.acceleration((1.0 + excess) * kMu * above.weight() * axis);
  // Not exact, because the limit is set by the normal forces before friction: see sim/simulator.h.
  EXPECT_LT((measured - expected).norm(), 1e-3 * kMu * kGravity);
  EXPECT_NEAR(above.last().foot_slip_W[0].dot(axis), 0.1 * expected.norm(), 0.1 * 1e-3 * kMu * kGravity);
}

INSTANTIATE_TEST_SUITE_P(AlongXAndY, FrictionAxis,
                         ::testing::Values(Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)));

TEST(Friction, IsAPyramidThatHoldsMoreOnTheDiagonal) {
  const Vec3 diagonal = Vec3(1.0, 1.0, 0.0).normalized();
  Sled held(ground(kMu), 1.0);  // a cone would let it slide at 1.0
  EXPECT_LT(held.acceleration(1.2 * kMu * held.weight() * diagonal).norm(), 1e-5);
  Sled sliding(ground(kMu), 1.0);
  const Vec3 measured = sliding.acceleration(1.8 * kMu * sliding.weight() * diagonal);
  const double expected = (1.8 - std::sqrt(2.0)) * kMu * kGravity;
  EXPECT_NEAR(measured.dot(diagonal), expected, 0.02 * kMu * kGravity);
}

TEST(Friction, IsTheSmallerOfTheTwoSurfaces) {
  const auto limit = [](Sled sled) {  // total friction over weight, from a push that surely makes it slide
    const Vec3 force = 0.5 * sled.weight() * Vec3::UnitX();
    return 0.5 - sled.acceleration(force).x() / kGravity;
  };
  EXPECT_NEAR(limit(Sled(ground(0.3), 0.1)), 0.1, 1e-4);
  EXPECT_NEAR(limit(Sled(ground(0.1), 0.3)), 0.1, 1e-4);
}

TEST(Friction, OfABoxIsItsOwnNotThatOfTheGroundBelow) {
  Terrain terrain = ground(1.0);
  terrain.boxes = {{{0.0, 0.0, 0.02}, {3.0, 3.0, 0.04}, 0.0, kMu}};
  Sled sled(terrain, 1.0, 0.04);
  const double expected = 0.1 * kMu * kGravity;
  EXPECT_NEAR(sled.acceleration(1.1 * kMu * sled.weight() * Vec3::UnitX()).x(), expected, 1e-3 * kMu * kGravity);
}

}  // namespace
}  // namespace dob::friction_test
