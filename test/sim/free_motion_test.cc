// Motion without contacts against closed forms: free fall, conservation laws, a pendulum.
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "sim/simulator.h"
#include "test/sim/hand_built_robot.h"
#include "test/support/random_state.h"

namespace dob::free_motion_test {
namespace {

SimOptions in_flight(double dt) {
  SimOptions options;
  options.dt = dt;
  options.contacts = false;
  return options;
}

// Sums over the links; nothing of the code under test but the state it reports.
struct Totals {
  double energy = 0.0;           // [J]
  Vec3 momentum = Vec3::Zero();  // [N s]
  Vec3 spin = Vec3::Zero();      // [N m s] angular momentum about the centre of mass
};

Totals totals(const RobotDescription& robot, const RobotState& state) {
  const auto motions = link_motions(robot, state);
  Totals sum;
  Vec3 moment = Vec3::Zero();
  for (int i = 0; i < kLinks; ++i) {
    const LinkInertia& body = link_description(robot, i).inertia;
    const LinkMotion& m = motions[static_cast<std::size_t>(i)];
    const Vec3 turning = m.R_WL * body.inertia * m.R_WL.transpose() * m.omega;
    sum.energy += body.mass * (0.5 * m.v_com.squaredNorm() + kGravity * m.p_com.z()) + 0.5 * m.omega.dot(turning);
    sum.momentum += body.mass * m.v_com;
    moment += body.mass * m.p_com;
    sum.spin += turning + body.mass * m.p_com.cross(m.v_com);
  }
  sum.spin -= (moment / test::mass_of(robot)).cross(sum.momentum);
  return sum;
}

TEST(FreeFall, FollowsTheSemiImplicitEulerClosedForm) {
  const RobotDescription robot = test::hand_built_robot();
  const SimOptions options = in_flight(1e-3);
  Simulator simulator(robot, {}, options);
  RobotState start = test::standing_state(robot, 1.0);
  start.v_WB = {0.5, -0.2, 1.0};
  simulator.reset(start);
  const int n = 500;
  for (int k = 0; k < n; ++k) simulator.step(Vec12::Zero());
  const RobotState end = simulator.state();
  const double t = n * options.dt;
  const Vec3 g(0.0, 0.0, -kGravity);
  EXPECT_LT((end.v_WB - (start.v_WB + t * g)).norm(), 1e-9);
  const Vec3 p = start.p_WB + t * start.v_WB + 0.5 * n * (n + 1) * options.dt * options.dt * g;
  EXPECT_LT((end.p_WB - p).norm(), 1e-9);
  EXPECT_LT((end.q - start.q).norm() + end.qd.norm() + end.omega_WB.norm(), 1e-9);
  // Semi-implicit Euler falls m g^2 t dt / 2 of energy too deep, exactly.
  const double lost = totals(robot, start).energy - totals(robot, end).energy;
  EXPECT_NEAR(lost, 0.5 * test::mass_of(robot) * kGravity * kGravity * t * options.dt, 1e-9);
}

// Error of the conserved quantities after 0.2 s of tumbling with swinging legs.
struct Drift {
  double energy, spin, momentum;
};

Drift drift_after_flight(double dt) {
  const RobotDescription robot = test::hand_built_robot();
  Simulator simulator(robot, {}, in_flight(dt));
  std::mt19937_64 random(6);
  const RobotState start = test::random_state(random);
  simulator.reset(start);
  const double duration = 0.2;
  for (int k = 0; k < std::lround(duration / dt); ++k) simulator.step(Vec12::Zero());
  const Totals before = totals(robot, start);
  const Totals after = totals(robot, simulator.state());
  const Vec3 fallen = before.momentum - test::mass_of(robot) * kGravity * duration * Vec3::UnitZ();
  return {std::abs(after.energy - before.energy), (after.spin - before.spin).norm(), (after.momentum - fallen).norm()};
}

TEST(Flight, EnergyAndMomentaAreConservedToFirstOrderInTheStep) {
  const Drift coarse = drift_after_flight(5e-4);
  const Drift fine = drift_after_flight(2.5e-4);
  EXPECT_NEAR(fine.energy / coarse.energy, 0.5, 0.05);
  EXPECT_NEAR(fine.spin / coarse.spin, 0.5, 0.05);
  EXPECT_NEAR(fine.momentum / coarse.momentum, 0.5, 0.05);
}

// The lower leg swings about a knee held by links a million times heavier; its weight, and nobody else's, is
// an applied force. Returns the mean period of five swings [s].
double measured_period(const RobotDescription& robot, double rest, double amplitude, double dt) {
  SimOptions options = in_flight(dt);
  options.gravity = 0.0;
  Simulator simulator(robot, {}, options);
  RobotState start;
  start.q[2] = rest + amplitude;
  simulator.reset(start);
  const LinkInertia& shank = robot.legs[0].links[2].inertia;
  const AppliedForce weight{0, LegLink::kLower, shank.com, {0.0, 0.0, -shank.mass * kGravity}};
  std::vector<double> downward;  // [s] zero crossings
  double previous = amplitude;
  while (downward.size() < 6) {
    simulator.step(Vec12::Zero(), {&weight, 1});
    const double angle = simulator.state().q[2] - rest;
    if (previous > 0.0 && angle <= 0.0) downward.push_back(simulator.time() + dt * angle / (previous - angle));
    previous = angle;
  }
  return (downward.back() - downward.front()) / 5.0;
}

TEST(Pendulum, ALegSwingsWithThePeriodOfThePhysicalPendulum) {
  RobotDescription robot = test::hand_built_robot();
  const auto hold_still = [](LinkDescription& link) {
    link.inertia.mass *= 1e6;
    link.inertia.inertia *= 1e6;
  };
  hold_still(robot.trunk);
  for (LegDescription& leg : robot.legs) {
    hold_still(leg.links[0]);
    hold_still(leg.links[1]);
  }
  const LinkInertia& shank = robot.legs[0].links[2].inertia;
  const double arm = shank.com.norm();
  const double inertia = shank.inertia(1, 1) + shank.mass * arm * arm;
  const double rest = std::atan2(-shank.com.x(), -shank.com.z());
  const double amplitude = 1.0;  // [rad], hence the elliptic integral
  const double period =
      4.0 * std::sqrt(inertia / (shank.mass * kGravity * arm)) * std::comp_ellint_1(std::sin(0.5 * amplitude));

  const double coarse = measured_period(robot, rest, amplitude, 1e-3) / period - 1.0;
  const double fine = measured_period(robot, rest, amplitude, 5e-4) / period - 1.0;
  EXPECT_LT(std::abs(coarse), 5e-5);
  EXPECT_NEAR(fine / coarse, 0.25, 0.05);  // the phase is of first order, the period of second
}

}  // namespace
}  // namespace dob::free_motion_test
