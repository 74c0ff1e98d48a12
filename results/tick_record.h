// What the metrics see of one control tick. Positions of feet are sphere centres; everything along W.
#pragma once

#include "controller/qp.h"
#include "robot/types.h"

namespace dob {

// Filled by the trial at time t, after the step [t, t + dt] has been simulated: state and references at t, torques and
// ground reaction forces of the step that follows.
struct TickRecord {
  double t = 0.0;                                                      // [s]
  Vec3 com, com_reference;                                             // [m] the planner's current reference
  Vec3 trunk = Vec3::Zero();                                           // [m] origin of B
  Eigen::Quaterniond trunk_rotation = Eigen::Quaterniond::Identity();  // from B to W
  Vec12 joint_angle = Vec12::Zero();                                   // [rad]
  Vec2 path_position;               // [m] where the commanded path says the CoM should be, never re-planned
  double orientation_error = 0.0;   // [rad] norm of the rotation vector between reference and trunk
  PerLeg<Vec3> foot;                // [m]
  PerLeg<Vec3> foot_reference;      // [m] in swing the spline, in stance the planned foothold
  PerLeg<Vec3> foothold;            // [m] planned, on the ground (without the deliberate landing offset)
  PerLeg<bool> foothold_clamped{};  // that foothold was out of the leg's reach and has been moved
  Vec2 zmp_reference;               // [m] of the CoM reference, eqs (10), (11)
  double zmp_margin = 0.0;          // [m] its distance to the nearest edge of the support polygon, negative outside
  bool zmp_planned = false;         // a ZMP optimisation was due at this tick
  QpStatus zmp_status = QpStatus::kOptimal;  // of it
  int zmp_active_rows = 0;
  double zmp_slack = 0.0;          // [m]
  Vec2 center_of_pressure;         // [m] of the measured ground reaction forces; NaN while no foot carries
  PerLeg<bool> stance{};           // scheduled on the ground
  PerLeg<bool> lift_off{};         // a swing begins at this tick
  PerLeg<bool> touchdown{};        // the foot landed at this tick
  bool disturbance_onset = false;  // a disturbance, a newly drawn one too, began at this tick
  bool disturbance_active = false;
  int applied_forces = 0;  // disturbances that act over the step; the first of them:
  Vec3 applied_point = Vec3::Zero(), applied_force = Vec3::Zero();  // [m], [N]; zero while none acts
  Vec12 foot_force_commanded;  // [N] of the held QP solution, zero for swinging feet
  Vec12 foot_force;            // [N] ground reaction forces measured over the step
  PerLeg<Vec3> slip{};         // [m] tangential displacement of the touching foot during the step
  Vec12 joint_torque;          // [N m] applied
  int saturated_joints = 0;    // joints at their torque limit
  // Estimate at t against the truth over the interval [t - dt, t] that it answers to.
  bool has_leg_estimate = false;
  Vec12 leg_torque_estimate;        // [N m] F_hat
  Vec12 leg_torque_true;            // [N m] sum over disturbances of J_p,j^T f_p in CoM coordinates
  bool has_force_estimate = false;  // exactly one disturbance acts on a leg: F_hat mapped back to its point
  Vec3 force_estimate, force_true;  // [N]
  bool has_com_estimate = false;
  Vec6 com_wrench_estimate, com_wrench_true;  // [N; N m] about the CoM
  bool qp_solved = false;                     // a QP was solved at this tick
  QpStatus qp_status = QpStatus::kOptimal;
  int qp_iterations = 0;
};

}  // namespace dob
