// One leg per lane: motion of a chain of three joints and the sums over its bodies that the dynamics need. All
// vectors are along the axes of W, positions relative to the base origin, velocities absolute, accelerations those at
// v_dot = 0.
#pragma once

#include <array>

#include "robot/description.h"
#include "robot/lanes.h"
#include "robot/model_terms.h"

namespace dob {

// Constants, in the frame of the link.
struct LanesBody {
  Lanes mass;         // [kg]
  LanesVec3 com;      // [m]
  LanesSym3 inertia;  // [kg m^2] about the centre of mass
};

struct LanesLink {
  LanesVec3 joint_origin;  // [m] in the parent link's frame
  LanesVec3 joint_axis;
  LanesBody body;
};

struct LanesLeg {
  std::array<LanesLink, kJointsPerLeg> links;
  LanesVec3 foot_center;  // [m]
  Lanes foot_radius;      // [m]
};

struct LanesMotion {
  LanesMat3 R_WL;
  LanesVec3 o;      // [m] origin of the link frame
  LanesVec3 axis;   // of the link's joint
  LanesVec3 omega;  // [rad/s]
  LanesVec3 v;      // [m/s]
  LanesVec3 alpha;  // [rad/s^2]
  LanesVec3 a;      // [m/s^2]
};

// Sums over a set of bodies, moments about the base origin.
struct LanesSums {
  Lanes mass;
  LanesVec3 first_moment;  // [kg m] sum m r
  LanesSym3 inertia;       // [kg m^2]
  LanesSym3 inertia_rate;  // [kg m^2/s]
  LanesVec3 force;         // [N] of the bias forces h
  LanesVec3 moment;        // [N m]
  LanesVec3 linear;        // [kg m/s] momentum
  LanesVec3 angular;       // [kg m^2/s]

  LanesSums& operator+=(const LanesSums& b) noexcept;
};

// Rows of one joint. `linear` and `angular` are its column of M_bq: the momentum of everything the joint moves when
// it alone turns at unit rate. The rates of that column are what d/dt of A = M_bb^-1 M_bq needs.
struct LanesJoint {
  LanesVec3 linear, angular;
  LanesVec3 linear_rate, angular_rate;
  Lanes M_qq[kJointsPerLeg];  // with the joints of its leg up to itself
  Lanes h, p, CTv;            // of h_q, p_q, CTv_q
};

struct LanesLegTerms {
  std::array<LanesJoint, kJointsPerLeg> joints;
  LanesSums sums;
};

// What one body per lane adds to mass, momentum and bias sums of the robot, about the base origin along W.
LanesSums body_sums(const LanesBody& body, const LanesMotion& link, const LanesVec3& v_base) noexcept;

// Legs first_leg (lane 0), first_leg + 1 (lane 1) and so on on a base that moves as `base`. Fills links, feet and the
// joint rows of the full space in `t`, whose state is already set.
LanesLegTerms compute_legs(const LanesLeg& legs, const LanesMotion& base, int first_leg, ModelTerms& t) noexcept;

}  // namespace dob
