// The joint columns J_j (12x12) of the task points' Jacobian, solved with by structure instead of being formed.
//
// In CoM coordinates J_j = D - J_com A_c, where D = diag(J_q) holds the legs' own 3x3 blocks: the legs meet only in the
// trunk. So let the trunk's acceleration, referred to the CoM, stand in for the centroidal one:
//     y = rdd_c - A_c qdd.
// Then every leg answers to its own foot and to y alone, and one 6x6 system is left for all of them:
//     J_com rdd_c + J_j qdd = e   <=>   qdd = D^-1 e - E y,   S y = rdd_c - A_c D^-1 e,
//     E = D^-1 J_com (12x6),  S = I - A_c E (6x6).
// The inertia has the same structure. With M_q = diag(M_qq) - A_c^T M_com A_c and (18), the leg rows of (1) are
//     tau = F^T y + diag(M_qq) qdd + c - D^T f - A_c^T (w_18 - m g),   F = M_com A_c (6x12).
#pragma once

#include "robot/model_terms.h"

namespace dob {

struct TaskJacobian {
  PerLeg<Vec3> arm;    // [m] from the CoM to the leg's point, axes of W
  PerLeg<Mat3> D_inv;  // [1/m] D^-1
  PerLeg<Mat36> E;     // [1/m, -] joint rates per motion of the trunk while the point stays
  Mat6 S_inv;          // y per rdd_c while the points stay
  Mat6x12 A_c;         // of ModelTerms
  Mat6x12 F;           // [kg m, kg m^2] M_com A_c

  // False if a leg is singular (stretched knee) or the trunk's motion does not follow from rdd_c; the rest is then
  // undefined. A term that is not finite counts as singular.
  bool factorize(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept;

  // qdd [rad/s^2] of J_com rdd_c + J_j qdd = e [m/s^2].
  Vec12 solve(const Vec6& rdd_c, const Vec12& e) const noexcept;

  // J_j^-T tau [N]: forces at the points that act on the joints as the torques tau [N m] do (footnote 1).
  Vec12 solve_transposed(const Vec12& tau) const noexcept;
};

// In-place inverse of a general 6x6 matrix; false if it is singular to working precision or not finite.
bool invert(Mat6& A) noexcept;

}  // namespace dob
