#include "controller/whole_body_controller.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "bench/trial.h"
#include "controller/acceleration_limits.h"
#include "scenarios/loader.h"
#include "test/support/wbc_instances.h"

namespace dob::whole_body_controller_test {
namespace {

class WholeBodyControllerTest : public ::testing::Test {
 protected:
  std::mt19937_64 random{11};
  test::WbcInstance in = test::recorded_instances(0.01, random).front();  // standing on all feet

  void SetUp() override { in.estimate = {}; }
};

TEST_F(WholeBodyControllerTest, SolvesAtFourHundredHertzOnTheGridOfTicks) {
  WholeBodyController controller(WbcOptions{}, Routing{});
  std::vector<long> solved;
  for (long k = 0; k < 1000; ++k) {
    if (controller.update(k, 1e-3, in.m, in.stance, in.reference, in.estimate).event == QpEvent::kSolved) {
      solved.push_back(k);
    }
  }
  ASSERT_EQ(solved.size(), 400U);
  EXPECT_EQ(std::vector<long>(solved.begin(), solved.begin() + 5), (std::vector<long>{0, 3, 5, 8, 10}));
}

TEST_F(WholeBodyControllerTest, SolvesAtOnceWhenTheStanceSetChanges) {
  WholeBodyController controller(WbcOptions{}, Routing{});
  controller.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  in.stance[0] = false;
  EXPECT_EQ(controller.update(1, 1e-3, in.m, in.stance, in.reference, in.estimate).event, QpEvent::kSolved);
  EXPECT_EQ(controller.update(2, 1e-3, in.m, in.stance, in.reference, in.estimate).event, QpEvent::kHeld);
}

TEST_F(WholeBodyControllerTest, InfeasibleTorquesAreRelaxedAndReported) {
  WbcOptions options;
  options.torque_limit = 2.0;
  options.min_normal_force = 100.0;
  WholeBodyController controller(options, Routing{});
  const WbcTick tick = controller.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  EXPECT_EQ(tick.event, QpEvent::kTorqueRelaxed);
  EXPECT_EQ(tick.qp_status, QpStatus::kInfeasible);
  EXPECT_LE(tick.torque.cwiseAbs().maxCoeff(), 2.0);
}

TEST_F(WholeBodyControllerTest, UnusableInputHoldsTheLastSolution) {
  WholeBodyController controller(WbcOptions{}, Routing{});
  controller.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  const Vec12 force = controller.solution().foot_force;
  in.reference.com.p.x() = std::numeric_limits<double>::quiet_NaN();
  const WbcTick tick = controller.update(3, 1e-3, in.m, in.stance, in.reference, in.estimate);
  EXPECT_EQ(tick.event, QpEvent::kNotSolved);
  EXPECT_EQ(controller.solution().foot_force, force);
  EXPECT_TRUE(tick.torque.allFinite());
}

// (36) and (17): with the routing's torque row, what the compensation takes from the ground reaction forces it also
// takes from the torques; without it the difference is J_st,j^T f_hat exactly.
TEST_F(WholeBodyControllerTest, TorqueRoutingSubtractsTheStanceEstimate) {
  in.estimate.has_legs = true;
  in.estimate.leg_torque = Vec12::LinSpaced(-3.0, 4.0);
  Routing with, without;
  without.torque_36 = false;
  WholeBodyController a(WbcOptions{}, with), b(WbcOptions{}, without);
  const Vec12 difference = b.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate).torque -
                           a.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate).torque;
  EXPECT_LT((difference - in.estimate.leg_torque).cwiseAbs().maxCoeff(), 1e-9);  // all feet stand
}

// What a compensation path of the routing sees of the estimate.
class RoutingTest : public WholeBodyControllerTest {
 protected:
  void SetUp() override {
    in.stance = {false, true, true, false};
    in.estimate.has_legs = true;
    in.estimate.leg_torque = Vec12::LinSpaced(-3.0, 4.0);
    in.estimate.com_wrench << 1, 2, 3, 4, 5, 6;
    points = task_points(in.m, in.stance);
    ASSERT_TRUE(J.factorize(in.m, points));
    tip_force = jacobian_joints(in.m, points).transpose().fullPivLu().solve(in.estimate.leg_torque);
    stance_force = tip_force;
    for (const int l : {0, 3}) stance_force.segment<3>(3 * l).setZero();
  }
  Compensation compensated(const Routing& routing) const {
    return compensate(in.m, points, J, in.stance, in.estimate, routing, true);
  }

  PerLeg<LegPoint> points;
  TaskJacobian J;
  Vec12 tip_force, stance_force;
};

TEST_F(RoutingTest, AComEstimateReplacesTheStanceForcesInTheWrench) {
  EXPECT_LT((compensated({}).wrench - com_wrench(in.m, points, stance_force)).norm(), 1e-9);
  in.estimate.has_com = true;
  EXPECT_EQ(compensated({}).wrench, in.estimate.com_wrench);
}

TEST_F(RoutingTest, FromTheStanceLegsIgnoresAComEstimate) {
  in.estimate.has_com = true;
  const Routing routing{.wrench_source = Routing::WrenchSource::kStanceLegs};
  EXPECT_LT((compensated(routing).wrench - com_wrench(in.m, points, stance_force)).norm(), 1e-9);
}

TEST_F(RoutingTest, FromAllLegsCountsTheSwingingOnes) {
  in.estimate.has_com = true;
  const Routing routing{.wrench_source = Routing::WrenchSource::kAllLegs};
  EXPECT_LT((compensated(routing).wrench - com_wrench(in.m, points, tip_force)).norm(), 1e-9);
}

TEST_F(RoutingTest, SendsTheSameWrenchToTheCostAndToTheDynamics) {
  EXPECT_TRUE(compensated({}).dynamics.isZero(0.0));
  const Routing both{.wrench_17 = true, .dynamics_18 = true};
  EXPECT_EQ(compensated(both).dynamics, compensated(both).wrench);
  EXPECT_TRUE(compensated({.wrench_17 = false, .dynamics_18 = true}).wrench.isZero(0.0));
}

// (31) by what it means: accelerations of the constrained robot with and without the force, from the KKT system of the
// full space.
TEST_F(WholeBodyControllerTest, SwingResponseIsTheConstrainedAccelerationOfTheForce) {
  in.stance = {false, true, true, false};
  const PerLeg<LegPoint> points = task_points(in.m, in.stance);
  TaskJacobian factored;
  ASSERT_TRUE(factored.factorize(in.m, points));
  const Vec12 force = Vec12::LinSpaced(-20.0, 30.0);
  const Vec12 response = swing_response(in.m, points, factored, in.stance, force);
  Mat3x18 J;
  const auto jacobian = [&](int l) {
    J.setZero();
    J.leftCols<3>().setIdentity();
    J.middleCols<3>(3) = -skew(points[l].p - in.m.state.p_WB);
    J.middleCols<3>(6 + 3 * l) = points[l].J_q;
    return J;
  };
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(24, 24);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(24);
  kkt.topLeftCorner<18, 18>() = in.m.mass_matrix();
  int row = 18;
  for (const int l : {1, 2}) {
    kkt.block<3, 18>(row, 0) = jacobian(l);
    kkt.block<18, 3>(0, row) = -jacobian(l).transpose();
    row += 3;
  }
  for (const int l : {0, 3}) right.head<18>() += jacobian(l).transpose() * force.segment<3>(3 * l);
  const Eigen::VectorXd v_dot = kkt.fullPivLu().solve(right).head<18>();
  for (const int l : {0, 3}) EXPECT_LT((jacobian(l) * v_dot - response.segment<3>(3 * l)).norm(), 1e-8);
  for (const int l : {1, 2}) EXPECT_TRUE(response.segment<3>(3 * l).isZero(0.0));
}

// (16), term by term: the reference's lead pulls, the body's own pushes back, the weight is carried.
TEST_F(WholeBodyControllerTest, DesiredWrenchPullsTowardsTheReferenceAndCarriesTheWeight) {
  WbcOptions options;
  options.wrench_kp << 100.0, 110.0, 120.0, 130.0, 140.0, 150.0;
  options.wrench_kd << 10.0, 11.0, 12.0, 13.0, 14.0, 15.0;
  in.m.p_com = in.reference.com.p;
  in.m.state.R_WB = in.reference.R_WB;
  in.m.v_c.head<3>() = in.reference.com.v;
  in.m.state.omega_WB = in.reference.omega;
  in.reference.com.a.setZero();
  in.reference.alpha.setZero();
  Vec6 weight = Vec6::Zero();
  weight[2] = in.m.mass * kGravity;
  const auto added = [&](const ModelTerms& m, const MotionReference& reference) {
    return Vec6(desired_wrench(m, reference, options) - weight);
  };
  EXPECT_LT(added(in.m, in.reference).norm(), 1e-9);

  const Vec3 ahead(0.02, -0.03, 0.04);
  ModelTerms behind = in.m;
  behind.p_com -= ahead;
  EXPECT_LT((added(behind, in.reference).head<3>() - Vec3(2.0, -3.3, 4.8)).norm(), 1e-9);
  ModelTerms slow = in.m;
  slow.v_c.head<3>() -= ahead;
  slow.state.omega_WB -= 10.0 * ahead;
  EXPECT_LT((added(slow, in.reference).head<3>() - Vec3(0.2, -0.33, 0.48)).norm(), 1e-9);
  EXPECT_LT((added(slow, in.reference).tail<3>() - Vec3(2.6, -4.2, 6.0)).norm(), 1e-9);
  MotionReference accelerating = in.reference;
  accelerating.com.a = ahead;
  accelerating.alpha = ahead;
  EXPECT_LT((added(in.m, accelerating).head<3>() - in.m.mass * ahead).norm(), 1e-9);
  EXPECT_LT((added(in.m, accelerating).tail<3>() - in.m.I_c * ahead).norm(), 1e-9);
}

// (16) as printed: a difference of angles, each taken the short way round.
TEST_F(WholeBodyControllerTest, ZyxAnglesAreSubtractedOneByOne) {
  const auto rotation = [](double roll, double pitch, double yaw) {
    return Mat3(Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
                Eigen::AngleAxisd(roll, Vec3::UnitX()));
  };
  WbcOptions printed;
  printed.orientation_error = WbcOptions::OrientationError::kZyxAngles;
  printed.wrench_kd.setZero();
  WbcOptions vector = printed;
  vector.orientation_error = WbcOptions::OrientationError::kRotationVector;
  in.m.state.R_WB = rotation(0.1, -0.2, 3.0);
  in.reference.R_WB = rotation(0.3, 0.1, -3.0);
  const Vec3 error = desired_wrench(in.m, in.reference, printed).tail<3>() / 250.0;
  EXPECT_LT((error - Vec3(0.2, 0.3, 2.0 * std::acos(-1.0) - 6.0)).norm(), 1e-12);
  EXPECT_GT((error - desired_wrench(in.m, in.reference, vector).tail<3>() / 250.0).norm(), 0.05);
  // About one axis alone the two are the same.
  in.m.state.R_WB = rotation(0.0, 0.0, 0.5);
  in.reference.R_WB = rotation(0.0, 0.0, 0.9);
  EXPECT_LT((desired_wrench(in.m, in.reference, printed) - desired_wrench(in.m, in.reference, vector)).norm(), 1e-10);
}

TEST_F(WholeBodyControllerTest, NeglectedCoriolisTermsAreMissingFromTheTorque) {
  in.m.c_q = Vec12::LinSpaced(-1.0, 1.0);
  WbcOptions neglected;
  neglected.coriolis = WbcOptions::Coriolis::kNeglected;
  WholeBodyController a(WbcOptions{}, Routing{}), b(neglected, Routing{});
  const Vec12 difference = a.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate).torque -
                           b.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate).torque;
  EXPECT_LT((difference - in.m.c_q).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(WholeBodyControllerTest, HeldTorqueChangesAtSolvesOnly) {
  WbcOptions held;
  held.torque_between_solves = WbcOptions::BetweenSolves::kHeld;
  WholeBodyController a(WbcOptions{}, Routing{}), b(held, Routing{});
  const auto torque = [&](WholeBodyController& c, long k) {
    return c.update(k, 1e-3, in.m, in.stance, in.reference, in.estimate).torque;
  };
  const Vec12 first = torque(a, 0);
  EXPECT_EQ(torque(b, 0), first);
  in.m.c_q.array() += 0.5;
  EXPECT_LT((torque(a, 1) - first - Vec12::Constant(0.5)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(torque(b, 1), first);
  EXPECT_EQ(torque(b, 2), first);
  EXPECT_NE(torque(b, 3), first);
}

TEST_F(WholeBodyControllerTest, WithoutTorqueRowsTheTorqueSaturatesUnseen) {
  WbcOptions options;
  options.torque_limit = 2.0;
  options.min_normal_force = 100.0;  // infeasible with the rows, see above
  options.torque_rows = false;
  WholeBodyController controller(options, Routing{});
  const WbcTick tick = controller.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  EXPECT_EQ(tick.event, QpEvent::kSolved);
  EXPECT_DOUBLE_EQ(tick.torque.cwiseAbs().maxCoeff(), 2.0);
}

TEST_F(WholeBodyControllerTest, AJointBeyondItsLimitDoesNotAccelerateFurther) {
  in.stance = {false, true, true, false};
  for (const int l : {0, 3}) in.reference.foot[l] = {in.m.foot[l].p, Vec3::Zero(), Vec3(40.0, 30.0, 60.0)};
  WbcOptions options;
  options.torque_rows = false;
  WholeBodyController free(options, Routing{});
  free.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  const Vec12 wanted = free.solution().qdd;
  // Both swinging legs are beyond a limit on the side that they want to go to.
  options.joint_acceleration_limits = true;
  for (int j = 0; j < kJoints; ++j) {
    if (in.stance[j / 3]) continue;
    ASSERT_GT(std::abs(wanted[j]), 1.0) << "joint " << j;
    (wanted[j] > 0.0 ? options.joint_limits.upper : options.joint_limits.lower)[j] =
        in.m.state.q[j] + (wanted[j] > 0.0 ? -0.01 : 0.01);
  }
  WholeBodyController limited(options, Routing{});
  const WbcTick tick = limited.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  EXPECT_EQ(tick.event, QpEvent::kSolved);
  for (int j = 0; j < kJoints; ++j) {
    if (in.stance[j / 3]) continue;
    EXPECT_LE(limited.solution().qdd[j] * (wanted[j] > 0.0 ? 1.0 : -1.0), 1e-6) << "joint " << j;
  }
}

// The feet are to push harder than the weight, so that the trunk rises and some joint goes further beyond its limit.
TEST_F(WholeBodyControllerTest, AccelerationRowsAreTheFirstToGo) {
  WbcOptions options;
  options.joint_acceleration_limits = true;
  options.joint_limits.lower = in.m.state.q.array() + 0.1;
  options.joint_limits.upper = in.m.state.q.array() + 0.2;
  options.min_normal_force = 70.0;
  const auto event = [&] {
    WholeBodyController controller(options, Routing{});
    return controller.update(0, 1e-3, in.m, in.stance, in.reference, in.estimate);
  };
  const WbcTick tick = event();
  EXPECT_EQ(tick.event, QpEvent::kAccelerationRelaxed);
  EXPECT_EQ(tick.qp_status, QpStatus::kInfeasible);
  options.torque_limit = 2.0;
  EXPECT_EQ(event().event, QpEvent::kTorqueRelaxed);
}

// Whatever the joints' positions and rates are, no bound demands a motion.
TEST_F(WholeBodyControllerTest, AccelerationLimitsContainRest) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  WbcOptions options;
  options.joint_limits = {.lower = Vec12::Constant(-0.5), .upper = Vec12::Constant(0.5), .velocity = Vec12::Ones()};
  for (int draw = 0; draw < 1000; ++draw) {
    RobotState state;
    Vec12 rest;
    for (int j = 0; j < kJoints; ++j) {
      state.q[j] = uniform(random);
      state.qd[j] = 3.0 * uniform(random);
      rest[j] = 100.0 * uniform(random);
    }
    const AccelerationLimits limits = acceleration_limits(state, rest, options);
    ASSERT_LE((limits.lower - rest).maxCoeff(), 0.0);
    ASSERT_GE((limits.upper - rest).minCoeff(), 0.0);
  }
  // At rest, half a radian from the limit: 2 * 0.5 / T^2 for the position, 1 / T for the velocity.
  const AccelerationLimits middle = acceleration_limits(RobotState{}, Vec12::Zero(), options);
  EXPECT_DOUBLE_EQ(middle.upper[0], 1.0 / 0.025);
  options.joint_limits.velocity.setConstant(1e3);
  EXPECT_DOUBLE_EQ(acceleration_limits(RobotState{}, Vec12::Zero(), options).lower[0], -1.0 / (0.025 * 0.025));
}

// Errata: with the printed sign of (21) the predicted CoM falls when the ground pushes.
TEST(PrintedSignOfEquation21, MakesTheRobotCollapse) {
  Scenario scenario = load_scenarios({.name = "undisturbed", .gains = "", .planner = "", .overrides = {}}).front();
  scenario.duration = 1.0;
  const ObserverConfig none = load_observer("none", "paper");
  EXPECT_EQ(Trial(scenario, none, 1).run().outcome, Outcome::kSurvived);
  scenario.controller.printed_sign_21 = true;
  EXPECT_EQ(Trial(scenario, none, 1).run().outcome, Outcome::kFell);
}

TEST_F(WholeBodyControllerTest, RefusesOptionsByName) {
  WbcOptions options;
  options.friction = 0.0;
  EXPECT_THROW(WholeBodyController(options, Routing{}), std::invalid_argument);
  options = {};
  options.acceleration_horizon = 0.0;
  EXPECT_THROW(WholeBodyController(options, Routing{}), std::invalid_argument);
  options = {};
  options.joint_limits.velocity[7] = 0.0;
  EXPECT_THROW(WholeBodyController(options, Routing{}), std::invalid_argument);
}

}  // namespace
}  // namespace dob::whole_body_controller_test
