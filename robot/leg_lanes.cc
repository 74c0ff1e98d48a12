#include "robot/leg_lanes.h"

namespace dob {
namespace {

using Chain = std::array<LanesMotion, kJointsPerLeg>;

// Rodrigues: R = cos q I + sin q [a] + (1 - cos q) a a^T.
LanesMat3 rotation(const LanesVec3& a, Lanes q) noexcept {
  const auto [s, c] = sincos(q);
  const LanesVec3 sa = s * a;
  const LanesVec3 ca = (1.0 - c) * a;
  const Lanes xy = ca.x * a.y, xz = ca.x * a.z, yz = ca.y * a.z;
  return {{ca.x * a.x + c, xy + sa.z, xz - sa.y},
          {xy - sa.z, ca.y * a.y + c, yz + sa.x},
          {xz + sa.y, yz - sa.x, ca.z * a.z + c}};
}

LanesMotion link_motion(const LanesMotion& parent, const LanesLink& link, Lanes q, Lanes qd) noexcept {
  const LanesVec3 d = parent.R_WL * link.joint_origin;
  const LanesVec3 v_d = cross(parent.omega, d);
  LanesMotion m;
  m.o = parent.o + d;
  m.v = parent.v + v_d;
  m.a = parent.a + cross(parent.alpha, d) + cross(parent.omega, v_d);
  m.axis = parent.R_WL * link.joint_axis;
  const LanesVec3 spin = qd * m.axis;
  m.alpha = parent.alpha + cross(parent.omega, spin);
  m.omega = parent.omega + spin;
  m.R_WL = parent.R_WL * rotation(link.joint_axis, q);
  return m;
}

// m (r^2 1 - r r^T) of a point mass, with mr = m r.
LanesSym3 point_inertia(const LanesVec3& mr, const LanesVec3& r) noexcept {
  const Lanes xx = mr.x * r.x, yy = mr.y * r.y, zz = mr.z * r.z;
  return {yy + zz, xx + zz, xx + yy, -mr.x * r.y, -mr.x * r.z, -mr.y * r.z};
}

// Its rate, with r_dot the velocity of the point.
LanesSym3 point_inertia_rate(const LanesVec3& mr, const LanesVec3& r_dot) noexcept {
  const Lanes xx = mr.x * r_dot.x, yy = mr.y * r_dot.y, zz = mr.z * r_dot.z;
  return {2.0 * (yy + zz),
          2.0 * (xx + zz),
          2.0 * (xx + yy),
          -mr.x * r_dot.y - mr.y * r_dot.x,
          -mr.x * r_dot.z - mr.z * r_dot.x,
          -mr.y * r_dot.z - mr.z * r_dot.y};
}

// [w] I - I [w]: rate of the inertia of a body that turns at w.
LanesSym3 turning_rate(const LanesVec3& w, const LanesSym3& I) noexcept {
  const Lanes x_yz = w.x * I.yz, y_xz = w.y * I.xz, z_xy = w.z * I.xy;
  return {2.0 * (y_xz - z_xy),
          2.0 * (z_xy - x_yz),
          2.0 * (x_yz - y_xz),
          w.z * (I.xx - I.yy) + w.y * I.yz - w.x * I.xz,
          w.y * (I.zz - I.xx) - w.z * I.yz + w.x * I.xy,
          w.x * (I.yy - I.zz) + w.z * I.xz - w.y * I.xy};
}

// Row and column of joint k from the sums over everything it moves. With S = [o x axis; axis] the joint's unit twist
// at the base origin, every entry is a product of S or of its rate with a momentum or a force.
LanesJoint joint_terms(const Chain& chain, const std::array<LanesVec3, kJointsPerLeg>& moment_arms, int k,
                       const LanesSums& s, const LanesVec3& v_base) noexcept {
  const LanesMotion& link = chain[k];
  const LanesVec3& axis = link.axis;
  const LanesVec3& arm = moment_arms[k];  // o x axis
  const LanesVec3 axis_dot = cross(link.omega, axis);
  const LanesVec3 arm_dot = cross(link.v - v_base, axis) + cross(link.o, axis_dot);
  const LanesVec3 first_moment_dot = s.linear - s.mass * v_base;
  LanesJoint j;
  j.linear = s.mass * arm + cross(axis, s.first_moment);
  j.angular = s.inertia * axis + cross(s.first_moment, arm);
  j.linear_rate = s.mass * arm_dot + cross(axis_dot, s.first_moment) + cross(axis, first_moment_dot);
  j.angular_rate =
      s.inertia_rate * axis + s.inertia * axis_dot + cross(first_moment_dot, arm) + cross(s.first_moment, arm_dot);
  for (int i = 0; i <= k; ++i) j.M_qq[i] = dot(chain[i].axis, j.angular) + dot(moment_arms[i], j.linear);
  j.h = dot(axis, s.moment) + dot(arm, s.force);
  j.p = dot(axis, s.angular) + dot(arm, s.linear);
  // The full rate of the twist moves with the base, too: v_WL x axis instead of (v_WL - v_WB) x axis.
  j.CTv = dot(axis_dot, s.angular) + dot(arm_dot + cross(v_base, axis), s.linear);
  return j;
}

void store_link(const LanesMotion& m, int first_leg, int k, ModelTerms& t) noexcept {
  const auto to = [&](auto member) {
    return [&t, first_leg, k, member](int n) { return (t.link[first_leg + n][k].*member).data(); };
  };
  const auto to_column = [&](int column) {
    return [&t, first_leg, k, column](int n) { return t.link[first_leg + n][k].R_WL.col(column).data(); };
  };
  store(m.R_WL.c0, to_column(0));
  store(m.R_WL.c1, to_column(1));
  store(m.R_WL.c2, to_column(2));
  store(broadcast(t.state.p_WB) + m.o, to(&LinkKinematics::p_WL));
  store(m.axis, to(&LinkKinematics::axis_W));
  store(m.omega, to(&LinkKinematics::omega));
  store(m.v, to(&LinkKinematics::v));
  store(m.alpha, to(&LinkKinematics::alpha_bias));
  store(m.a, to(&LinkKinematics::a_bias));
}

void store_joint(const LanesJoint& j, int k, int first_leg, ModelTerms& t) noexcept {
  const int row = kJointsPerLeg * first_leg + k;
  store(j.linear, [&](int n) { return t.M_bq.col(row + kJointsPerLeg * n).head<3>().data(); });
  store(j.angular, [&](int n) { return t.M_bq.col(row + kJointsPerLeg * n).tail<3>().data(); });
  for (int n = 0; n < kLanes; ++n) {
    Mat3& M_qq = t.M_qq[first_leg + n];
    for (int i = 0; i <= k; ++i) M_qq(i, k) = M_qq(k, i) = j.M_qq[i][n];
    t.h_q[row + kJointsPerLeg * n] = j.h[n];
    t.p_q[row + kJointsPerLeg * n] = j.p[n];
    t.CTv_q[row + kJointsPerLeg * n] = j.CTv[n];
  }
}

// Foot centre and contact point. The contact point stays below the centre while the sphere rolls, so its acceleration
// has no centripetal term: d/dt(v + omega x (-r z)) at v_dot = 0.
void store_feet(const Chain& chain, const LanesLeg& legs, int first_leg, ModelTerms& t) noexcept {
  const LanesMotion& lower = chain[kJointsPerLeg - 1];
  const LanesVec3 d = lower.R_WL * legs.foot_center;
  const LanesVec3 v_d = cross(lower.omega, d);
  const LanesVec3 p = lower.o + d;
  const LanesVec3 v = lower.v + v_d;
  const LanesVec3 a = lower.a + cross(lower.alpha, d) + cross(lower.omega, v_d);
  // w x (0, 0, -radius)
  const auto rolling = [&](const LanesVec3& w) {
    return LanesVec3{-w.y * legs.foot_radius, w.x * legs.foot_radius, broadcast(0.0)};
  };
  const auto to = [&](PerLeg<LegPoint>& points, auto member) {
    return [&points, first_leg, member](int n) { return (points[first_leg + n].*member).data(); };
  };
  const auto to_column = [&](PerLeg<LegPoint>& points, int k) {
    return [&points, first_leg, k](int n) { return points[first_leg + n].J_q.col(k).data(); };
  };
  const LanesVec3 p_W = broadcast(t.state.p_WB) + p;
  store(p_W, to(t.foot, &LegPoint::p));
  store(v, to(t.foot, &LegPoint::v));
  store(a, to(t.foot, &LegPoint::Jdot_v));
  store({p_W.x, p_W.y, p_W.z - legs.foot_radius}, to(t.contact, &LegPoint::p));
  store(v + rolling(lower.omega), to(t.contact, &LegPoint::v));
  store(a + rolling(lower.alpha), to(t.contact, &LegPoint::Jdot_v));
  for (int k = 0; k < kJointsPerLeg; ++k) {
    const LanesVec3 column = cross(chain[k].axis, p - chain[k].o);
    store(column, to_column(t.foot, k));
    store(column + rolling(chain[k].axis), to_column(t.contact, k));
  }
}

}  // namespace

LanesSums& LanesSums::operator+=(const LanesSums& b) noexcept {
  mass += b.mass;
  first_moment += b.first_moment;
  inertia += b.inertia;
  inertia_rate += b.inertia_rate;
  force += b.force;
  moment += b.moment;
  linear += b.linear;
  angular += b.angular;
  return *this;
}

LanesSums body_sums(const LanesBody& body, const LanesMotion& link, const LanesVec3& v_base) noexcept {
  const LanesVec3 d = link.R_WL * body.com;
  const LanesVec3 v_d = cross(link.omega, d);
  const LanesVec3 r = link.o + d;
  const LanesVec3 v = link.v + v_d;
  LanesVec3 a = link.a + cross(link.alpha, d) + cross(link.omega, v_d);
  a.z += kGravity;
  const LanesSym3 inertia = rotate(link.R_WL, body.inertia);  // about the centre of mass
  const LanesVec3 I_omega = inertia * link.omega;
  LanesSums s;
  s.mass = body.mass;
  s.first_moment = body.mass * r;
  s.inertia = inertia;
  s.inertia += point_inertia(s.first_moment, r);
  s.inertia_rate = turning_rate(link.omega, inertia);
  s.inertia_rate += point_inertia_rate(s.first_moment, v - v_base);
  s.force = body.mass * a;
  s.moment = inertia * link.alpha + cross(link.omega, I_omega) + cross(r, s.force);
  s.linear = body.mass * v;
  s.angular = I_omega + cross(r, s.linear);
  return s;
}

LanesLegTerms compute_legs(const LanesLeg& legs, const LanesMotion& base, int first_leg, ModelTerms& t) noexcept {
  Chain chain;
  std::array<LanesVec3, kJointsPerLeg> moment_arms;
  for (int k = 0; k < kJointsPerLeg; ++k) {
    const int row = kJointsPerLeg * first_leg + k;
    const Lanes q = gather_lanes<kJointsPerLeg>(t.state.q.data() + row);
    const Lanes qd = gather_lanes<kJointsPerLeg>(t.state.qd.data() + row);
    chain[k] = link_motion(k == 0 ? base : chain[k - 1], legs.links[k], q, qd);
    moment_arms[k] = cross(chain[k].o, chain[k].axis);
    store_link(chain[k], first_leg, k, t);
  }
  LanesLegTerms terms;
  for (int k = kJointsPerLeg - 1; k >= 0; --k) {
    const LanesSums sums = body_sums(legs.links[k].body, chain[k], base.v);
    if (k == kJointsPerLeg - 1) {
      terms.sums = sums;
    } else {
      terms.sums += sums;
    }
    terms.joints[k] = joint_terms(chain, moment_arms, k, terms.sums, base.v);
    store_joint(terms.joints[k], k, first_leg, t);
  }
  store_feet(chain, legs, first_leg, t);
  return terms;
}

}  // namespace dob
