// The seam for solvers of the whole-body quadratic problem; how another one is added: docs/adding-a-qp-solver.md.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "controller/wbc_problem.h"

namespace dob {

class WbcQpSolver {
 public:
  WbcQpSolver() = default;
  WbcQpSolver(const WbcQpSolver&) = delete;
  WbcQpSolver& operator=(const WbcQpSolver&) = delete;
  virtual ~WbcQpSolver() = default;

  // Solves `problem` and returns solution.status. `guess` is the active set of the previous solve with the same rows,
  // empty when there is none; it may be ignored, and must not change the answer. x counts if and only if the status is
  // kOptimal. solution.active may be left empty: then the next guess is. May keep its workspace from call to call, but
  // the answer depends on the arguments only.
  virtual QpStatus solve(const WbcProblem& problem, const WbcActiveSet& guess, WbcQpSolution& solution) noexcept = 0;
};

struct WbcSolverInfo {
  std::string_view name;
  std::string_view summary;  // one line
};

inline constexpr std::string_view kDefaultWbcSolver = "goldfarb_idnani";

// Those that make_wbc_solver() makes, the default first.
const std::vector<WbcSolverInfo>& wbc_solvers();

// Throws std::invalid_argument naming the solvers there are.
std::unique_ptr<WbcQpSolver> make_wbc_solver(std::string_view name = kDefaultWbcSolver);

}  // namespace dob
