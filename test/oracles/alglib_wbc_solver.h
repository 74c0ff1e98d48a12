// ALGLIB behind the controller's solver seam, for closed loops in tests. ALGLIB is GPL: never installed.
#pragma once

#include "controller/wbc_solver.h"

namespace dob::test {

// Ignores the guess, reports no active set. Uses the heap. No answer: kInaccurate, whatever the reason.
class AlglibWbcSolver final : public WbcQpSolver {
 public:
  QpStatus solve(const WbcProblem& problem, const WbcActiveSet& guess, WbcQpSolution& solution) noexcept override;
};

}  // namespace dob::test
