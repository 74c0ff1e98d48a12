// Proofs that an answer to a QP is what it claims to be, computed from the problem's data alone: they know
// nothing of the solver that found the answer.
#pragma once

#include <algorithm>
#include <cmath>

#include "controller/qp.h"

namespace dob {

// Maximum that keeps a NaN once it has met one.
inline double nan_max(double a, double b) noexcept {
  return (a >= b || std::isnan(a)) ? a : b;
}

// The bound that a multiplier or a Farkas weight of this sign refers to.
template <int N, int MaxRows>
double bound_of_sign(const QpProblem<N, MaxRows>& qp, int row, double y) noexcept {
  return y > 0.0 ? qp.upper(row) : qp.lower(row);
}

// Largest |C_ij x_j| of a row.
template <int N, int MaxRows>
double largest_term(const QpProblem<N, MaxRows>& qp, int row, const Eigen::Matrix<double, N, 1>& x) noexcept {
  return qp.C.row(row).transpose().cwiseProduct(x).cwiseAbs().maxCoeff();
}

// |H x + g + C^T y|_inf over max(1, its largest term).
template <int N, int MaxRows>
double stationarity_residual(const QpProblem<N, MaxRows>& qp, const Eigen::Matrix<double, N, 1>& x,
                             const Eigen::Matrix<double, MaxRows, 1>& y) noexcept {
  using Vector = Eigen::Matrix<double, N, 1>;
  Vector gradient = qp.g;
  Vector largest = qp.g.cwiseAbs();
  for (int j = 0; j < N; ++j) {
    const Vector term = qp.H.col(j) * x(j);
    gradient += term;
    largest = largest.cwiseMax(term.cwiseAbs());
  }
  for (int i = 0; i < qp.rows; ++i) {
    if (y(i) == 0.0) continue;
    const Vector term = qp.C.row(i).transpose() * y(i);
    gradient += term;
    largest = largest.cwiseMax(term.cwiseAbs());
  }
  double worst = 0.0;
  for (int j = 0; j < N; ++j) worst = nan_max(worst, std::abs(gradient(j)));
  return worst / std::max(1.0, largest.maxCoeff());
}

// Largest residual of the KKT conditions at (x, y), each relative to max(1, the largest term in it):
//   stationarity     H x + g + C^T y = 0
//   primal           lower <= C x <= upper, row by row
//   complementarity  y_i (c_i^T x - bound of y_i's sign) = 0, row by row
// The sign of a multiplier names its side, so a wrong sign shows up as complementarity (infinite if that side
// is).
template <int N, int MaxRows>
double kkt_residual(const QpProblem<N, MaxRows>& qp, const Eigen::Matrix<double, N, 1>& x,
                    const Eigen::Matrix<double, MaxRows, 1>& y) noexcept {
  double worst = stationarity_residual(qp, x, y);
  const auto consider = [&](int row, double residual, double factor, double bound) {
    if (residual <= worst) return;  // the scale is at least 1
    const double scale = factor * std::max(std::abs(bound), largest_term(qp, row, x));
    worst = nan_max(worst, std::isinf(bound) ? std::abs(bound) : residual / std::max(1.0, scale));
  };
  for (int i = 0; i < qp.rows; ++i) {
    const double value = qp.C.row(i).dot(x);
    consider(i, qp.lower(i) - value, 1.0, qp.lower(i));
    consider(i, value - qp.upper(i), 1.0, qp.upper(i));
    if (y(i) == 0.0) continue;
    const double bound = bound_of_sign(qp, i, y(i));
    consider(i, std::abs(y(i) * (value - bound)), std::abs(y(i)), bound);
  }
  return worst;
}

// Whether y proves that no x satisfies the rows. Every feasible x has (C^T y)^T x <= sum over rows of y_i
// times the bound of y_i's sign; with C^T y = 0 a negative sum is a contradiction. In floating point C^T y is
// only nearly zero: we ask for 1e-8 of its largest term, and that the contradiction holds for every |x_j| <=
// 1000 reach_j.
template <int N, int MaxRows>
bool proves_infeasibility(const QpProblem<N, MaxRows>& qp, const Eigen::Matrix<double, MaxRows, 1>& y,
                          const Eigen::Matrix<double, N, 1>& reach) noexcept {
  using Vector = Eigen::Matrix<double, N, 1>;
  constexpr double kCancellation = 1e-8;  // of C^T y
  constexpr double kReach = 1e3;
  constexpr double kRounding = 1e-13;  // of the bound sum
  double sum = 0.0;
  double sum_scale = 0.0;
  double largest = 0.0;
  Vector combination = Vector::Zero();
  for (int i = 0; i < qp.rows; ++i) {
    if (y(i) == 0.0) continue;
    const double term = y(i) * bound_of_sign(qp, i, y(i));
    sum += term;
    sum_scale = std::max(sum_scale, std::abs(term));
    const Vector terms = qp.C.row(i).transpose() * y(i);
    combination += terms;
    largest = std::max(largest, terms.cwiseAbs().maxCoeff());
  }
  const double leftover = combination.cwiseAbs().maxCoeff();
  const double leftover_reach = combination.cwiseAbs().dot(reach);
  return leftover <= kCancellation * largest && sum + kReach * leftover_reach < -kRounding * sum_scale &&
         std::isfinite(sum);
}

}  // namespace dob
