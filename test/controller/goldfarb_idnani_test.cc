// Hand-made problems whose answers are known in closed form, degenerate ones, and what must be refused.
#include "controller/goldfarb_idnani.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "controller/qp_certificate.h"
#include "test/support/qp_checks.h"
#include "test/support/random_qp.h"

namespace dob::test::goldfarb_idnani_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using SmallSolver = GoldfarbIdnani<2, 8>;
using SmallProblem = SmallSolver::Problem;
using SmallSolution = SmallSolver::Solution;
using Solver = GoldfarbIdnani<12, 44>;

void add_row(SmallProblem& qp, double lower, double a, double b, double upper) {
  qp.C.row(qp.rows) << a, b;
  qp.lower(qp.rows) = lower;
  qp.upper(qp.rows) = upper;
  ++qp.rows;
}

// Distance to the point (a, b): H = I, g = -(a, b).
SmallProblem nearest_to(double a, double b) {
  SmallProblem qp;
  qp.g << -a, -b;
  return qp;
}

SmallSolution solved(const SmallProblem& qp) {
  SmallSolver solver;
  SmallSolution solution;
  EXPECT_EQ(solver.solve(qp, solution), solution.status);
  return solution;
}

void expect_optimum(const SmallProblem& qp, double a, double b) {
  const SmallSolution solution = solved(qp);
  EXPECT_EQ(solution.status, QpStatus::kOptimal) << to_string(solution.status);
  EXPECT_NEAR(solution.x(0), a, 1e-13);
  EXPECT_NEAR(solution.x(1), b, 1e-13);
  EXPECT_LE(checked_kkt_residual(qp, solution), 1e-14);
}

void expect_infeasible(const SmallProblem& qp) {
  const SmallSolution solution = solved(qp);
  EXPECT_EQ(solution.status, QpStatus::kInfeasible) << to_string(solution.status);
  EXPECT_TRUE((is_contradiction<2, 8>(qp, solution.farkas)));
}

TEST(GoldfarbIdnani, WithoutRowsFindsTheUnconstrainedMinimum) {
  SmallProblem qp;
  qp.H << 4.0, 1.0, 1.0, 3.0;
  qp.g << -1.0, -2.0;
  expect_optimum(qp, 1.0 / 11.0, 7.0 / 11.0);
  EXPECT_EQ(solved(qp).iterations, 0);
}

TEST(GoldfarbIdnani, LeavesInactiveRowsWithoutMultipliers) {
  SmallProblem qp = nearest_to(1.0, 2.0);
  add_row(qp, -5.0, 1.0, 0.0, 5.0);
  add_row(qp, -kInf, 1.0, 1.0, kInf);
  expect_optimum(qp, 1.0, 2.0);
  EXPECT_EQ(solved(qp).multipliers.norm(), 0.0);
}

TEST(GoldfarbIdnani, MultipliersAreSignedBySide) {
  SmallProblem qp = nearest_to(3.0, -2.0);
  add_row(qp, -1.0, 1.0, 0.0, 1.0);
  add_row(qp, -1.0, 0.0, 2.0, 1.0);
  expect_optimum(qp, 1.0, -0.5);
  const SmallSolution solution = solved(qp);
  EXPECT_NEAR(solution.multipliers(0), 2.0, 1e-14);    // upper: 1 - 3 + y = 0
  EXPECT_NEAR(solution.multipliers(1), -0.75, 1e-14);  // lower: -0.5 + 2 + 2 y = 0
  EXPECT_EQ(solution.active.size, 2);
}

TEST(GoldfarbIdnani, DropsARowThatALaterOneMakesSlack) {
  SmallProblem qp;
  qp.H << 1.0, 0.0, 0.0, 0.01;
  add_row(qp, 1.0, 0.0, 1.0, kInf);   // the farther one: added first
  add_row(qp, 5.0, 10.0, 1.0, kInf);  // alone it leads to 5 / (n^T H^-1 n) H^-1 n = (0.25, 2.5)
  expect_optimum(qp, 0.25, 2.5);
  EXPECT_EQ(solved(qp).iterations, 3);
  EXPECT_EQ(solved(qp).active.size, 1);
}

TEST(GoldfarbIdnani, MeetsEqualitiesWhateverTheSignOfTheirMultiplier) {
  for (const double target : {-4.0, 4.0}) {
    SmallProblem qp = nearest_to(target, target);
    add_row(qp, 1.0, 1.0, 1.0, 1.0);
    add_row(qp, 0.0, 1.0, 0.0, 0.25);
    expect_optimum(qp, 0.25, 0.75);
  }
}

TEST(GoldfarbIdnani, AcceptsRepeatedEqualities) {
  SmallProblem qp = nearest_to(0.0, 0.0);
  for (const double scale : {1.0, -1.0, 1e6, 1e-6}) add_row(qp, scale, scale, scale, scale);
  expect_optimum(qp, 0.5, 0.5);
}

TEST(GoldfarbIdnani, AcceptsDuplicatedAndRedundantRows) {
  SmallProblem qp = nearest_to(2.0, 2.0);
  for (const double scale : {1.0, 1.0, 3.0, 1e-5}) add_row(qp, -kInf, scale, scale, scale);
  add_row(qp, -1.0, -1.0, -1.0, kInf);
  add_row(qp, -kInf, 1.0, 1.0, 1.5);
  add_row(qp, -kInf, 1.0, 0.0, 0.5);  // through the solution
  expect_optimum(qp, 0.5, 0.5);
}

TEST(GoldfarbIdnani, ScalingARowScalesOnlyItsMultiplier) {
  SmallProblem qp = nearest_to(3.0, 3.0);
  add_row(qp, -kInf, 1.0, 1.0, 2.0);
  for (const double scale : {1e-8, 1.0, 1e8}) {
    SmallProblem scaled = qp;
    scaled.C.row(0) *= scale;
    scaled.upper(0) *= scale;
    const SmallSolution solution = solved(scaled);
    ASSERT_EQ(solution.status, QpStatus::kOptimal);
    EXPECT_NEAR(solution.x(0), 1.0, 1e-14);
    EXPECT_NEAR(solution.multipliers(0) * scale, 2.0, 1e-13);
  }
}

TEST(GoldfarbIdnani, ProvesContradictionsWithACertificate) {
  SmallProblem slab = nearest_to(0.0, 0.0);
  add_row(slab, 1.0, 1.0, 1.0, kInf);
  add_row(slab, -kInf, 2.0, 2.0, 1.0);
  expect_infeasible(slab);

  SmallProblem triangle = nearest_to(5.0, 1.0);
  add_row(triangle, 1.0, 1.0, 0.0, kInf);
  add_row(triangle, 1.0, 0.0, 1.0, kInf);
  add_row(triangle, -kInf, 1.0, 1.0, 1.9);
  expect_infeasible(triangle);

  SmallProblem equalities = nearest_to(0.0, 0.0);
  add_row(equalities, 1.0, 1.0, 2.0, 1.0);
  add_row(equalities, 2.1, 2.0, 4.0, 2.1);
  expect_infeasible(equalities);
}

TEST(GoldfarbIdnani, AZeroRowIsFreeOrAContradiction) {
  SmallProblem qp = nearest_to(1.0, 2.0);
  add_row(qp, -1.0, 0.0, 0.0, 0.0);
  expect_optimum(qp, 1.0, 2.0);
  qp.lower(0) = -2.0;
  qp.upper(0) = -1.0;
  expect_infeasible(qp);
  qp.lower(0) = 1e-3;
  qp.upper(0) = kInf;
  expect_infeasible(qp);
}

// Four feet, each with the four facets of its friction pyramid and f_n >= 0. The nearest point of the pyramid to t is
// its apex exactly if t lies in the polar cone, t_n + mu (|t_x| + |t_y|) <= 0; there five rows meet in three variables.
TEST(GoldfarbIdnani, HoldsTheApexOfTheFrictionPyramids) {
  RandomQp<12, 44> random(1);
  Solver solver;
  Solver::Solution solution;
  for (int draw = 0; draw < 1000; ++draw) {
    Solver::Problem qp;
    const double mu = random.uniform(0.2, 1.0);
    for (int foot = 0; foot < 4; ++foot) {
      const int x = 3 * foot;
      for (int facet = 0; facet < 4; ++facet, ++qp.rows) {
        qp.C(qp.rows, x + facet / 2) = facet % 2 == 0 ? 1.0 : -1.0;
        qp.C(qp.rows, x + 2) = -mu;
        qp.upper(qp.rows) = 0.0;
      }
      qp.C(qp.rows, x + 2) = 1.0;
      qp.lower(qp.rows++) = 0.0;
      const Eigen::Vector3d target(random.normal(), random.normal(), 0.0);
      const double margin = random.chance(0.3) ? 0.0 : random.uniform(0.0, 1.0);
      qp.g.segment<3>(x) << -target.x(), -target.y(), mu * target.lpNorm<1>() + margin;
    }
    ASSERT_EQ(solver.solve(qp, solution), QpStatus::kOptimal);
    ASSERT_LE(solution.x.norm(), 1e-14);
    ASSERT_LE(checked_kkt_residual(qp, solution), 1e-14);
    ASSERT_LE(solution.iterations, 60);
  }
}

TEST(GoldfarbIdnani, TellsSingularHessiansApart) {
  SmallProblem qp;
  qp.H << 1.0, 2.0, 2.0, 4.0;
  EXPECT_EQ(solved(qp).status, QpStatus::kSingular);
  qp.H << 1.0, 0.0, 0.0, -1.0;
  EXPECT_EQ(solved(qp).status, QpStatus::kSingular);
  qp.H.setZero();
  EXPECT_EQ(solved(qp).status, QpStatus::kSingular);
  qp.H << 1e-12, 0.0, 0.0, 1e12;  // badly scaled, but definite
  EXPECT_EQ(solved(qp).status, QpStatus::kOptimal);
}

TEST(GoldfarbIdnani, StopsAtTheIterationLimit) {
  SmallProblem qp = nearest_to(9.0, 9.0);
  add_row(qp, -1.0, 1.0, 0.0, 1.0);
  add_row(qp, -1.0, 0.0, 1.0, 1.0);
  SmallSolution solution;
  SmallSolver limited({.iteration_limit = 1});
  EXPECT_EQ(limited.solve(qp, solution), QpStatus::kIterationLimit);
  EXPECT_EQ(solution.iterations, 1);
  SmallSolver enough({.iteration_limit = 2});
  EXPECT_EQ(enough.solve(qp, solution), QpStatus::kOptimal);
}

TEST(GoldfarbIdnani, RefusesInvalidInputAndLeavesTheSolutionAlone) {
  SmallProblem good = nearest_to(1.0, 1.0);
  add_row(good, 0.0, 1.0, 0.0, 0.5);
  good.C.row(1).setConstant(kNan);  // beyond the rows in use
  ASSERT_EQ(solved(good).status, QpStatus::kOptimal);
  const auto expect_refused = [&](auto spoil) {
    SmallProblem bad = good;
    spoil(bad);
    SmallSolver solver;
    SmallSolution solution;
    solution.status = QpStatus::kOptimal;
    solution.x << 7.0, 8.0;
    solution.iterations = 9;
    EXPECT_EQ(solver.solve(bad, solution), QpStatus::kInvalidInput);
    EXPECT_EQ(solution.status, QpStatus::kInvalidInput);
    EXPECT_EQ(solution.x(1), 8.0);
    EXPECT_EQ(solution.iterations, 9);
  };
  for (const double value : {kNan, kInf, -kInf}) {
    expect_refused([&](SmallProblem& qp) { qp.H(1, 0) = value; });
    expect_refused([&](SmallProblem& qp) { qp.H(0, 1) = value; });
    expect_refused([&](SmallProblem& qp) { qp.H(1, 1) = value; });
    expect_refused([&](SmallProblem& qp) { qp.g(0) = value; });
    expect_refused([&](SmallProblem& qp) { qp.C(0, 1) = value; });
  }
  expect_refused([](SmallProblem& qp) { qp.lower(0) = kNan; });
  expect_refused([](SmallProblem& qp) { qp.upper(0) = kNan; });
  expect_refused([](SmallProblem& qp) { qp.lower(0) = 0.6; });
  expect_refused([](SmallProblem& qp) { qp.lower(0) = qp.upper(0) = kInf; });
  expect_refused([](SmallProblem& qp) { qp.lower(0) = qp.upper(0) = -kInf; });
  expect_refused([](SmallProblem& qp) { qp.C.row(0) << 1e-180, 0.0; });
  expect_refused([](SmallProblem& qp) { qp.rows = -1; });
  expect_refused([](SmallProblem& qp) { qp.rows = 9; });
}

TEST(GoldfarbIdnani, RefusesNonsensicalOptions) {
  EXPECT_THROW(SmallSolver({.iteration_limit = 0}), std::invalid_argument);
  EXPECT_THROW(SmallSolver({.kkt_tolerance = 0.0}), std::invalid_argument);
  EXPECT_THROW(SmallSolver({.kkt_tolerance = kNan}), std::invalid_argument);
}

TEST(QpCertificate, RejectsWrongAnswers) {
  SmallProblem qp = nearest_to(3.0, 3.0);
  add_row(qp, -kInf, 1.0, 1.0, 2.0);
  const SmallSolution right = solved(qp);
  ASSERT_LE((kkt_residual<2, 8>(qp, right.x, right.multipliers)), 1e-15);
  SmallSolution wrong = right;
  wrong.x += SmallProblem::Vector(1e-6, -1e-6);
  EXPECT_NEAR((kkt_residual<2, 8>(qp, wrong.x, wrong.multipliers)), 1e-6 / 3.0, 1e-12);
  wrong = right;
  wrong.multipliers(0) = -wrong.multipliers(0);
  EXPECT_EQ((kkt_residual<2, 8>(qp, wrong.x, wrong.multipliers)), kInf);
  wrong.x(0) = kNan;
  EXPECT_FALSE((kkt_residual<2, 8>(qp, wrong.x, wrong.multipliers)) <= 1.0);
}

TEST(QpCertificate, RejectsWrongContradictions) {
  SmallProblem qp = nearest_to(0.0, 0.0);
  add_row(qp, 1.0, 1.0, 1.0, kInf);
  add_row(qp, -kInf, 1.0, 1.0, 0.0);
  const SmallProblem::Vector reach(1.0, 1.0);
  SmallProblem::RowVector y = SmallProblem::RowVector::Zero();
  y.head<2>() << -1.0, 1.0;
  EXPECT_TRUE((proves_infeasibility<2, 8>(qp, y, reach)));
  EXPECT_FALSE((proves_infeasibility<2, 8>(qp, -y, reach)));
  y(1) = 1.001;
  EXPECT_FALSE((proves_infeasibility<2, 8>(qp, y, reach)));
  y(1) = 1.0;
  qp.upper(1) = 1.0;  // feasible now
  EXPECT_FALSE((proves_infeasibility<2, 8>(qp, y, reach)));
}

}  // namespace
}  // namespace dob::test::goldfarb_idnani_test
