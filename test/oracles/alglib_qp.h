// ALGLIB's dense QP solvers as an independent oracle. ALGLIB is GPL: for tests and benchmarks only, never installed.
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "controller/qp.h"

namespace dob::test {

// The problem of controller/qp.h with sizes known at run time only.
struct DenseQp {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  Eigen::MatrixXd C;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;

  double violation(const Eigen::VectorXd& x) const;  // largest, absolute; 0 if x is feasible
  double objective(const Eigen::VectorXd& x) const { return 0.5 * x.dot(H * x) + g.dot(x); }
};

template <int N, int MaxRows>
DenseQp dense(const QpProblem<N, MaxRows>& qp) {
  return {qp.H, qp.g, qp.C.topRows(qp.rows), qp.lower.head(qp.rows), qp.upper.head(qp.rows)};
}

// Settings of the augmented-Lagrangian solver.
struct AlglibAul {
  double eps_x = 1e-9;
  double rho = 1e4;
  int outer_iterations = 15;
};
inline constexpr AlglibAul kAlglibPaper{1e-2, 1e4, 5};  // the paper's
inline constexpr AlglibAul kAlglibAccurate{};

// One problem loaded into ALGLIB; solving does not include loading.
class AlglibQp {
 public:
  struct Answer {
    Eigen::VectorXd x;
    int termination = 0;  // ALGLIB's terminationtype; > 0 claims success
  };

  explicit AlglibQp(const DenseQp& qp);
  ~AlglibQp();

  Answer solve_aul(const AlglibAul& settings);
  Answer solve_ipm(double eps = 0.0);  // interior point; 0: ALGLIB's own choice

  // The reference solution: AUL if it claims success and violates no row by 1e-6 or more, else the interior point on
  // the same terms, else nothing.
  std::optional<Eigen::VectorXd> solve_reference();

 private:
  struct State;
  Answer optimize();

  DenseQp qp_;
  std::unique_ptr<State> state_;
};

}  // namespace dob::test
