#include "controller/whole_body_qp.h"

#include <gtest/gtest.h>

#include "controller/goldfarb_idnani.h"
#include "test/controller/full_wbc_problem.h"

namespace dob {
namespace {

using test::WbcInstance;

struct Solved {
  WbcSolution wbc;
  WbcQpSolution qp;
  Vec12 torque;
};

// What WholeBodyController does at a tick with a due QP, step by step.
Solved solve(const WbcInstance& in, const WbcOptions& options, const Routing& routing) {
  const PerLeg<LegPoint> points = task_points(in.m, in.stance);
  Mat12 inverse;
  EXPECT_TRUE(inverse_jacobian_joints(in.m, points, inverse));
  const Compensation c = compensate(in.m, points, inverse, in.stance, in.estimate, routing, true);
  WholeBodyQp qp(options);
  EXPECT_TRUE(qp.assemble(in.m, in.stance, in.reference, c, points, inverse));
  Solved s;
  GoldfarbIdnani<kWbcVariables, kWbcMaxRows> solver;
  solver.solve(qp.problem(), s.qp);
  s.wbc = qp.recover(s.qp.x);
  s.torque = in.m.M_q * s.wbc.qdd + in.m.c_q - joint_torques(in.m, points, s.wbc.foot_force) - c.torque;
  return s;
}

std::vector<Routing> routings() {
  return {{.wrench_17 = false, .dynamics_18 = false, .torque_36 = false, .swing_31 = Routing::Swing::kOff},
          {.wrench_17 = true, .dynamics_18 = false, .torque_36 = false, .swing_31 = Routing::Swing::kProjected},
          {.wrench_17 = true, .dynamics_18 = true, .torque_36 = true, .swing_31 = Routing::Swing::kProjected},
          {.wrench_17 = true, .dynamics_18 = true, .torque_36 = true, .swing_31 = Routing::Swing::kDirect}};
}

// Instances of real trots, and random ones; some of the latter have no feasible torques at all.
std::vector<WbcInstance> instances() {
  std::mt19937_64 random(7);
  std::vector<WbcInstance> all = test::recorded_instances(2.0, random);
  const std::vector<WbcInstance> more = test::random_instances(500, random);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(WholeBodyQp, ReducedSolutionSatisfiesTheFullProblemsKktConditions) {
  int optimal = 0, infeasible = 0, active_friction = 0, active_torque = 0;
  const auto all = instances();
  ASSERT_GE(all.size(), 1000U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Routing routing = routings()[i % 4];
    // Every third instance has little friction and weak motors, so that rows (23) and (24) bind.
    WbcOptions options;
    if (i % 3 == 0) {
      options.friction = 0.1;
      options.torque_limit = 25.0;
      options.min_normal_force = 5.0;
    }
    const Solved s = solve(all[i], options, routing);
    if (s.qp.status == QpStatus::kInfeasible) {
      ++infeasible;
      continue;
    }
    ASSERT_EQ(s.qp.status, QpStatus::kOptimal) << i << ": " << to_string(s.qp.status);
    ++optimal;
    const test::FullProblem full = test::full_problem(all[i], options, routing);
    for (int k = 0; k < s.qp.active.size; ++k) {
      ++(s.qp.active[k].row < full.torque_row() ? active_friction : active_torque);
    }
    ASSERT_LE(test::full_kkt_residual(full, all[i].stance, s.wbc, s.qp), 1e-8) << "instance " << i;
  }
  EXPECT_GE(optimal, 1000);
  EXPECT_GT(active_friction, 100);
  EXPECT_GT(active_torque, 100);
  RecordProperty("infeasible", infeasible);
}

TEST(WholeBodyQp, ForcesAndTorquesAgreeWithAlglibOnTheFullProblem) {
  int compared = 0;
  const auto all = instances();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Routing routing = routings()[i % 4];
    const WbcOptions options;
    const Solved s = solve(all[i], options, routing);
    if (s.qp.status == QpStatus::kInfeasible) continue;
    const test::FullProblem full = test::full_problem(all[i], options, routing);
    const auto oracle = test::AlglibQp(full.as_dense()).solve_reference();
    if (!oracle) continue;  // ALGLIB found no acceptable answer; counted by the bound below
    ++compared;
    const Eigen::VectorXd ours = test::full_point(full, all[i].stance, s.wbc);
    const Eigen::VectorXd difference = (ours - full.from_dense(*oracle)).eval();
    const Eigen::VectorXd torque_error = full.D.middleRows(full.torque_row(), kJoints) * difference;
    const Eigen::VectorXd force_error = difference.segment(18, 3 * full.n_stance);
    ASSERT_LE(force_error.lpNorm<Eigen::Infinity>(), 1e-3) << "N, instance " << i;
    ASSERT_LE(torque_error.cwiseAbs().maxCoeff(), 1e-3) << "N m, instance " << i;
  }
  EXPECT_GE(compared, 1000);
}

TEST(WholeBodyQp, TorqueWithinLimitsIsTheTorqueSent) {
  std::mt19937_64 random(3);
  WbcOptions options;
  options.torque_limit = 25.0;
  const Routing routing = routings()[2];
  int at_limit = 0;
  for (const WbcInstance& in : test::random_instances(200, random)) {
    const Solved s = solve(in, options, routing);
    if (s.qp.status != QpStatus::kOptimal) continue;
    const double largest = s.torque.cwiseAbs().maxCoeff();
    ASSERT_LE(largest, options.torque_limit + 1e-6);
    at_limit += largest > options.torque_limit - 1e-6 ? 1 : 0;
  }
  EXPECT_GT(at_limit, 20);
}

TEST(WholeBodyQp, WithoutTorqueRowsItIsAlwaysFeasible) {
  std::mt19937_64 random(5);
  WbcOptions options;
  options.torque_limit = 1.0;  // far too weak to carry
  options.min_normal_force = 200.0;
  int infeasible = 0;
  for (const WbcInstance& in : test::random_instances(200, random)) {
    const PerLeg<LegPoint> points = task_points(in.m, in.stance);
    Mat12 inverse;
    ASSERT_TRUE(inverse_jacobian_joints(in.m, points, inverse));
    WholeBodyQp qp(options);
    ASSERT_TRUE(qp.assemble(in.m, in.stance, in.reference, {}, points, inverse));
    GoldfarbIdnani<kWbcVariables, kWbcMaxRows> solver;
    WbcQpSolution solution;
    infeasible += solver.solve(qp.problem(), solution) == QpStatus::kInfeasible ? 1 : 0;
    ASSERT_EQ(solver.solve(qp.without_torque_rows(), solution), QpStatus::kOptimal);
  }
  EXPECT_GT(infeasible, 0);
}

}  // namespace
}  // namespace dob
