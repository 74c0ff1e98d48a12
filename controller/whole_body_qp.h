// The quadratic problem (12)-(35) in its exact 12-variable form.
//
// Per foot one 3-vector: the ground reaction force f if the foot stands, the scaled tracking error s = 1e4 delta if it
// swings; always 12 variables. The equality rows (18), (20) and the softened row (33) are solved for the rest:
//     rdd_c = M_com^-1 (J_st,com^T f + w_18 - m g)                     (18)
//     qdd   = J_j^-1 (e - J_com rdd_c)                                 (20), (33)
//     e     = -bias for standing feet,  x_cmd - bias + delta for swinging ones,
// where |delta| is the slack gamma of (33) at the optimum. What remains are friction (23) and torque (24) rows.
// Exact as long as J_j (12x12, all feet) is invertible, i.e. no knee is stretched.
#pragma once

#include "controller/compensation.h"
#include "controller/motion_planner.h"
#include "controller/qp.h"
#include "controller/wbc_options.h"
#include "robot/model_terms.h"

namespace dob {

inline constexpr int kWbcVariables = 12;
inline constexpr int kWbcMaxRows = 44;
inline constexpr double kTrackingErrorScale = 1e4;  // s = scale * delta, so that the Hessian block of s is about I

using WbcProblem = QpProblem<kWbcVariables, kWbcMaxRows>;
using WbcQpSolution = QpSolution<kWbcVariables, kWbcMaxRows>;

// zeta of (12) and what the tick needs of it.
struct WbcSolution {
  Vec6 rdd_c = Vec6::Zero();             // [m/s^2; rad/s^2] I_c^-1 L_dot in the angular part
  Vec12 qdd = Vec12::Zero();             // [rad/s^2]
  Vec12 foot_force = Vec12::Zero();      // [N] ground reaction forces, zero for swinging feet
  Vec12 tracking_error = Vec12::Zero();  // [m/s^2] delta, zero for standing feet
};

// Desired wrench (16) at the CoM [N; N m]; orientation error as the rotation vector of R_ref R^T along W.
Vec6 desired_wrench(const ModelTerms& m, const MotionReference& reference, const WbcOptions& options) noexcept;

class WholeBodyQp {
 public:
  explicit WholeBodyQp(const WbcOptions& options) : options_(options) {}

  // Builds the reduced problem; false if a leg is singular or a term is not finite.
  bool assemble(const ModelTerms& m, const PerLeg<bool>& stance, const MotionReference& reference,
                const Compensation& compensation, const PerLeg<LegPoint>& points, const Mat12& J_j_inverse) noexcept;

  const WbcProblem& problem() const noexcept { return problem_; }

  // The same problem without its torque rows; always feasible.
  WbcProblem without_torque_rows() const noexcept;

  WbcSolution recover(const Vec12& x) const noexcept;

 private:
  void assemble_maps(const ModelTerms& m, const MotionReference& reference, const Compensation& compensation,
                     const PerLeg<LegPoint>& points, const Mat12& J_j_inverse) noexcept;
  void assemble_cost(const Vec6& wrench_error) noexcept;
  void assemble_rows(const ModelTerms& m, const Compensation& compensation, const PerLeg<LegPoint>& points) noexcept;

  WbcOptions options_;
  WbcProblem problem_;
  PerLeg<bool> stance_{};
  int torque_row_ = 0;  // first of the 12 torque rows
  Mat6x12 wrench_map_;  // J_st,com^T x
  Mat6x12 rdd_map_;     // rdd_c = rdd_0 + rdd_map x
  Vec6 rdd_0_;
  Mat12 qdd_map_;  // qdd = qdd_0 + qdd_map x
  Vec12 qdd_0_;
};

}  // namespace dob
