#include "controller/wbc_solver.h"

#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "controller/goldfarb_idnani.h"

namespace dob {
namespace {

class GoldfarbIdnaniBackend final : public WbcQpSolver {
 public:
  QpStatus solve(const WbcProblem& problem, const WbcActiveSet& guess, WbcQpSolution& solution) noexcept override {
    return solver_.solve(problem, guess, solution);
  }

 private:
  GoldfarbIdnani<kWbcVariables, kWbcMaxRows> solver_;
};

}  // namespace

const std::vector<WbcSolverInfo>& wbc_solvers() {
  static const std::vector<WbcSolverInfo> solvers{
      {kDefaultWbcSolver, "dual active set, fixed size, warm-started, no heap"}};
  return solvers;
}

std::unique_ptr<WbcQpSolver> make_wbc_solver(std::string_view name) {
  if (name == kDefaultWbcSolver) return std::make_unique<GoldfarbIdnaniBackend>();
  std::vector<std::string_view> names;
  for (const WbcSolverInfo& info : wbc_solvers()) names.push_back(info.name);
  throw std::invalid_argument(fmt::format("there is no QP solver '{}'; there are: {}", name, fmt::join(names, ", ")));
}

}  // namespace dob
