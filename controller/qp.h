// The convex quadratic program of the controller, as plain values of fixed size:
//
//   minimise 1/2 x^T H x + g^T x   subject to   lower <= C x <= upper,   H symmetric positive definite.
//
// Rows are two-sided; one side may be infinite (both: a free row), lower == upper is an equality. Units are
// the caller's. The multipliers y are signed: y_i > 0 pushes against the upper bound, y_i < 0 against the
// lower one, and at the optimum H x + g + C^T y = 0.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include <Eigen/Core>

namespace dob {

enum class QpStatus {
  kOptimal,         // x is the minimiser; the KKT residual, computed from the problem's own data, is within
                    // tolerance
  kInfeasible,      // no x satisfies the rows; farkas proves it
  kSingular,        // H is not positive definite to working precision
  kIterationLimit,  // stopped before an answer was found
  kInaccurate,      // an answer was found, but neither optimality nor infeasibility could be proved to tolerance
  kInvalidInput,    // NaN, infinite H, g or C, lower > upper, a row count out of range, a non-zero row of norm beyond
                    // 1e+-100
};

constexpr std::string_view to_string(QpStatus status) noexcept {
  switch (status) {
    case QpStatus::kOptimal:
      return "optimal";
    case QpStatus::kInfeasible:
      return "infeasible";
    case QpStatus::kSingular:
      return "singular";
    case QpStatus::kIterationLimit:
      return "iteration limit";
    case QpStatus::kInaccurate:
      return "inaccurate";
    case QpStatus::kInvalidInput:
      return "invalid input";
  }
  return "unknown";
}

template <int N, int MaxRows>
struct QpProblem {
  using Vector = Eigen::Matrix<double, N, 1>;
  using RowVector = Eigen::Matrix<double, MaxRows, 1>;
  using Rows = Eigen::Matrix<double, MaxRows, N, Eigen::RowMajor>;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Eigen::Matrix<double, N, N> H = Eigen::Matrix<double, N, N>::Identity();  // both triangles are read
  Vector g = Vector::Zero();
  Rows C = Rows::Zero();
  RowVector lower = RowVector::Constant(-kInfinity);
  RowVector upper = RowVector::Constant(kInfinity);
  int rows = 0;  // rows in use, 0 ... MaxRows; nothing beyond them is read
};

enum class QpSide { kLower, kUpper };

struct QpActiveRow {
  int row = 0;
  QpSide side = QpSide::kLower;  // of an equality: kLower
};

// Rows that hold with equality and have linearly independent normals, so never more than N.
template <int N>
struct QpActiveSet {
  int size = 0;
  std::array<QpActiveRow, static_cast<std::size_t>(N)> rows{};

  QpActiveRow& operator[](int k) noexcept { return rows[static_cast<std::size_t>(k)]; }
  const QpActiveRow& operator[](int k) const noexcept { return rows[static_cast<std::size_t>(k)]; }
};

template <int N, int MaxRows>
struct QpSolution {
  using Vector = Eigen::Matrix<double, N, 1>;
  using RowVector = Eigen::Matrix<double, MaxRows, 1>;

  QpStatus status = QpStatus::kInvalidInput;
  Vector x = Vector::Zero();                  // the minimiser if kOptimal, else the last iterate
  RowVector multipliers = RowVector::Zero();  // y; zero on inactive rows
  QpActiveSet<N> active;                      // usable as the guess of the next solve
  int iterations = 0;                         // rows added plus rows dropped
  double kkt_residual = 0.0;                  // of (x, multipliers), see qp_certificate.h
  RowVector farkas = RowVector::Zero();       // if kInfeasible: C^T farkas = 0 and its bound sum is negative
};

}  // namespace dob
