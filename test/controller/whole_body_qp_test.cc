#include "controller/whole_body_qp.h"

#include <string>

#include <gtest/gtest.h>

#include "controller/goldfarb_idnani.h"
#include "test/controller/full_wbc_problem.h"

namespace dob::whole_body_qp_test {
namespace {

using test::WbcInstance;
using Source = Routing::WrenchSource;
using Swing = Routing::Swing;

struct Solved {
  WbcSolution wbc;
  WbcQpSolution qp;
  Vec12 torque;
};

// What WholeBodyController does at a tick with a due QP, step by step.
Solved solve(const WbcInstance& in, const WbcOptions& options, const Routing& routing) {
  const PerLeg<LegPoint> points = task_points(in.m, in.stance);
  TaskJacobian J;
  EXPECT_TRUE(J.factorize(in.m, points));
  const Compensation c = compensate(in.m, points, J, in.stance, in.estimate, routing, true);
  WholeBodyQp qp(options);
  qp.assemble(in.m, in.stance, in.reference, c, points, J);
  Solved s;
  GoldfarbIdnani<kWbcVariables, kWbcMaxRows> solver;
  solver.solve(qp.problem(), s.qp);
  s.wbc = qp.recover(s.qp.x, J);
  s.torque = in.m.M_q * s.wbc.qdd + in.m.c_q - joint_torques(in.m, points, s.wbc.foot_force) - c.torque;
  return s;
}

// One way of setting the controller's options.
struct Variant {
  std::string name;
  WbcOptions options;
  Routing routing;
};

// The printed routing and ours, then every other option by itself.
std::vector<Variant> variants(const Vec12& standing) {
  const Routing printed{.wrench_17 = true, .dynamics_18 = false, .torque_36 = false, .swing_31 = Swing::kProjected};
  const Routing ours{.wrench_17 = true, .dynamics_18 = true, .torque_36 = true, .swing_31 = Swing::kProjected};
  const Routing none{.wrench_17 = false, .dynamics_18 = false, .torque_36 = false, .swing_31 = Swing::kOff};
  std::vector<Variant> all{{"routing none", {}, none}, {"routing printed", {}, printed}, {"routing ours", {}, ours}};
  const auto with = [&](const char* name, auto change) {
    Variant v{name, {}, ours};
    change(v.options, v.routing);
    all.push_back(v);
  };
  with("swing direct", [](WbcOptions&, Routing& r) { r.swing_31 = Swing::kDirect; });
  with("wrench stance_legs", [](WbcOptions&, Routing& r) { r.wrench_source = Source::kStanceLegs; });
  with("wrench all_legs", [](WbcOptions&, Routing& r) { r.wrench_source = Source::kAllLegs; });
  with("coriolis", [](WbcOptions& o, Routing&) { o.coriolis = WbcOptions::Coriolis::kNeglected; });
  with("zyx", [](WbcOptions& o, Routing&) { o.orientation_error = WbcOptions::OrientationError::kZyxAngles; });
  with("no torque rows", [](WbcOptions& o, Routing&) { o.torque_rows = false; });
  with("printed sign", [](WbcOptions& o, Routing&) { o.printed_sign_21 = true; });
  with("weights", [](WbcOptions& o, Routing&) {
    o.regularization = 0.3;
    o.wrench_weight = 30.0;
    o.slack_weight = 1e7;
  });
  // Limits close around the standing pose, so that many joints are near or beyond them.
  const auto limit = [&](WbcOptions& o, Routing&) {
    o.joint_acceleration_limits = true;
    o.joint_limits.lower = standing.array() - 0.25;
    o.joint_limits.upper = standing.array() + 0.25;
    o.joint_limits.velocity.setConstant(3.0);
  };
  with("acceleration rows", limit);
  with("acceleration rows alone", [&](WbcOptions& o, Routing& r) {
    limit(o, r);
    o.torque_rows = false;
  });
  return all;
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
  int optimal = 0, active_friction = 0, active_torque = 0, active_acceleration = 0;
  const auto all = instances();
  ASSERT_GE(all.size(), 1000U);
  const auto ways = variants(all.front().m.state.q);  // the first one stands
  std::vector<int> solved(ways.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i % 3; k < ways.size(); k += 3) {
      Variant v = ways[k];
      // Every fourth instance has little friction and weak motors, so that rows (23) and (24) bind.
      if (i % 4 == 0) {
        v.options.friction = 0.1;
        v.options.torque_limit = 25.0;
        v.options.min_normal_force = 5.0;
      }
      const Solved s = solve(all[i], v.options, v.routing);
      if (s.qp.status == QpStatus::kInfeasible) continue;
      ASSERT_EQ(s.qp.status, QpStatus::kOptimal) << v.name << ", " << i << ": " << to_string(s.qp.status);
      ++optimal;
      ++solved[k];
      const test::FullProblem full = test::full_problem(all[i], v.options, v.routing);
      for (int a = 0; a < s.qp.active.size; ++a) {
        const int row = s.qp.active[a].row;
        ++(row < full.torque_row() ? active_friction
                                   : (row < full.acceleration_row() ? active_torque : active_acceleration));
      }
      ASSERT_LE(test::full_kkt_residual(full, all[i].stance, s.wbc, s.qp), 1e-8) << v.name << ", instance " << i;
    }
  }
  EXPECT_GE(optimal, 1000);
  EXPECT_GT(active_friction, 100);
  EXPECT_GT(active_torque, 100);
  EXPECT_GT(active_acceleration, 100);
  for (std::size_t k = 0; k < ways.size(); ++k) EXPECT_GE(solved[k], 100) << ways[k].name;
}

TEST(WholeBodyQp, ForcesAndTorquesAgreeWithAlglibOnTheFullProblem) {
  const auto all = instances();
  const auto ways = variants(all.front().m.state.q);  // the first one stands
  int compared = 0;
  std::vector<int> of_variant(ways.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Variant& v = ways[i % ways.size()];
    const Solved s = solve(all[i], v.options, v.routing);
    if (s.qp.status == QpStatus::kInfeasible) continue;
    const test::FullProblem full = test::full_problem(all[i], v.options, v.routing);
    const auto oracle = test::AlglibQp(full.as_dense()).solve_reference();
    if (!oracle) continue;  // ALGLIB found no acceptable answer; counted by the bound below
    ++compared;
    ++of_variant[i % ways.size()];
    const Eigen::VectorXd ours = test::full_point(full, all[i].stance, s.wbc);
    const Eigen::VectorXd difference = (ours - full.from_dense(*oracle)).eval();
    const Eigen::VectorXd torque_error = full.torque * difference;
    const Eigen::VectorXd force_error = difference.segment(18, 3 * full.n_stance);
    ASSERT_LE(force_error.lpNorm<Eigen::Infinity>(), 1e-3) << "N, " << v.name << ", instance " << i;
    ASSERT_LE(torque_error.cwiseAbs().maxCoeff(), 1e-3) << "N m, " << v.name << ", instance " << i;
  }
  EXPECT_GE(compared, 1000);
  for (std::size_t k = 0; k < ways.size(); ++k) EXPECT_GE(of_variant[k], 50) << ways[k].name;
}

TEST(WholeBodyQp, TorqueWithinLimitsIsTheTorqueSent) {
  std::mt19937_64 random(3);
  WbcOptions options;
  options.torque_limit = 25.0;
  const Routing routing{.dynamics_18 = true};
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

TEST(WholeBodyQp, WithContactRowsOnlyItIsAlwaysFeasible) {
  std::mt19937_64 random(5);
  WbcOptions options;
  options.torque_limit = 1.0;  // far too weak to carry
  options.min_normal_force = 200.0;
  int infeasible = 0;
  for (const WbcInstance& in : test::random_instances(200, random)) {
    const PerLeg<LegPoint> points = task_points(in.m, in.stance);
    TaskJacobian J;
    ASSERT_TRUE(J.factorize(in.m, points));
    WholeBodyQp qp(options);
    qp.assemble(in.m, in.stance, in.reference, {}, points, J);
    GoldfarbIdnani<kWbcVariables, kWbcMaxRows> solver;
    WbcQpSolution solution;
    infeasible += solver.solve(qp.problem(), solution) == QpStatus::kInfeasible ? 1 : 0;
    ASSERT_EQ(solver.solve(qp.with_contact_rows_only(), solution), QpStatus::kOptimal);
  }
  EXPECT_GT(infeasible, 0);
}

}  // namespace
}  // namespace dob::whole_body_qp_test
