// How an observer's estimate enters the controller: the four compensation paths of (17), (18), (31) and (36).
#pragma once

#include "controller/task_jacobian.h"
#include "controller/wbc_options.h"

namespace dob {

// What the controller is told about the disturbance; a plain copy of an observer's estimate.
struct DisturbanceEstimate {
  bool has_legs = false;
  Vec12 leg_torque = Vec12::Zero();  // [N m] F_hat of eq (4)
  bool has_com = false;
  Vec6 com_wrench = Vec6::Zero();  // [N; N m] about the CoM
};

struct Compensation {
  Vec6 wrench = Vec6::Zero();                // [N; N m] estimated disturbance wrench in (17)
  Vec6 dynamics = Vec6::Zero();              // [N; N m] the same in (18)
  Vec12 swing_acceleration = Vec12::Zero();  // [m/s^2] what (31) subtracts; zero for standing legs
  Vec12 torque = Vec12::Zero();              // [N m] subtracted from (36)
};

// Points at which the feet's forces and tasks act: the contact point of a standing leg, the sphere centre of a
// swinging one. f_hat is defined at these points.
PerLeg<LegPoint> task_points(const ModelTerms& m, const PerLeg<bool>& stance) noexcept;

// `J`: the factored Jacobian of `points`. `with_swing_term` = false skips the swing term of (31), which only the QP
// needs.
Compensation compensate(const ModelTerms& m, const PerLeg<LegPoint>& points, const TaskJacobian& J,
                        const PerLeg<bool>& stance, const DisturbanceEstimate& estimate, const Routing& routing,
                        bool with_swing_term) noexcept;

// J_sw M_c^-1 P J_sw^T f_sw of (29), (31): acceleration that forces on the swinging feet cause while the standing feet
// stay. 12-vector [m/s^2], zero for standing legs. For P = I - pinv(J_st) J_st with J_st of full row rank,
//     M_c^-1 P = M^-1 - M^-1 J_st^T (J_st M^-1 J_st^T)^-1 J_st M^-1,
// the inverse inertia of the robot with its standing feet held. It is applied leg by leg in the coordinates of
// controller/task_jacobian.h: qdd = -E y of a standing leg, M_qq qdd = D^T f - F^T y of a swinging one, and what the
// legs leave to the trunk is one positive definite system for its acceleration y.
Vec12 swing_response(const ModelTerms& m, const PerLeg<LegPoint>& points, const TaskJacobian& J,
                     const PerLeg<bool>& stance, const Vec12& tip_force) noexcept;

}  // namespace dob
