// The counter itself is tested in test/support/allocation_counter_test.cc.
#include <array>

#include <gtest/gtest.h>

#include "controller/goldfarb_idnani.h"
#include "test/support/allocation_counter.h"
#include "test/support/random_qp.h"

namespace dob::test {
namespace {

TEST(GoldfarbIdnani, SolvesWithoutTheHeapWhateverTheOutcome) {
  using Solver = GoldfarbIdnani<12, 44>;
  RandomQp<12, 44> random(9);
  Solver solver;
  Solver::Solution solution;
  std::array<int, 6> outcomes{};
  for (int draw = 0; draw < 2000; ++draw) {
    Solver::Problem qp = random.hostile();
    if (draw % 100 == 1) qp.H.setZero();
    if (draw % 100 == 2) qp.rows = -1;
    const AllocationCounter counter;
    const QpStatus status = solver.solve(qp, solution);
    solver.solve(qp, solution.active, solution);
    const long count = counter.count();
    ASSERT_EQ(count, 0);
    ++outcomes[static_cast<std::size_t>(status)];
  }
  EXPECT_GT(outcomes[static_cast<std::size_t>(QpStatus::kOptimal)], 1000);
  EXPECT_GT(outcomes[static_cast<std::size_t>(QpStatus::kInfeasible)], 200);
  EXPECT_GT(outcomes[static_cast<std::size_t>(QpStatus::kInaccurate)], 0);
  EXPECT_GT(outcomes[static_cast<std::size_t>(QpStatus::kSingular)], 0);
  EXPECT_GT(outcomes[static_cast<std::size_t>(QpStatus::kInvalidInput)], 0);
}

}  // namespace
}  // namespace dob::test
