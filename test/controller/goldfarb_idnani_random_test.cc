// Random problems: with solutions known by construction, against ALGLIB, and as hostile as we can make them.
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "controller/goldfarb_idnani.h"
#include "test/oracles/alglib_qp.h"
#include "test/support/draws.h"
#include "test/support/qp_checks.h"
#include "test/support/random_qp.h"

namespace dob::test::goldfarb_idnani_random_test {
namespace {

using Solver = GoldfarbIdnani<12, 44>;

class KnownSolution : public testing::TestWithParam<double> {};

TEST_P(KnownSolution, IsFoundToWorkingPrecision) {
  const double condition = GetParam();
  // g carries rounding errors of |H| |x|, which H^-1 amplifies by the condition number.
  const double tolerance = 100.0 * condition * std::numeric_limits<double>::epsilon();
  RandomQp<12, 44> random(2);
  Solver solver;
  Solver::Solution solution;
  for (int draw = 0; draw < 500; ++draw) {
    const auto known = random.known(44, random.integer(0, 11), condition);
    ASSERT_EQ(solver.solve(known.qp, solution), QpStatus::kOptimal);
    ASSERT_LE((solution.x - known.x).norm(), tolerance * std::max(1.0, known.x.norm()));
    ASSERT_LE(checked_kkt_residual(known.qp, solution), 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Conditions, KnownSolution, testing::Values(1e2, 1e4, 1e6, 1e8));

TEST(GoldfarbIdnaniRandom, AWarmStartFromTheAnswerNeedsNoIterations) {
  RandomQp<12, 44> random(3);
  Solver solver;
  Solver::Solution solution;
  for (int draw = 0; draw < 500; ++draw) {
    const auto known = random.known(44, random.integer(0, 11), 1e3);
    ASSERT_EQ(solver.solve(known.qp, solution), QpStatus::kOptimal);
    ASSERT_EQ(solver.solve(known.qp, solution.active, solution), QpStatus::kOptimal);
    ASSERT_EQ(solution.iterations, 0);
    ASSERT_LE((solution.x - known.x).norm(), 1e-11 * std::max(1.0, known.x.norm()));
  }
}

TEST(GoldfarbIdnaniRandom, AnyGuessLeadsToTheSameAnswer) {
  RandomQp<12, 44> random(4);
  Solver solver;
  Solver::Solution solution;
  for (int draw = 0; draw < 500; ++draw) {
    const auto known = random.known(44, random.integer(0, 11), 1e3);
    QpActiveSet<12> guess;
    guess.size = random.integer(-1, 15);
    for (QpActiveRow& row : guess.rows) {
      row = {random.integer(-2, 46), random.chance(0.5) ? QpSide::kLower : QpSide::kUpper};
    }
    ASSERT_EQ(solver.solve(known.qp, guess, solution), QpStatus::kOptimal);
    ASSERT_LE((solution.x - known.x).norm(), 1e-11 * std::max(1.0, known.x.norm()));
  }
}

TEST(GoldfarbIdnaniRandom, GivesTheSameBitsWhateverWasSolvedBefore) {
  RandomQp<12, 44> random(5);
  Solver used;
  Solver::Solution first;
  Solver::Solution second;
  for (int draw = 0; draw < 200; ++draw) {
    const auto qp = random.hostile();
    used.solve(qp, first);
    Solver fresh;
    second = {};
    fresh.solve(qp, second);
    ASSERT_EQ(first.status, second.status);
    ASSERT_EQ(first.x, second.x);
    ASSERT_EQ(first.multipliers, second.multipliers);
    ASSERT_EQ(first.iterations, second.iterations);
  }
}

TEST(GoldfarbIdnaniRandom, AgreesWithAlglib) {
  RandomQp<12, 44> random(6);
  Solver solver;
  Solver::Solution solution;
  double worst = 0.0;
  for (int draw = 0; draw < 1000; ++draw) {
    const auto known = random.known(44, random.integer(0, 11), random.log_uniform(1.0, 1e3));
    ASSERT_EQ(solver.solve(known.qp, solution), QpStatus::kOptimal);
    const auto reference = AlglibQp(dense(known.qp)).solve_reference();
    ASSERT_TRUE(reference.has_value());
    worst = std::max(worst, (solution.x - *reference).norm());
  }
  EXPECT_LE(worst, 1e-6);
}

// What came out of a hostile sweep.
struct Tally {
  int optimal = 0;
  int infeasible = 0;
  int inaccurate = 0;
  int other = 0;
};

template <int N, int M>
Tally sweep_hostile(std::uint64_t seed, int problems) {
  RandomQp<N, M> random(seed);
  GoldfarbIdnani<N, M> solver;
  QpSolution<N, M> solution;
  Tally tally;
  for (int draw = 0; draw < problems; ++draw) {
    const QpProblem<N, M> qp = random.hostile();
    switch (solver.solve(qp, solution)) {
      case QpStatus::kOptimal:
        ++tally.optimal;
        EXPECT_LE(checked_kkt_residual(qp, solution), 1e-8) << "draw " << draw;
        break;
      case QpStatus::kInfeasible:
        ++tally.infeasible;
        EXPECT_TRUE((is_contradiction<N, M>(qp, solution.farkas))) << "draw " << draw;
        break;
      case QpStatus::kInaccurate:
        ++tally.inaccurate;
        break;
      default:
        ++tally.other;
    }
  }
  testing::Test::RecordProperty("inaccurate", tally.inaccurate);
  return tally;
}

TEST(GoldfarbIdnaniRandom, NeverClaimsMoreThanItCanProveOnHostileProblems) {
  constexpr int kLarge = draws(20000);
  constexpr int kSmall = draws(80000);
  const Tally large = sweep_hostile<12, 44>(7, kLarge);
  const Tally small = sweep_hostile<2, 8>(8, kSmall);
  EXPECT_EQ(large.other + small.other, 0);
  EXPECT_LE(large.inaccurate, 0.03 * kLarge);
  EXPECT_LE(small.inaccurate, 0.004 * kSmall);
  EXPECT_GE(large.optimal, 0.6 * kLarge);
  EXPECT_GE(large.infeasible, 0.2 * kLarge);
  EXPECT_GE(small.optimal, 0.6 * kSmall);
  EXPECT_GE(small.infeasible, 0.1 * kSmall);
}

}  // namespace
}  // namespace dob::test::goldfarb_idnani_random_test
