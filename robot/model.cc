#include "robot/model.h"

#include <Eigen/LU>

namespace dob {
namespace {

constexpr int kPasses = kLegs / kLanes;
using AllLegTerms = std::array<LanesLegTerms, kPasses>;

// One column of A_c and of X^-T M_bq (momentum about the CoM) per joint.
struct LanesCentroidalJoint {
  LanesVec3 A_linear, A_angular;
  LanesVec3 linear, angular;
};
using LanesCentroidalLeg = std::array<LanesCentroidalJoint, kJointsPerLeg>;

// A force-like 6-vector about the CoM, in every lane.
struct LanesWrench {
  LanesVec3 linear, angular;
};

// Shifts a force-like 6-vector from the base origin to the CoM at c (relative to the base origin): X^-T w.
Vec6 shift_to_com(const Vec3& force, const Vec3& moment, const Vec3& c) noexcept {
  Vec6 w;
  w << force, moment - c.cross(force);
  return w;
}

LanesWrench broadcast_wrench(const Vec6& w) noexcept {
  return {broadcast(Vec3(w.head<3>())), broadcast(Vec3(w.tail<3>()))};
}

// Row of A_c^T w.
Lanes project(const LanesCentroidalJoint& j, const LanesWrench& w) noexcept {
  return dot(j.A_linear, w.linear) + dot(j.A_angular, w.angular);
}

// Base rows of the full space and centroidal quantities. Returns the CoM relative to the base origin.
Vec3 store_base(const LanesSums& lanes, ModelTerms& t) noexcept {
  const Vec3 first_moment = sum_lanes(lanes.first_moment), linear = sum_lanes(lanes.linear);
  const Vec3 force = sum_lanes(lanes.force), moment = sum_lanes(lanes.moment), angular = sum_lanes(lanes.angular);
  const Mat3 inertia = sum_lanes(lanes.inertia);
  const Mat3 first = skew(first_moment);
  t.M_bb << t.mass * Mat3::Identity(), -first, first, inertia;
  t.h_b << force, moment;
  t.p_b << linear, angular;
  t.CTv_b << Vec3::Zero(), linear.cross(t.state.v_WB);

  Vec3 c = first_moment / t.mass;
  t.p_com = t.state.p_WB + c;
  t.I_c = inertia + first_moment * c.transpose();
  t.I_c.diagonal().array() -= first_moment.dot(c);
  t.I_c_inv = t.I_c.inverse();
  t.L = angular - c.cross(linear);
  t.v_c << linear / t.mass, t.I_c_inv * t.L;
  t.h_c_centrifugal = shift_to_com(force, moment, c);
  t.h_c_centrifugal[2] -= t.mass * kGravity;
  return c;
}

LanesCentroidalLeg centroidal_columns(const LanesLegTerms& legs, const Vec3& com, int first_leg,
                                      ModelTerms& t) noexcept {
  const Lanes inverse_mass = broadcast(1.0 / t.mass);
  const LanesSym3 I_c_inv = broadcast_symmetric(t.I_c_inv);
  const LanesVec3 c = broadcast(com);
  LanesCentroidalLeg columns;
  for (int k = 0; k < kJointsPerLeg; ++k) {
    LanesCentroidalJoint& j = columns[k];
    j.linear = legs.joints[k].linear;
    j.angular = legs.joints[k].angular - cross(c, j.linear);
    j.A_linear = inverse_mass * j.linear;
    j.A_angular = I_c_inv * j.angular;
    const int row = kJointsPerLeg * first_leg + k;
    store(j.A_linear, [&](int n) { return t.A_c.col(row + kJointsPerLeg * n).head<3>().data(); });
    store(j.A_angular, [&](int n) { return t.A_c.col(row + kJointsPerLeg * n).tail<3>().data(); });
  }
  return columns;
}

// Entry of M_qq - M_qb M_bb^-1 M_bq between joints of the same lane, without M_qq.
Lanes coupling(const LanesCentroidalJoint& a, const LanesCentroidalJoint& b) noexcept {
  return -(dot(a.A_linear, b.linear) + dot(a.A_angular, b.angular));
}

LanesCentroidalJoint rotate_lanes(const LanesCentroidalJoint& j) noexcept {
  return {rotate_lanes(j.A_linear), rotate_lanes(j.A_angular), rotate_lanes(j.linear), rotate_lanes(j.angular)};
}

// The symmetric matrix M_q. Joints of pass p times those of pass q rotated by r lanes give the blocks of legs
// (lane n of p, lane n + r of q). Within one pass, r and kLanes - r give the same blocks, and where these are one
// the block and its transpose both come up, so that half of the entries do.
void store_leg_inertia(const AllLegTerms& terms, const std::array<LanesCentroidalLeg, kPasses>& columns,
                       Mat12& M_q) noexcept {
  for (int k = 0; k < kJointsPerLeg; ++k) {
    for (int q = 0; q < kPasses; ++q) {
      LanesCentroidalJoint rotated = columns[q][k];
      for (int r = 0; r < kLanes; ++r) {
        for (int p = 0; p <= q; ++p) {
          if (p == q && 2 * r > kLanes) continue;
          const bool half = p == q && (r == 0 || 2 * r == kLanes);
          for (int i = 0; i <= (half ? k : kJointsPerLeg - 1); ++i) {
            Lanes entry = coupling(columns[p][i], rotated);
            if (p == q && r == 0) entry += terms[p].joints[k].M_qq[i];
            for (int n = 0; n < kLanes; ++n) {
              const int row = kJointsPerLeg * (kLanes * p + n) + i;
              const int column = kJointsPerLeg * (kLanes * q + (n + r) % kLanes) + k;
              M_q(row, column) = M_q(column, row) = entry[n];
            }
          }
        }
        rotated = rotate_lanes(rotated);
      }
    }
  }
}

// What the base contributes to the joint rows.
struct LanesBase {
  LanesWrench bias, momentum, rate;  // h_b, p_b and (C^T v)_b - d/dt(M_bb) v_locked, about the CoM
  LanesWrench locked;                // locked velocity M_bb^-1 p_b, at the base origin
};

// Joint rows of (1): c_q = h_q - A^T h_b, rho = p_q - A^T p_b, and the bracket of (3): (C^T v)_q - A^T (C^T v)_b -
// Adot^T p_b, with Adot^T p_b = d/dt(M_qb) v_locked - A^T d/dt(M_bb) v_locked.
void store_joint_rows(const LanesLegTerms& legs, const LanesCentroidalLeg& columns, const LanesBase& base,
                      int first_leg, ModelTerms& t) noexcept {
  for (int k = 0; k < kJointsPerLeg; ++k) {
    const LanesJoint& joint = legs.joints[k];
    const Lanes locked_rate = dot(joint.linear_rate, base.locked.linear) + dot(joint.angular_rate, base.locked.angular);
    const Lanes c_q = joint.h - project(columns[k], base.bias);
    const Lanes rho = joint.p - project(columns[k], base.momentum);
    const Lanes CqT_qd = joint.CTv - locked_rate - project(columns[k], base.rate);
    for (int n = 0; n < kLanes; ++n) {
      const int row = kJointsPerLeg * (first_leg + n) + k;
      t.c_q[row] = c_q[n];
      t.rho[row] = rho[n];
      t.CqT_qd[row] = CqT_qd[n];
    }
  }
}

}  // namespace

Model::Model(const RobotDescription& robot) : robot_(robot), mass_(robot.total_mass()) {
  // The trunk counts once: it sits in the first lane, the others stay without mass.
  const LinkInertia& trunk = robot.trunk.inertia;
  const Lanes first{1.0};
  trunk_ = {first * trunk.mass, broadcast(trunk.com), first * broadcast_symmetric(trunk.inertia)};
  for (int l = 0; l < kLegs; ++l) {
    const int n = l % kLanes;
    const LegDescription& leg = robot.legs[l];
    LanesLeg& lanes = legs_[l / kLanes];
    for (int k = 0; k < kJointsPerLeg; ++k) {
      LanesLink& link = lanes.links[k];
      const LinkInertia& inertia = leg.links[k].inertia;
      set_lane(link.joint_origin, n, leg.joints[k].origin);
      set_lane(link.joint_axis, n, leg.joints[k].axis);
      link.body.mass[n] = inertia.mass;
      set_lane(link.body.com, n, inertia.com);
      set_lane(link.body.inertia, n, inertia.inertia);
    }
    set_lane(lanes.foot_center, n, leg.foot_center);
    lanes.foot_radius[n] = leg.foot_radius;
  }
}

void Model::compute(const RobotState& state, ModelTerms& t) const noexcept {
  t.state = state;
  t.mass = mass_;

  LanesMotion base{};
  base.R_WL = broadcast(state.R_WB);
  base.omega = broadcast(state.omega_WB);
  base.v = broadcast(state.v_WB);
  LanesSums total = body_sums(trunk_, base, base.v);
  AllLegTerms legs;
  for (int p = 0; p < kPasses; ++p) {
    legs[p] = compute_legs(legs_[p], base, kLanes * p, t);
    total += legs[p].sums;
  }
  const Vec3 c = store_base(total, t);
  std::array<LanesCentroidalLeg, kPasses> columns;
  for (int p = 0; p < kPasses; ++p) columns[p] = centroidal_columns(legs[p], c, kLanes * p, t);
  store_leg_inertia(legs, columns, t.M_q);

  // Momentum that the robot would have if it moved with its locked velocity M_bb^-1 p_b, and its rate at constant
  // locked velocity: the only place where the time derivative of A enters.
  const Vec3 omega_locked = t.v_c.tail<3>();
  const Vec3 v_locked = t.v_c.head<3>() - omega_locked.cross(c);  // at the base origin
  const Vec3 first_moment_rate = t.p_b.head<3>() - mass_ * state.v_WB;
  const Vec3 linear_rate = omega_locked.cross(first_moment_rate);
  const Vec3 angular_rate = sum_lanes(total.inertia_rate) * omega_locked + first_moment_rate.cross(v_locked);
  t.Idot_omega = angular_rate - (t.v_c.head<3>() - state.v_WB).cross(t.p_b.head<3>()) - c.cross(linear_rate);

  const LanesWrench bias = broadcast_wrench(shift_to_com(t.h_b.head<3>(), t.h_b.tail<3>(), c));
  const LanesWrench momentum{broadcast(Vec3(t.p_b.head<3>())), broadcast(t.L)};
  const LanesWrench base_rate = broadcast_wrench(shift_to_com(-linear_rate, t.CTv_b.tail<3>() - angular_rate, c));
  const LanesWrench locked{broadcast(v_locked), broadcast(omega_locked)};
  for (int p = 0; p < kPasses; ++p) {
    store_joint_rows(legs[p], columns[p], {bias, momentum, base_rate, locked}, kLanes * p, t);
  }
}

}  // namespace dob
