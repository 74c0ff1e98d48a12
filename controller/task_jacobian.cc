#include "controller/task_jacobian.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dob {

// Gauss-Jordan elimination with row pivoting. Eigen's LU of this size takes three times as long.
bool invert(Mat6& A) noexcept {
  constexpr double kSmallestPivot = 1e-14;  // of the largest entry
  const double scale = A.cwiseAbs().maxCoeff();
  std::array<int, 6> swapped{};
  for (int k = 0; k < 6; ++k) {
    int p = k;
    for (int i = k + 1; i < 6; ++i) {
      if (std::abs(A(i, k)) > std::abs(A(p, k))) p = i;
    }
    if (!(std::abs(A(p, k)) > kSmallestPivot * scale)) return false;
    swapped[static_cast<std::size_t>(k)] = p;
    if (p != k) {
      for (int j = 0; j < 6; ++j) std::swap(A(k, j), A(p, j));
    }
    const double inverse = 1.0 / A(k, k);
    Vec6 column = A.col(k);
    column[k] = 0.0;
    A.col(k) = Vec6::Unit(k);
    A.row(k) *= inverse;
    for (int j = 0; j < 6; ++j) A.col(j) -= column * A(k, j);
  }
  for (int k = 5; k >= 0; --k) {
    const int p = swapped[static_cast<std::size_t>(k)];
    if (p != k) A.col(k).swap(A.col(p));
  }
  return std::isfinite(A.sum());
}

// A knee 2e-5 rad from stretched: what is left of the precision of D^-1 beyond that does not carry a foot.
constexpr double kSmallestDeterminant = 1e-6;  // [m^3] of a leg's block

// Of the trunk's relation, in SI units. Beyond it a foot does not keep the eight digits it is held to.
constexpr double kLargestCondition = 1e7;

double infinity_norm(const Mat6& A) noexcept {
  return A.cwiseAbs().rowwise().sum().maxCoeff();
}

bool TaskJacobian::factorize(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept {
  A_c = m.A_c;
  F.topRows<3>() = m.mass * A_c.topRows<3>();
  F.bottomRows<3>() = m.I_c.lazyProduct(A_c.bottomRows<3>());
  Mat6 S = Mat6::Identity();
  for (int l = 0; l < kLegs; ++l) {
    bool invertible = false;
    points[l].J_q.computeInverseWithCheck(D_inv[l], invertible, kSmallestDeterminant);
    if (!invertible) return false;
    arm[l] = points[l].p - m.p_com;
    E[l].leftCols<3>() = D_inv[l];
    for (int i = 0; i < 3; ++i) E[l].row(i).tail<3>() = arm[l].cross(Vec3(D_inv[l].row(i)));  // -D^-1 skew(arm)
    S.noalias() -= A_c.middleCols<3>(3 * l).lazyProduct(E[l]);
  }
  S_inv = S;
  return invert(S_inv) && infinity_norm(S) * infinity_norm(S_inv) <= kLargestCondition;
}

Vec12 TaskJacobian::solve(const Vec6& rdd_c, const Vec12& e) const noexcept {
  Vec12 qdd;
  for (int l = 0; l < kLegs; ++l) qdd.segment<3>(3 * l).noalias() = D_inv[l] * e.segment<3>(3 * l);
  const Vec6 y = S_inv * (rdd_c - A_c.lazyProduct(qdd));
  for (int l = 0; l < kLegs; ++l) qdd.segment<3>(3 * l).noalias() -= E[l] * y;
  return qdd;
}

// J_j^T f = D^T f - A_c^T w with w = J_com^T f, hence S^T w = E^T tau.
Vec12 TaskJacobian::solve_transposed(const Vec12& tau) const noexcept {
  Vec6 E_tau = Vec6::Zero();
  for (int l = 0; l < kLegs; ++l) E_tau.noalias() += E[l].transpose() * tau.segment<3>(3 * l);
  const Vec6 w = S_inv.transpose() * E_tau;
  Vec12 f;
  for (int l = 0; l < kLegs; ++l) {
    const Vec3 own = tau.segment<3>(3 * l) + A_c.middleCols<3>(3 * l).transpose() * w;
    f.segment<3>(3 * l).noalias() = D_inv[l].transpose() * own;
  }
  return f;
}

}  // namespace dob
