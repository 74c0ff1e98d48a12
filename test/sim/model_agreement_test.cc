// Accelerations of a step against the forward dynamics of the independent model, v_dot = M^-1 (S^T tau - h +
// J^T f), and the balance of momentum with the reported forces.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "robot/model.h"
#include "sim/simulator.h"
#include "test/sim/hand_built_robot.h"
#include "test/support/random_state.h"

namespace dob::model_agreement_test {
namespace {

Vec18 velocity(const RobotState& state) {
  Vec18 v;
  v << state.v_WB, state.omega_WB, state.qd;
  return v;
}

Vec12 random_torques(std::mt19937_64& random, double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  Vec12 torque;
  for (double& t : torque) t = uniform(random);
  return torque;
}

// Right-hand side S^T tau - h + J^T f, collected force by force.
class ForwardDynamics {
 public:
  ForwardDynamics(const RobotDescription& robot, const RobotState& state) : model_(robot) {
    model_.compute(state, terms_);
    rhs_ << -terms_.h_b, -terms_.h_q;
  }
  void add_torques(const Vec12& torque) { rhs_.tail<12>() += torque; }
  void add_force(int leg, const LegPoint& point, const Vec3& force) {
    add_trunk_force(point.p, force);
    rhs_.segment<3>(kBaseDof + kJointsPerLeg * leg) += point.J_q.transpose() * force;
  }
  void add_trunk_force(const Vec3& p_W, const Vec3& force) {
    rhs_.head<3>() += force;
    rhs_.segment<3>(3) += (p_W - terms_.state.p_WB).cross(force);
  }
  void add_force(const AppliedForce& f) {
    if (f.leg == AppliedForce::kTrunk) {
      add_trunk_force(terms_.state.p_WB + terms_.state.R_WB * f.p_L, f.force_W);
    } else {
      add_force(f.leg, leg_point(terms_, static_cast<Leg>(f.leg), f.link, f.p_L), f.force_W);
    }
  }
  Vec18 acceleration() const { return terms_.mass_matrix().llt().solve(rhs_); }
  const ModelTerms& terms() const { return terms_; }

 private:
  Model model_;
  ModelTerms terms_;
  Vec18 rhs_;
};

TEST(Acceleration, EqualsTheModelsAtRestUnderTorquesAndForcesOnAnyLink) {
  const RobotDescription robot = test::hand_built_robot();
  SimOptions options;
  options.contacts = false;
  Simulator simulator(robot, {}, options);
  std::mt19937_64 random(7);
  for (int n = 0; n < 39; ++n) {
    RobotState state = test::random_state(random);
    state.v_WB.setZero();
    state.omega_WB.setZero();
    state.qd.setZero();
    simulator.reset(state);
    const Vec12 torque = random_torques(random, 5.0);
    const int link = n % 13;
    const AppliedForce force{(link - 1 + 3) / 3 - 1, static_cast<LegLink>((link + 2) % 3), Vec3(0.03, -0.02, -0.1),
                             Vec3(10.0, -20.0, 15.0)};
    simulator.step(torque, {&force, 1});
    ForwardDynamics model(robot, state);
    model.add_torques(torque);
    model.add_force(force);
    const Vec18 expected = model.acceleration();
    const Vec18 measured = (velocity(simulator.state()) - velocity(state)) / options.dt;
    EXPECT_LT((measured - expected).norm(), 1e-6 * expected.norm()) << "leg " << force.leg;
  }
}

// Distance between the two accelerations after 50 ms of motion from the same random state. Not in the very
// first step: a hinge keeps velocities, not accelerations, compatible, so that a step taken from a state with
// compatible velocities lacks the centripetal terms, which later steps carry over from one to the next.
double acceleration_error_in_motion(std::uint64_t seed, double dt) {
  const RobotDescription robot = test::hand_built_robot();
  SimOptions options;
  options.dt = dt;
  options.contacts = false;
  Simulator simulator(robot, {}, options);
  std::mt19937_64 random(seed);
  simulator.reset(test::random_state(random));
  const Vec12 torque = random_torques(random, 5.0);
  for (int k = 0; k < std::lround(0.05 / dt); ++k) simulator.step(torque);
  const RobotState before = simulator.state();
  simulator.step(torque);
  ForwardDynamics model(robot, before);
  model.add_torques(torque);
  return ((velocity(simulator.state()) - velocity(before)) / dt - model.acceleration()).norm();
}

TEST(Acceleration, ApproachesTheModelsInMotionToFirstOrderInTheStep) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const double ratio = acceleration_error_in_motion(seed, 6.25e-5) / acceleration_error_in_motion(seed, 1.25e-4);
    EXPECT_NEAR(ratio, 0.5, 0.05) << "seed " << seed;
  }
}

TEST(Acceleration, IsExplainedByTheTorqueAndFootForcesOfTheSameStep) {
  const RobotDescription robot = test::hand_built_robot();
  Simulator simulator(robot, {});
  const RobotState start = test::standing_state(robot);
  simulator.reset(start);
  for (int k = 0; k < 5000; ++k) simulator.step(test::hold(start.q, simulator.state()));
  const RobotState before = simulator.state();
  ASSERT_LT(velocity(before).norm(), 1e-2);
  Vec12 torque = test::hold(start.q, before);
  torque[4] += 5.0;  // a jolt, so that there is something to explain
  const StepResult step = simulator.step(torque);
  ForwardDynamics model(robot, before);
  model.add_torques(step.joint_torque);
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto at = static_cast<std::size_t>(leg);
    model.add_force(leg, model.terms().contact[at], step.foot_force_W[at]);
  }
  const Vec18 expected = model.acceleration();
  const Vec18 measured = (velocity(simulator.state()) - velocity(before)) / SimOptions{}.dt;
  ASSERT_GT(expected.norm(), 1.0);
  EXPECT_LT((measured - expected).norm(), 1e-5 * expected.norm());
}

// Momentum with the velocities after a step at the pose before it: the pair that ODE's constraints relate.
Vec3 momentum(const RobotDescription& robot, RobotState pose, const RobotState& motion) {
  pose.v_WB = motion.v_WB;
  pose.omega_WB = motion.omega_WB;
  pose.qd = motion.qd;
  const auto motions = link_motions(robot, pose);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < kLinks; ++i) {
    sum += link_description(robot, i).inertia.mass * motions[static_cast<std::size_t>(i)].v_com;
  }
  return sum;
}

TEST(FootForces, BalanceTheMomentumOfTheVeryStepTheyAreReportedWith) {
  const RobotDescription robot = test::hand_built_robot();
  const double dt = SimOptions{}.dt;
  Simulator simulator(robot, {});
  RobotState start = test::standing_state(robot, 0.02);  // dropped: forces change from step to step
  start.v_WB.x() = 0.3;
  simulator.reset(start);
  const AppliedForce push{2, LegLink::kLower, Vec3::Zero(), {15.0, -5.0, 0.0}};
  Vec3 before = momentum(robot, start, start);
  Vec3 previous_force = Vec3::Zero();
  double imbalance = 0.0;          // [N] largest
  double imbalance_shifted = 0.0;  // [N] with the forces of the step before instead
  for (int k = 0; k < 300; ++k) {
    const RobotState now = simulator.state();
    const StepResult step = simulator.step(test::hold(start.q, now), {&push, 1});
    const Vec3 after = momentum(robot, now, simulator.state());
    Vec3 force = push.force_W - test::mass_of(robot) * kGravity * Vec3::UnitZ();
    for (const Vec3& f : step.foot_force_W) force += f;
    imbalance = std::max(imbalance, ((after - before) / dt - force).norm());
    imbalance_shifted = std::max(imbalance_shifted, ((after - before) / dt - previous_force).norm());
    before = after;
    previous_force = force;
  }
  // Hinge rates are read about axes that the step has turned: an error of order (qd dt)^2 of the legs' momentum.
  EXPECT_LT(imbalance, 0.5);
  EXPECT_GT(imbalance_shifted, 100.0);
}

TEST(AppliedForce, ChangesLinearAndAngularMomentumByItsImpulseAndMoment) {
  const RobotDescription robot = test::hand_built_robot();
  SimOptions options;
  options.contacts = false;
  options.gravity = 0.0;
  Simulator simulator(robot, {}, options);
  std::mt19937_64 random(9);
  RobotState start = test::random_state(random);
  start.v_WB.setZero();
  start.omega_WB.setZero();
  start.qd.setZero();
  simulator.reset(start);
  const Vec3 p_L(0.02, 0.01, -0.2);
  const AppliedForce push{3, LegLink::kLower, p_L, {30.0, -10.0, 20.0}};
  simulator.step(Vec12::Zero(), {&push, 1});
  const RobotState end = simulator.state();

  const auto motions = link_motions(robot, start);
  const LinkMotion& shank = motions[static_cast<std::size_t>(link_index(3, 2))];
  const Vec3 impulse = options.dt * push.force_W;
  EXPECT_LT((momentum(robot, start, end) - impulse).norm(), 1e-6 * impulse.norm());

  RobotState pose = start;
  pose.v_WB = end.v_WB;
  pose.omega_WB = end.omega_WB;
  pose.qd = end.qd;
  Vec3 spin = Vec3::Zero();  // about the origin of W
  const auto moved = link_motions(robot, pose);
  for (int i = 0; i < kLinks; ++i) {
    const LinkInertia& body = link_description(robot, i).inertia;
    const LinkMotion& m = moved[static_cast<std::size_t>(i)];
    spin += m.R_WL * body.inertia * m.R_WL.transpose() * m.omega + body.mass * m.p_com.cross(m.v_com);
  }
  const Vec3 moment = (shank.p_WL + shank.R_WL * p_L).cross(impulse);
  EXPECT_LT((spin - moment).norm(), 1e-6 * moment.norm());
}

}  // namespace
}  // namespace dob::model_agreement_test
