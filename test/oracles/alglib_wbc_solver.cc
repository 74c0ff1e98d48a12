#include "test/oracles/alglib_wbc_solver.h"

#include <exception>

#include "test/oracles/alglib_qp.h"

namespace dob::test {

QpStatus AlglibWbcSolver::solve(const WbcProblem& problem, const WbcActiveSet& /*guess*/,
                                WbcQpSolution& solution) noexcept {
  solution = {};
  solution.status = QpStatus::kInaccurate;
  try {
    if (const auto x = AlglibQp(dense(problem)).solve_reference()) {
      solution.x = *x;
      solution.status = QpStatus::kOptimal;
    }
  } catch (const std::exception&) {  // of the heap or of ALGLIB: no answer
    solution.status = QpStatus::kInaccurate;
  }
  return solution.status;
}

}  // namespace dob::test
