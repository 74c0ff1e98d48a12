// Seeded random quadratic programs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include <Eigen/Core>

#include "controller/qp.h"

namespace dob::test {

template <int N, int M>
class RandomQp {
 public:
  using Problem = QpProblem<N, M>;
  using Vector = typename Problem::Vector;
  using RowVector = typename Problem::RowVector;
  using Matrix = Eigen::Matrix<double, N, N>;

  explicit RandomQp(std::uint64_t seed) : engine_(seed) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  double log_uniform(double from, double to) { return std::pow(10.0, uniform(std::log10(from), std::log10(to))); }
  double normal() { return std::normal_distribution<double>()(engine_); }
  int integer(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  Vector vector() {
    return Vector::NullaryExpr([this] { return normal(); });
  }

  // Symmetric positive definite with eigenvalues from 1/sqrt(condition) to sqrt(condition), both ends included, turned
  // by N random reflections I - beta v v^T from both sides.
  Matrix hessian(double condition) {
    const double end = std::sqrt(condition);
    Matrix H = Matrix::Zero();
    for (int j = 0; j < N; ++j) H(j, j) = log_uniform(1.0 / end, end);
    H(0, 0) = end;
    H(N - 1, N - 1) = 1.0 / end;
    for (int k = 0; k < N; ++k) {
      const Vector v = vector();
      const double beta = 2.0 / v.squaredNorm();
      Vector w = Vector::Zero();  // H v
      for (int j = 0; j < N; ++j) w += H.col(j) * v(j);
      const double vw = v.dot(w);
      for (int j = 0; j < N; ++j) H.col(j) += beta * (v * (beta * vw * v(j) - w(j)) - w * v(j));
    }
    for (int j = 0; j < N; ++j) H.row(j).head(j) = H.col(j).head(j);
    return H;
  }

  // A problem whose solution is known by construction: x and y are drawn, then g and the bounds follow.
  struct Known {
    Problem qp;
    Vector x;
    RowVector y = RowVector::Zero();
  };
  Known known(int rows, int active, double condition) {
    Known known;
    Problem& qp = known.qp;
    qp.rows = rows;
    qp.H = hessian(condition);
    known.x = vector();
    for (int i = 0; i < rows; ++i) {
      qp.C.row(i) = vector();
      const double value = qp.C.row(i).dot(known.x);
      qp.lower(i) = chance(0.2) ? -Problem::kInfinity : value - uniform(0.1, 2.0);
      qp.upper(i) = chance(0.2) ? Problem::kInfinity : value + uniform(0.1, 2.0);
      if (i >= active) continue;
      const bool equality = chance(0.1);
      known.y(i) = uniform(0.1, 1.0) * (chance(0.5) ? 1.0 : -1.0);
      if (equality || known.y(i) > 0.0) qp.upper(i) = value;
      if (equality || known.y(i) < 0.0) qp.lower(i) = value;
    }
    for (int j = 0; j < N; ++j) qp.g -= qp.H.col(j) * known.x(j);
    for (int i = 0; i < active; ++i) qp.g -= qp.C.row(i).transpose() * known.y(i);
    return known;
  }

  // Anything that may go wrong at once: variables, rows and bounds of scales 1e-8 ... 1e8, rows that are zero, equal,
  // opposite or parallel up to a perturbation of any size, slabs of any width, equalities, contradictions.
  Problem hostile() {
    Problem qp;
    qp.rows = integer(0, M);
    const double spread = chance(0.3) ? 1e4 : 1.0;
    const Vector scale = Vector::NullaryExpr([&] { return log_uniform(1.0 / spread, spread); });
    const double size = log_uniform(1e-8, 1e8);
    const double strength = log_uniform(1e-8, 1e8);
    qp.H = hessian(log_uniform(1.0, 1e8));
    for (int j = 0; j < N; ++j) qp.H.col(j) = (strength * scale(j)) * scale.cwiseProduct(qp.H.col(j));
    const Vector inside = size * scale.cwiseInverse().cwiseProduct(vector());
    const Vector target = inside + log_uniform(1e-8, 1e8) * scale.cwiseInverse().cwiseProduct(vector());
    for (int j = 0; j < N; ++j) qp.g -= qp.H.col(j) * target(j);
    const double contradictions = chance(0.5) ? 0.0 : uniform(0.0, 0.5);
    for (int i = 0; i < qp.rows; ++i) {
      qp.C.row(i) = hostile_row(qp, i);
      hostile_bounds(qp, i, inside, contradictions);
    }
    return qp;
  }

 private:
  Vector hostile_row(const Problem& qp, int i) {
    if (chance(0.02)) return Vector::Zero();
    const double scale = log_uniform(1e-8, 1e8);
    if (i > 0 && chance(0.3)) {
      const Vector earlier = qp.C.row(integer(0, i - 1));
      const double angle = chance(0.3) ? 0.0 : log_uniform(1e-16, 1e-2);
      const Vector noise = angle * earlier.norm() * vector();
      const double sign = chance(0.5) ? 1.0 : -1.0;
      return sign * (chance(0.5) ? 1.0 : scale) * (earlier + noise);
    }
    if (chance(0.4)) return scale * Vector::Unit(integer(0, N - 1));
    return scale * vector();
  }

  void hostile_bounds(Problem& qp, int i, const Vector& inside, double contradictions) {
    double value = qp.C.row(i).dot(inside);
    const double size = std::max(std::abs(value), qp.C.row(i).norm());
    if (chance(contradictions)) value += size * normal();
    const double width = size * log_uniform(1e-12, 1e2);
    qp.lower(i) = value - (chance(0.3) ? 0.0 : width);
    qp.upper(i) = value + (chance(0.3) ? 0.0 : width);
    if (chance(0.2)) qp.lower(i) = -Problem::kInfinity;
    if (chance(0.2)) qp.upper(i) = Problem::kInfinity;
  }

  std::mt19937_64 engine_;
};

}  // namespace dob::test
