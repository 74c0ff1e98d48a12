// The paper's quadratic problem (12)-(35) as it is printed, with every option of WbcOptions and Routing, assembled from
// full-space terms by plain linear algebra, sharing no formula with controller/whole_body_qp.cc:
//   variables zeta = [rdd_c (6); qdd (12); f (3 n_st); gamma (3 n_sw)], 30 in all for two or four standing feet.
#pragma once

#include "controller/whole_body_qp.h"
#include "test/oracles/alglib_qp.h"
#include "test/support/wbc_instances.h"

namespace dob::test {

struct FullProblem {
  // minimise 1/2 zeta^T H zeta + g^T zeta,  E zeta = e,  lower <= D zeta <= upper
  Eigen::MatrixXd H, E, D;
  Eigen::VectorXd g, e, lower, upper;
  Eigen::MatrixXd torque;                          // 12 rows: what zeta adds to the torques (36)
  int n_stance = 0, n_swing = 0;                   // feet
  int n_torque_rows = 0, n_acceleration_rows = 0;  // 12 or none
  // Rows of D: 5 per standing foot (four facets of (23), f_n >= f_min), torques (24), joint accelerations, 6 per
  // swinging foot (33).
  int torque_row() const { return 5 * n_stance; }
  int acceleration_row() const { return torque_row() + n_torque_rows; }
  int swing_row() const { return acceleration_row() + n_acceleration_rows; }
  int gamma() const { return kBaseDof + kJoints + 3 * n_stance; }  // first slack variable

  // For a general solver: equality rows first, and slack in units of 1e-4 m/s^2, without which the Hessian's condition
  // (1e8) costs such solvers their accuracy.
  DenseQp as_dense() const;
  Eigen::VectorXd from_dense(Eigen::VectorXd x) const;
};

FullProblem full_problem(const WbcInstance& instance, const WbcOptions& options, const Routing& routing);

// zeta of a solution of the reduced problem; gamma = |delta|.
Eigen::VectorXd full_point(const FullProblem& p, const PerLeg<bool>& stance, const WbcSolution& s);

// Largest KKT residual of the full problem at zeta, every block scaled by max(1, its largest term). Multipliers of
// friction, torque and acceleration rows are the reduced problem's; those of (33) follow from stationarity in gamma,
// those of the equality rows from least squares.
double full_kkt_residual(const FullProblem& p, const PerLeg<bool>& stance, const WbcSolution& s,
                         const WbcQpSolution& reduced);

}  // namespace dob::test
