// Definitions of controller/goldfarb_idnani.h; included from there only.
#pragma once

#include <algorithm>
#include <cmath>

#include "controller/goldfarb_idnani.h"
#include "controller/qp_certificate.h"

namespace dob {

namespace goldfarb_idnani {

inline constexpr double kFeasibility = 1e-11;  // of the row's largest terms: below it a violation is rounding
inline constexpr double kDependence = 1e-12;   // of |J^T n|: below it n lies in the span of the active normals
inline constexpr double kBlocking = 1e-12;     // r_j of unit normals: below it r_j is rounding
inline constexpr int kRetries = 3;
inline constexpr double kSmallestNorm2 = 1e-200;  // of a row that is not zero
inline constexpr double kLargestNorm2 = 1e200;

template <int N, int MaxRows>
double bound(const QpProblem<N, MaxRows>& qp, int row, QpSide side) noexcept {
  return side == QpSide::kLower ? qp.lower(row) : qp.upper(row);
}

// Zero times an infinity or a NaN is a NaN.
template <typename Matrix>
bool is_finite(const Matrix& matrix) noexcept {
  return (matrix * 0.0).sum() == 0.0;
}

}  // namespace goldfarb_idnani

template <int N, int MaxRows>
QpStatus GoldfarbIdnani<N, MaxRows>::solve(const Problem& qp, const ActiveSet& guess, Solution& solution) noexcept {
  if (!prepare(qp)) return solution.status = QpStatus::kInvalidInput;
  if (!factors_.factorize(qp.H)) return solution.status = QpStatus::kSingular;
  start(qp, guess, false);
  solution.status = judge(qp, iterate(qp), solution);
  for (int retry = 0; retry < goldfarb_idnani::kRetries && solution.status == QpStatus::kInaccurate; ++retry) {
    const ActiveSet reached = active_;
    while (active_.size > 0) remove(active_.size - 1);
    factors_.factorize(qp.H);
    start(qp, reached, true);
    solution.status = judge(qp, iterate(qp), solution);
  }
  return solution.status;
}

// Checks the input and resets the workspace.
template <int N, int MaxRows>
bool GoldfarbIdnani<N, MaxRows>::prepare(const Problem& qp) noexcept {
  using namespace goldfarb_idnani;
  if (qp.rows < 0 || qp.rows > MaxRows || !is_finite(qp.g) || !is_finite(qp.H)) return false;
  active_.size = 0;
  iterations_ = 0;
  candidates_ = 0;
  hopeless_row_ = -1;
  has_equalities_ = false;
  for (int i = 0; i < qp.rows; ++i) {
    const double lower = qp.lower(i);
    const double upper = qp.upper(i);
    if (!(lower <= upper && lower < Problem::kInfinity && upper > -Problem::kInfinity)) return false;
    has_equalities_ = has_equalities_ || lower == upper;
    const double norm2 = qp.C.row(i).squaredNorm();
    if (norm2 >= kSmallestNorm2 && norm2 <= kLargestNorm2) {
      weight_(i) = 1.0 / norm2;
    } else {
      if (!qp.C.row(i).isZero(0.0)) return false;
      weight_(i) = 0.0;
      if (lower > 0.0 || upper < 0.0) hopeless_row_ = i;
    }
  }
  return true;
}

// Takes the equality rows and the guess, and makes x optimal for as many of them as have multipliers of the
// right sign.
template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::start(const Problem& qp, const ActiveSet& guess, bool refined) noexcept {
  for (int i = 0; has_equalities_ && i < qp.rows; ++i) {
    if (qp.lower(i) == qp.upper(i)) try_append(qp, i, QpSide::kLower);
  }
  equalities_ = active_.size;
  for (int k = 0; k < std::min(guess.size, N); ++k) try_append(qp, guess[k].row, guess[k].side);
  settle(qp, refined);
}

template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::try_append(const Problem& qp, int row, QpSide side) noexcept {
  if (row < 0 || row >= qp.rows || weight_(row) == 0.0) return;
  const double bound = goldfarb_idnani::bound(qp, row, side);
  if (std::isinf(bound)) return;
  const double scale = (side == QpSide::kLower ? 1.0 : -1.0) * std::sqrt(weight_(row));
  factors_.project(qp.C.row(row).transpose() * scale, step_);
  factors_.complete(step_);
  if (!is_dependent()) append(row, side, scale, scale * bound, 0.0);
}

template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::settle(const Problem& qp, bool refined) noexcept {
  for (;;) {
    factors_.solve(-qp.g, gap_, x_, u_);
    if (refined) refine(qp);
    int worst = -1;
    for (int k = equalities_; k < active_.size; ++k) {
      if (u_(k) < (worst < 0 ? 0.0 : u_(worst))) worst = k;
    }
    if (worst < 0) break;
    remove(worst);
  }
  reach_ = x_.cwiseAbs();
}

// One step of iterative refinement of x and u for the active rows.
template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::refine(const Problem& qp) noexcept {
  Vector gradient = -qp.g - qp.H * x_;
  Vector gap = gap_;
  for (int k = 0; k < active_.size; ++k) {
    const Vector normal = qp.C.row(active_[k].row).transpose() * scale_(k);
    gradient += normal * u_(k);
    gap(k) -= normal.dot(x_);
  }
  Vector dx;
  Vector du;
  factors_.solve(gradient, gap, dx, du);
  x_ += dx;
  u_.head(active_.size) += du.head(active_.size);
}

template <int N, int MaxRows>
auto GoldfarbIdnani<N, MaxRows>::iterate(const Problem& qp) noexcept -> Outcome {
  if (hopeless_row_ >= 0) {
    active_.size = 0;
    record_contradiction(qp, hopeless_row_, qp.lower(hopeless_row_) > 0.0 ? 1.0 : -1.0);
    return Outcome::kContradiction;
  }
  for (;;) {
    const int row = most_violated(qp);
    if (row < 0) return Outcome::kDone;
    const double value = qp.C.row(row).dot(x_);
    const bool below = qp.lower(row) - value > value - qp.upper(row);
    const Outcome outcome = add(qp, row, below ? QpSide::kLower : QpSide::kUpper);
    if (outcome != Outcome::kDone) return outcome;
  }
}

// Square of the distance between x and the row's feasible half-space, negative inside; not positive if row is active.
template <int N, int MaxRows>
double GoldfarbIdnani<N, MaxRows>::score(const Problem& qp, int row) const noexcept {
  const double value = qp.C.row(row).dot(x_);
  const double violation = std::max(qp.lower(row) - value, value - qp.upper(row));
  return violation * std::abs(violation) * weight_(row);
}

// Whether a score is larger than rounding errors in C x and in the bounds explain.
template <int N, int MaxRows>
bool GoldfarbIdnani<N, MaxRows>::is_significant(const Problem& qp, int row, double score) const noexcept {
  const double rounding = goldfarb_idnani::kFeasibility * qp.C.row(row).cwiseAbs().dot(reach_);
  return score > rounding * rounding * weight_(row);
}

// The row with the highest score, or -1 if only rounding is left. Looks first at the rows that were violated when last
// all were looked at: in most steps one of these is the one, and they are few.
template <int N, int MaxRows>
int GoldfarbIdnani<N, MaxRows>::most_violated(const Problem& qp) noexcept {
  int worst = -1;
  double worst_score = 0.0;
  const auto consider = [&](int row, double row_score) {
    if (row_score > worst_score && is_significant(qp, row, row_score)) {
      worst = row;
      worst_score = row_score;
    }
  };
  for (int k = 0; k < candidates_; ++k) consider(candidate_(k), score(qp, candidate_(k)));
  if (worst >= 0) return worst;
  candidates_ = 0;
  for (int i = 0; i < qp.rows; ++i) {
    const double row_score = score(qp, i);
    if (row_score > 0.0) candidate_(candidates_++) = i;
    consider(i, row_score);
  }
  return worst;
}

// Moves x and the multipliers until the row holds, dropping active rows whose multipliers reach zero on the
// way.
template <int N, int MaxRows>
auto GoldfarbIdnani<N, MaxRows>::add(const Problem& qp, int row, QpSide side) noexcept -> Outcome {
  const double scale = (side == QpSide::kLower ? 1.0 : -1.0) * std::sqrt(weight_(row));
  const double gap = scale * goldfarb_idnani::bound(qp, row, side);
  const Vector normal = qp.C.row(row).transpose() * scale;
  factors_.project(normal, step_);
  double multiplier = 0.0;
  while (iterations_ < options_.iteration_limit) {
    ++iterations_;
    factors_.complete(step_);
    bool dependent = is_dependent();
    const Blocking blocking = first_blocking();
    if (dependent && blocking.k < 0) {
      record_contradiction(qp, row, scale);
      if (proves_infeasibility(qp, farkas_, reach_) || !(step_.curvature > 0.0)) return Outcome::kContradiction;
      dependent = false;  // the rows only look dependent: go the long way
    }
    const double full = dependent ? Problem::kInfinity : std::max(0.0, gap - normal.dot(x_)) / step_.curvature;
    const double length = std::min(full, blocking.length);
    multiplier += length;
    for (int k = 0; k < active_.size; ++k) {
      u_(k) -= length * step_.r(k);
      if (k >= equalities_) u_(k) = std::max(u_(k), 0.0);
    }
    if (!dependent) {
      x_ += length * step_.z;
      reach_ = reach_.cwiseMax(x_.cwiseAbs());
    }
    if (full <= blocking.length) {
      append(row, side, scale, gap, multiplier);
      return Outcome::kDone;
    }
    remove(blocking.k);
  }
  return Outcome::kIterationLimit;
}

template <int N, int MaxRows>
auto GoldfarbIdnani<N, MaxRows>::first_blocking() const noexcept -> Blocking {
  Blocking first;
  for (int k = equalities_; k < active_.size; ++k) {
    if (!(step_.r(k) > goldfarb_idnani::kBlocking)) continue;
    const double length = u_(k) / step_.r(k);
    if (length < first.length) first = {k, length};
  }
  return first;
}

// The violated row's normal n is a combination of active ones, n = A r with r <= 0, so no point satisfies them all.
// One step of iterative refinement makes r as good as the rows allow.
template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::record_contradiction(const Problem& qp, int row, double scale) noexcept {
  Vector leftover = qp.C.row(row).transpose() * scale;
  for (int k = 0; k < active_.size; ++k) {
    leftover -= qp.C.row(active_[k].row).transpose() * (scale_(k) * step_.r(k));
  }
  typename Factors::Direction correction;
  factors_.project(leftover, correction);
  factors_.complete(correction);
  farkas_.setZero();
  farkas_(row) = -scale;
  for (int k = 0; k < active_.size; ++k) {
    const double r = step_.r(k) + correction.r(k);
    if (k < equalities_ || r < 0.0) farkas_(active_[k].row) = scale_(k) * r;
  }
}

template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::append(int row, QpSide side, double scale, double gap, double multiplier) noexcept {
  factors_.append(step_);
  const int k = active_.size++;
  active_[k] = {row, side};
  scale_(k) = scale;
  gap_(k) = gap;
  u_(k) = multiplier;
  weight_(row) = 0.0;
}

template <int N, int MaxRows>
void GoldfarbIdnani<N, MaxRows>::remove(int k) noexcept {
  weight_(active_[k].row) = scale_(k) * scale_(k);
  factors_.remove(k, step_);
  --active_.size;
  for (int j = k; j < active_.size; ++j) {
    active_[j] = active_[j + 1];
    scale_(j) = scale_(j + 1);
    gap_(j) = gap_(j + 1);
    u_(j) = u_(j + 1);
  }
}

template <int N, int MaxRows>
bool GoldfarbIdnani<N, MaxRows>::is_dependent() const noexcept {
  constexpr double kLimit = goldfarb_idnani::kDependence * goldfarb_idnani::kDependence;
  return !(step_.curvature > kLimit * step_.length2);
}

template <int N, int MaxRows>
QpStatus GoldfarbIdnani<N, MaxRows>::judge(const Problem& qp, Outcome outcome, Solution& solution) const noexcept {
  solution.x = x_;
  solution.active = active_;
  solution.iterations = iterations_;
  solution.multipliers.setZero();
  solution.farkas.setZero();
  for (int k = 0; k < active_.size; ++k) solution.multipliers(active_[k].row) = -scale_(k) * u_(k);
  solution.kkt_residual = kkt_residual(qp, solution.x, solution.multipliers);
  if (outcome == Outcome::kIterationLimit) return QpStatus::kIterationLimit;
  if (outcome == Outcome::kContradiction) {
    if (!proves_infeasibility(qp, farkas_, reach_)) return QpStatus::kInaccurate;
    solution.farkas = farkas_;
    return QpStatus::kInfeasible;
  }
  return solution.kkt_residual <= options_.kkt_tolerance ? QpStatus::kOptimal : QpStatus::kInaccurate;
}

}  // namespace dob
