// The quadratic problem (12)-(35) in its exact 12-variable form.
//
// Per foot one 3-vector x_l: the ground reaction force f if the foot stands, the scaled tracking error s = 1e4 delta if
// it swings; always 12 variables. The equality rows (18), (20) and the softened row (33) are solved for the rest:
//     rdd_c = M_com^-1 (J_st,com^T f + w_18 - m g)                     (18)
//     J_com rdd_c + J_j qdd = e                                        (20), (33)
//     e     = -bias for standing feet,  x_cmd - bias + delta for swinging ones,
// where |delta| is the slack gamma of (33) at the optimum. What remains are friction (23) and torque (24) rows.
// Exact as long as J_j (12x12, all feet) is invertible, i.e. no knee is stretched.
//
// Nothing of size 12x12 is formed on the way. In the coordinates of controller/task_jacobian.h, with the trunk's
// acceleration y = y_0 + Y x (Y is 6x12) between x and the rest, every map from x is of rank six plus a block per leg:
//     rdd_c   = rdd_0 + M_com^-1 W x                W_l = [I; skew(arm_l)] of a standing foot, else 0
//     y       = S^-1 (rdd_c - A_c D^-1 e)           Y_l = S^-1 (standing ? M_com^-1 W_l : -A_c,l B_l)
//     qdd_l   = D_l^-1 e_0,l - E_l y + B_l x_l      B_l = D_l^-1 / 1e4 of a swinging foot, else 0
//     tau_l   = tau_0,l + (F_l^T - M_qq,l E_l) Y x + (M_qq,l B_l - [standing] D_l^T) x_l
// so that the Hessian of (17), r |qdd|^2 + r |rdd_c|^2 + q |W x - ...|^2 + r |f|^2 + slack |delta|^2, is
//     H = Y^T K - r V^T Y + W^T N W + diag,         K = r (E^T E Y - V),  V = E^T B,  N = q I + r M_com^-2,
// of which one triangle is computed: V has columns for swinging feet only, W for standing ones.
#pragma once

#include "controller/compensation.h"
#include "controller/motion_planner.h"
#include "controller/task_jacobian.h"
#include "controller/wbc_options.h"
#include "controller/wbc_problem.h"

namespace dob {

inline constexpr double kTrackingErrorScale = 1e4;  // s = scale * delta, so that the Hessian block of s is about I

// zeta of (12) and what the tick needs of it.
struct WbcSolution {
  Vec6 rdd_c = Vec6::Zero();             // [m/s^2; rad/s^2] I_c^-1 L_dot in the angular part
  Vec12 qdd = Vec12::Zero();             // [rad/s^2]
  Vec12 foot_force = Vec12::Zero();      // [N] ground reaction forces, zero for swinging feet
  Vec12 tracking_error = Vec12::Zero();  // [m/s^2] delta, zero for standing feet
};

// Desired wrench (16) at the CoM [N; N m], with the orientation error that the options ask for.
Vec6 desired_wrench(const ModelTerms& m, const MotionReference& reference, const WbcOptions& options) noexcept;

class WholeBodyQp {
 public:
  explicit WholeBodyQp(const WbcOptions& options) : options_(options) {}

  // Builds the reduced problem. `J` is the factored Jacobian of `points`. What is not finite in the terms is not finite
  // in the problem either, and for the solver to refuse.
  void assemble(const ModelTerms& m, const PerLeg<bool>& stance, const MotionReference& reference,
                const Compensation& compensation, const PerLeg<LegPoint>& points, const TaskJacobian& J) noexcept;

  const WbcProblem& problem() const noexcept { return problem_; }

  // The same problem without its acceleration rows; and with its contact rows (23) alone, which is always feasible.
  WbcProblem without_acceleration_rows() const noexcept { return with_first_rows(acceleration_row_); }
  WbcProblem with_contact_rows_only() const noexcept { return with_first_rows(torque_row_); }

  // Everything else of zeta from the reduced problem's x; `J` as in assemble().
  WbcSolution recover(const Vec12& x, const TaskJacobian& J) const noexcept;

 private:
  using Rows6x12 = Eigen::Matrix<double, 6, 12, Eigen::RowMajor>;

  void assemble_maps(const ModelTerms& m, const MotionReference& reference, const Compensation& compensation,
                     const PerLeg<LegPoint>& points, const TaskJacobian& J) noexcept;
  void assemble_cost(const Vec6& wrench_error, const TaskJacobian& J) noexcept;
  template <int leg>
  void assemble_hessian(const Rows6x12& K, const Rows6x12& NW, const Rows6x12& V) noexcept;
  void assemble_contact_rows() noexcept;
  void assemble_torque_rows(const ModelTerms& m, const Vec12& compensated, const PerLeg<LegPoint>& points,
                            const TaskJacobian& J) noexcept;
  void assemble_acceleration_rows(const RobotState& state, const TaskJacobian& J) noexcept;
  WbcProblem with_first_rows(int rows) const noexcept;
  Vec6 per_com_inertia(const Vec6& wrench) const noexcept;  // M_com^-1 times

  WbcOptions options_;
  WbcProblem problem_;
  PerLeg<bool> stance_{};
  int torque_row_ = 0;  // first of the torque rows: behind the contact rows
  int acceleration_row_ = 0;
  double mass_ = 0.0;
  Mat3 I_c_inv_;
  Rows6x12 W_;
  Rows6x12 Y_;
  PerLeg<Mat3> B_;
  Vec6 rdd_0_;
  Vec12 e_0_;
  Vec12 own_qdd_0_;  // D^-1 e_0: what the legs do while the trunk does not accelerate
  Vec12 qdd_0_;
};

}  // namespace dob
