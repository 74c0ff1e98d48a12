#include "controller/whole_body_controller.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "test/support/wbc_instances.h"

namespace dob {
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

TEST_F(WholeBodyControllerTest, AComEstimateReplacesTheStanceForcesInTheWrench) {
  const PerLeg<LegPoint> points = task_points(in.m, in.stance);
  Mat12 inverse;
  ASSERT_TRUE(inverse_jacobian_joints(in.m, points, inverse));
  in.estimate.has_legs = true;
  in.estimate.leg_torque = Vec12::LinSpaced(-3.0, 4.0);
  const Vec12 tip_force = inverse.transpose() * in.estimate.leg_torque;
  const Compensation legs = compensate(in.m, points, inverse, in.stance, in.estimate, Routing{}, true);
  EXPECT_LT((legs.wrench - com_wrench(in.m, points, tip_force)).norm(), 1e-9);
  EXPECT_TRUE(legs.dynamics.isZero(0.0));
  in.estimate.has_com = true;
  in.estimate.com_wrench << 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(compensate(in.m, points, inverse, in.stance, in.estimate, Routing{}, true).wrench, in.estimate.com_wrench);
}

// (31) by what it means: accelerations of the constrained robot with and without the force, from the KKT system of the
// full space.
TEST_F(WholeBodyControllerTest, SwingResponseIsTheConstrainedAccelerationOfTheForce) {
  in.stance = {false, true, true, false};
  const PerLeg<LegPoint> points = task_points(in.m, in.stance);
  const Vec12 force = Vec12::LinSpaced(-20.0, 30.0);
  const Vec12 response = swing_response(in.m, points, in.stance, force);
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

TEST_F(WholeBodyControllerTest, RefusesOptionsByName) {
  WbcOptions options;
  options.friction = 0.0;
  EXPECT_THROW(WholeBodyController(options, Routing{}), std::invalid_argument);
}

}  // namespace
}  // namespace dob
