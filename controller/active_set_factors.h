// The matrix factors of the dual active-set method (Goldfarb and Idnani, Math. Programming 27, 1983, section
// 4).
//
// With H = L L^T and the normals n_1 ... n_q of the active rows as columns of A, an orthogonal Q gives
//   J = L^-T Q = [J1 J2],   J^T H J = I,   J1^T A = R (upper triangular),   J2^T A = 0.
// Rows are appended by one Householder reflection of J2 (one rank-1 update; the paper's chain of Givens
// rotations has the same effect) and removed by Givens rotations.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Core>

namespace dob {

template <int N>
class ActiveSetFactors {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  // What adding a row with normal n does: per unit of its multiplier x moves by z, and the other multipliers
  // by -r.
  struct Direction {
    Vector d;                // J^T n
    Vector z;                // J2 J2^T n
    Vector r;                // R^-1 J1^T n; the first size() entries
    double length2 = 0.0;    // n^T H^-1 n
    double curvature = 0.0;  // n^T z, what is left of length2 outside the span of the active normals
  };

  // Factorises H (lower triangle) and forgets all rows. False if H is not positive definite to working
  // precision.
  bool factorize(const Matrix& H) noexcept;

  int size() const noexcept { return size_; }

  void project(const Vector& normal, Direction& step) const noexcept;  // sets d and length2
  void complete(Direction& step) const noexcept;                       // sets the rest from d

  // Appends the row that `step` belongs to; needs step.curvature > 0.
  void append(const Direction& step) noexcept;

  // Removes active row k; the later ones move up. Keeps step.d = J^T n.
  void remove(int k, Direction& step) noexcept;

  // Solves H dx - A du = gradient, A^T dx = gap for the first size() entries of du and gap.
  void solve(const Vector& gradient, const Vector& gap, Vector& dx, Vector& du) const noexcept;

 private:
  static constexpr int kPanel = 4;

  template <int... Panels>
  void factorize_panels(const Matrix& H, Matrix& L, Matrix& U, std::integer_sequence<int, Panels...>) noexcept;
  template <int first>
  void factorize_panel(const Matrix& H, Matrix& L, Matrix& U) noexcept;

  void solve_upper(Vector& r) const noexcept;  // R^-1, in place

  Matrix J_;
  Matrix R_;
  Vector inverse_diagonal_;  // of R
  int size_ = 0;
};

// H = L D L^T and J = L^-T D^-1/2, column by column: column j of L^-T is e_j minus the earlier columns times row j of
// L. The length of the loops over a column's rows is known at compile time for each panel of columns.
template <int N>
bool ActiveSetFactors<N>::factorize(const Matrix& H) noexcept {
  constexpr double kSmallestPivot = 16 * N * std::numeric_limits<double>::epsilon();  // relative to H_jj
  size_ = 0;
  Matrix L;
  Matrix U;  // L D
  factorize_panels(H, L, U, std::make_integer_sequence<int, (N + kPanel - 1) / kPanel>{});
  for (int j = 0; j < N; ++j) {
    if (!(U(j, j) > kSmallestPivot * H(j, j))) return false;
  }
  const Vector scale = U.diagonal().cwiseSqrt().cwiseInverse();
  for (int j = 0; j < N; ++j) J_.col(j) *= scale(j);
  return true;
}

template <int N>
template <int... Panels>
void ActiveSetFactors<N>::factorize_panels(const Matrix& H, Matrix& L, Matrix& U,
                                           std::integer_sequence<int, Panels...>) noexcept {
  (factorize_panel<Panels * kPanel>(H, L, U), ...);
}

// Columns first ... first + kPanel - 1. Entries of L and U above the diagonal are rubbish that is never used.
template <int N>
template <int first>
void ActiveSetFactors<N>::factorize_panel(const Matrix& H, Matrix& L, Matrix& U) noexcept {
  constexpr int kEnd = std::min(first + kPanel, N);
  constexpr int kBelow = N - first;
  for (int j = first; j < kEnd; ++j) {
    Eigen::Matrix<double, kBelow, 1> below = H.col(j).template tail<kBelow>();
    Eigen::Matrix<double, kEnd, 1> above = Eigen::Matrix<double, kEnd, 1>::Unit(j);
    for (int k = 0; k < j; ++k) {
      below -= L.col(k).template tail<kBelow>() * U(j, k);
      above -= J_.col(k).template head<kEnd>() * L(j, k);
    }
    U.col(j).template tail<kBelow>() = below;
    L.col(j).template tail<kBelow>() = below * (1.0 / below(j - first));
    J_.col(j).setZero();
    J_.col(j).template head<kEnd>() = above;
  }
}

template <int N>
void ActiveSetFactors<N>::project(const Vector& normal, Direction& step) const noexcept {
  for (int j = 0; j < N; ++j) step.d(j) = J_.col(j).dot(normal);
  step.length2 = step.d.squaredNorm();
}

template <int N>
void ActiveSetFactors<N>::complete(Direction& step) const noexcept {
  Vector z = Vector::Zero();
  double curvature = 0.0;
  for (int j = size_; j < N; ++j) {
    z += J_.col(j) * step.d(j);
    curvature += step.d(j) * step.d(j);
  }
  step.z = z;
  step.curvature = curvature;
  step.r = step.d;
  solve_upper(step.r);
}

template <int N>
void ActiveSetFactors<N>::solve_upper(Vector& r) const noexcept {
  for (int k = size_ - 1; k >= 0; --k) {
    r(k) *= inverse_diagonal_(k);
    for (int i = 0; i < k; ++i) r(i) -= R_(i, k) * r(k);
  }
}

// The reflection I - beta v v^T takes d2 to diagonal * e_1. J2 v = z - diagonal * (first column of J2).
template <int N>
void ActiveSetFactors<N>::append(const Direction& step) noexcept {
  const int q = size_;
  const double norm = std::sqrt(step.curvature);
  const double diagonal = step.d(q) > 0.0 ? -norm : norm;
  const double first = step.d(q) - diagonal;
  const double beta = 1.0 / (norm * std::abs(first));
  const Vector w = (step.z - J_.col(q) * diagonal) * beta;
  J_.col(q) -= w * first;
  for (int j = q + 1; j < N; ++j) J_.col(j) -= w * step.d(j);
  for (int i = 0; i < q; ++i) R_(i, q) = step.d(i);
  R_(q, q) = diagonal;
  inverse_diagonal_(q) = 1.0 / diagonal;
  ++size_;
}

template <int N>
void ActiveSetFactors<N>::remove(int k, Direction& step) noexcept {
  --size_;
  for (int j = k; j < size_; ++j) {
    for (int i = 0; i <= j + 1; ++i) R_(i, j) = R_(i, j + 1);
  }
  for (int j = k; j < size_; ++j) {
    const double length = std::sqrt(R_(j, j) * R_(j, j) + R_(j + 1, j) * R_(j + 1, j));
    const double c = R_(j, j) / length;
    const double s = R_(j + 1, j) / length;
    R_(j, j) = length;
    inverse_diagonal_(j) = 1.0 / length;
    for (int i = j + 1; i < size_; ++i) {
      const double upper = R_(j, i);
      R_(j, i) = c * upper + s * R_(j + 1, i);
      R_(j + 1, i) = c * R_(j + 1, i) - s * upper;
    }
    const Vector left = J_.col(j);
    J_.col(j) = c * left + s * J_.col(j + 1);
    J_.col(j + 1) = c * J_.col(j + 1) - s * left;
    const double dj = step.d(j);
    step.d(j) = c * dj + s * step.d(j + 1);
    step.d(j + 1) = c * step.d(j + 1) - s * dj;
  }
}

// With dx = J w: J^T H dx = w, so R^T w1 = gap, w2 = J2^T gradient, R du = w1 - J1^T gradient.
template <int N>
void ActiveSetFactors<N>::solve(const Vector& gradient, const Vector& gap, Vector& dx, Vector& du) const noexcept {
  Vector w;
  for (int j = 0; j < N; ++j) w(j) = J_.col(j).dot(gradient);
  for (int j = 0; j < size_; ++j) {
    double w1 = gap(j);
    for (int i = 0; i < j; ++i) w1 -= R_(i, j) * (w(i) + du(i));
    w1 *= inverse_diagonal_(j);
    du(j) = w1 - w(j);  // w(j) still holds J1^T gradient, so w1 = w + du
  }
  Vector sum = Vector::Zero();
  for (int j = 0; j < N; ++j) sum += J_.col(j) * (j < size_ ? w(j) + du(j) : w(j));
  dx = sum;
  solve_upper(du);
}

}  // namespace dob
