// What one control interval [t - dt, t] does to the robot beyond what is known of it: dt times the mean disturbance.
// Every observer that is not written out in momentum.h or com_wrench.h filters one of these.
//
// Differences over one interval need no anchor p(0): an observer may start in motion, and an interval that is lost does
// not come back later as a jump. `start` of an update has to be the same values as `now` of the one before, or their
// noise does not telescope. Known forces and torques are taken at t - dt, where they acted: accuracy first order in dt.
#pragma once

#include "observers/observer.h"

namespace dob {

// alpha of (8) at t - dt: C_q^T qd + tau + J_j^T f with the measured forces of ALL feet [N m].
Vec12 known_joint_torque(const ObserverInput& input) noexcept;

// rho(t) - rho(t - dt) - dt alpha [N m s].
Vec12 leg_residual(const ObserverInput& input) noexcept;

// The same from the last twelve rows of (1) and the acceleration by differences, without the momentum:
// M_q (qd(t) - qd(t - dt)) + dt (c_q - tau - J_j^T f), everything but qd(t) at t - dt [N m s].
Vec12 acceleration_residual(const ObserverInput& input) noexcept;

// [m c_dot; L], about the CoM along W [N s; N m s].
Vec6 com_momentum(const ModelTerms& m) noexcept;

// Weight and measured forces of ALL feet at t - dt, about the CoM along W [N; N m].
Vec6 known_com_wrench(const ObserverInput& input) noexcept;

// [m c_dot; L](t) - [m c_dot; L](t - dt) - dt known [N s; N m s].
Vec6 com_residual(const ObserverInput& input) noexcept;

// The answer of an observer of the legs, or of the CoM, alone: its estimate, and whether the input was valid.
Estimate leg_estimate(const Vec12& leg_torque, bool valid) noexcept;
Estimate com_estimate(const Vec6& com_wrench, bool valid) noexcept;

}  // namespace dob
