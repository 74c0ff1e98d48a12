// Judges of a QP answer that share no code with the solver: plain loops in extended precision, straight from the
// definitions.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/qp.h"

namespace dob::test {

// Residual and largest term of one block of conditions.
class ScaledResidual {
 public:
  void add(long double residual, long double term) {
    broken_ = broken_ || std::isnan(residual);
    residual_ = std::max(residual_, residual);
    term_ = std::max(term_, std::abs(term));
  }
  double value() const {
    return broken_ ? std::numeric_limits<double>::infinity() : static_cast<double>(residual_ / term_);
  }

 private:
  bool broken_ = false;
  long double residual_ = 0.0L;
  long double term_ = 1.0L;
};

// Largest KKT residual; each block is scaled by max(1, its largest term).
template <int N, int M>
double checked_kkt_residual(const QpProblem<N, M>& qp, const QpSolution<N, M>& solution) {
  ScaledResidual stationarity;
  ScaledResidual primal;
  ScaledResidual complementarity;
  ScaledResidual sign;
  for (int i = 0; i < N; ++i) {
    long double sum = qp.g(i);
    stationarity.add(0.0L, sum);
    for (int j = 0; j < N; ++j) {
      const long double term = static_cast<long double>(i < j ? qp.H(j, i) : qp.H(i, j)) * solution.x(j);
      stationarity.add(0.0L, term);
      sum += term;
    }
    for (int k = 0; k < qp.rows; ++k) {
      const long double term = static_cast<long double>(qp.C(k, i)) * solution.multipliers(k);
      stationarity.add(0.0L, term);
      sum += term;
    }
    stationarity.add(std::abs(sum), 0.0L);
  }
  for (int k = 0; k < qp.rows; ++k) {
    const long double y = solution.multipliers(k);
    long double value = 0.0L;
    for (int j = 0; j < N; ++j) {
      const long double term = static_cast<long double>(qp.C(k, j)) * solution.x(j);
      value += term;
      primal.add(0.0L, term);
      complementarity.add(0.0L, y * term);
    }
    primal.add(std::max({0.0L, qp.lower(k) - value, value - qp.upper(k)}), 0.0L);
    if (y == 0.0L) continue;
    const long double bound = y > 0.0L ? qp.upper(k) : qp.lower(k);
    sign.add(std::isinf(bound) ? std::abs(y) : 0.0L, y);
    if (!std::isinf(bound)) complementarity.add(std::abs(y * (value - bound)), y * bound);
  }
  return std::max({stationarity.value(), primal.value(), complementarity.value(), sign.value()});
}

// Whether `farkas` contradicts the rows: C^T y = 0 to 1e-8 of its largest term, and a negative bound sum.
template <int N, int M>
bool is_contradiction(const QpProblem<N, M>& qp, const typename QpProblem<N, M>::RowVector& y) {
  long double sum = 0.0L;
  for (int k = 0; k < qp.rows; ++k) {
    if (y(k) != 0.0) sum += static_cast<long double>(y(k)) * (y(k) > 0.0 ? qp.upper(k) : qp.lower(k));
  }
  long double largest = 0.0L;
  long double leftover = 0.0L;
  for (int j = 0; j < N; ++j) {
    long double column = 0.0L;
    for (int k = 0; k < qp.rows; ++k) {
      const long double term = static_cast<long double>(qp.C(k, j)) * y(k);
      column += term;
      largest = std::max(largest, std::abs(term));
    }
    leftover = std::max(leftover, std::abs(column));
  }
  return std::isfinite(sum) && sum < 0.0L && leftover <= 1e-8L * largest;
}

}  // namespace dob::test
