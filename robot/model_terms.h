// Every kinematic and dynamic term of the quadruped at one state, and of the paper's eq (1) in CoM coordinates.
//
// Full space, along the axes of W:  v = [v_WB; omega_WB; qd],
//     M v_dot + h = S^T tau + J^T f,      h = bias forces including gravity.
// CoM coordinates (Ott et al. 2011, exact, no small-angle or light-leg assumption):
//     v_c = X (v_b + A qd),   A = M_bb^-1 M_bq,   X shifts the reference point from the base origin to the CoM;
//     M_com rdd_c + [m g; 0] = J_com^T f          (first six rows of (1); rdd_c = [c_dd; I_c^-1 L_dot])
//     M_q qdd + c_q          = tau + J_j^T f      (last twelve rows of (1); gravity cancels)
//     point velocity         = J_com v_c + J_j qd                    (27)
//     point acceleration     = J_com rdd_c + J_j qdd + bias          (28)
// The angular part of v_c is the average angular velocity of the whole robot, not the trunk's.
#pragma once

#include "robot/types.h"

namespace dob {

// A point fixed to a link of a leg, or the contact point below the foot sphere, with its Jacobian
// J = [I, -skew(p - p_WB), J_q] where J_q acts on the three joints of its own leg.
struct LegPoint {
  Vec3 p;       // [m] position in W
  Mat3 J_q;     // [m] columns: joints of the leg
  Vec3 v;       // [m/s] velocity J v of the material point
  Vec3 Jdot_v;  // [m/s^2] d/dt(J) v
};

// Frame L of a moving link: its origin lies on the axis of the joint that moves it.
struct LinkKinematics {
  Mat3 R_WL;        // L to W
  Vec3 p_WL;        // [m] origin in W
  Vec3 axis_W;      // unit vector of the link's joint
  Vec3 omega;       // [rad/s]
  Vec3 v;           // [m/s] of the origin
  Vec3 alpha_bias;  // [rad/s^2] angular acceleration at v_dot = 0
  Vec3 a_bias;      // [m/s^2] acceleration of the origin at v_dot = 0
};

// Everything the control tick needs at one state. Plain values; valid after Model::compute.
struct ModelTerms {
  RobotState state;

  // Full space.
  Mat6 M_bb;          // [kg, kg m, kg m^2]
  Mat6x12 M_bq;       // [kg m, kg m^2]
  PerLeg<Mat3> M_qq;  // [kg m^2] diagonal blocks, the legs do not couple directly
  Vec6 h_b;           // [N, N m]
  Vec12 h_q;          // [N m]
  Vec6 CTv_b;         // [N, N m] base rows of C^T v
  Vec12 CTv_q;        // [N m] joint rows of C^T v
  Vec6 p_b;           // [kg m/s, kg m^2/s] base rows of M v, angular part about the base origin
  Vec12 p_q;          // [kg m^2/s] joint rows of M v

  // Centroidal.
  double mass;      // [kg] m
  Vec3 p_com;       // [m] c, position of the CoM in W
  Vec6 v_c;         // [m/s; rad/s] CoM velocity; average angular velocity
  Mat3 I_c;         // [kg m^2] composite inertia about the CoM, axes of W
  Mat3 I_c_inv;     // [1/(kg m^2)]
  Mat6x12 A_c;      // X A: v_c = X v_b + A_c qd
  Vec3 L;           // [kg m^2/s] angular momentum about the CoM
  Vec3 Idot_omega;  // [N m] d/dt(I_c) times the average angular velocity; second half of the exact bias of
                    // the base rows, L_dot = I_c omega_dot + Idot_omega (the paper drops it)

  // Joint rows of (1).
  Mat12 M_q;     // [kg m^2]
  Vec12 c_q;     // [N m] exact bias h_q - A^T h_b, what (24) and (36) call C_q v
  Vec12 rho;     // [kg m^2/s] legs' generalized momentum M_q qd, eq (2)
  Vec12 CqT_qd;  // [N m] exact bracket of (3): d/dt(M_q qd) = CqT_qd + tau + J_j^T f

  // Feet.
  PerLeg<LegPoint> foot;     // centre of the contact sphere
  PerLeg<LegPoint> contact;  // lowest point of the sphere on level ground, rolling bias included in Jdot_v
  PerLeg<std::array<LinkKinematics, kJointsPerLeg>> link;
  Vec6 h_c_centrifugal;  // [N, N m] base rows of h without gravity, shifted to the CoM

  // Assembled full-space matrices (for tests, observers that want them, and other robots' conventions).
  Mat18 mass_matrix() const noexcept;
  Vec18 velocity() const noexcept;
};

// CoM-coordinate Jacobian of a point at p: [I, -skew(p - c)] (3x6).
inline Mat36 point_jacobian_com(const ModelTerms& m, const Vec3& p) noexcept {
  Mat36 J;
  J << Mat3::Identity(), -skew(p - m.p_com);
  return J;
}

// Joint columns of the stacked Jacobian of four leg points, J_j = J_q - J_com A_c (12x12 [m]).
Mat12 jacobian_joints(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept;

// CoM columns of the stacked Jacobian of four leg points (12x6).
Mat12x6 jacobian_com(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept;

// Velocity-product acceleration of the stacked points in CoM coordinates [m/s^2]:
// point acceleration = J_com rdd_c + J_j qdd + this.
Vec12 acceleration_bias(const ModelTerms& m, const PerLeg<LegPoint>& points) noexcept;

// Point given in the frame of a leg's link (position [m]).
LegPoint leg_point(const ModelTerms& m, Leg leg, LegLink link, const Vec3& p_L) noexcept;

// J_com^T f of forces at points of all legs: wrench about the CoM [N; N m].
Vec6 com_wrench(const ModelTerms& m, const PerLeg<LegPoint>& points, const Vec12& forces) noexcept;

// J_j^T f of forces at points of all legs [N m], without forming J_j.
Vec12 joint_torques(const ModelTerms& m, const PerLeg<LegPoint>& points, const Vec12& forces) noexcept;

}  // namespace dob
