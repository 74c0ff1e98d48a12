#include "robot/model.h"

#include <cmath>

#include <Eigen/LU>

namespace dob {
namespace {

// Sums over a set of bodies, about the base origin. "rigid" marks the momentum that the bodies would have if all
// moved with the locked velocity of the whole robot; its rate at constant locked velocity is the only place where
// the time derivative of A = M_bb^-1 M_bq enters.
struct Sums {
  double mass = 0.0;
  Vec3 first_moment = Vec3::Zero();  // sum m r
  Mat3 inertia = Mat3::Zero();       // about the base origin
  Vec3 force = Vec3::Zero();         // of the bias forces h
  Vec3 moment = Vec3::Zero();
  Vec3 linear = Vec3::Zero();  // momentum
  Vec3 angular = Vec3::Zero();

  Sums& operator+=(const Sums& o) noexcept {
    mass += o.mass;
    first_moment += o.first_moment;
    inertia += o.inertia;
    force += o.force;
    moment += o.moment;
    linear += o.linear;
    angular += o.angular;
    return *this;
  }
};

struct RigidSums {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();            // momentum at the locked velocity
  Vec3 linear_rate = Vec3::Zero(), angular_rate = Vec3::Zero();  // its rate at constant locked velocity

  RigidSums& operator+=(const RigidSums& o) noexcept {
    linear += o.linear;
    angular += o.angular;
    linear_rate += o.linear_rate;
    angular_rate += o.angular_rate;
    return *this;
  }
};

// Motion of one body's centre of mass, relative to the base origin.
struct BodyMotion {
  double mass;
  Vec3 r;        // [m] from the base origin
  Vec3 v;        // [m/s] absolute
  Vec3 omega;    // [rad/s]
  Mat3 inertia;  // about the centre of mass, axes of W
};

Sums body_sums(const BodyMotion& b, const Vec3& a_bias, const Vec3& alpha_bias) noexcept {
  Sums s;
  const Vec3 mr = b.mass * b.r;
  const Vec3 I_omega = b.inertia * b.omega;
  s.mass = b.mass;
  s.first_moment = mr;
  s.inertia = b.inertia - mr * b.r.transpose();
  s.inertia.diagonal().array() += mr.dot(b.r);
  s.force = b.mass * (a_bias + Vec3(0.0, 0.0, kGravity));
  s.moment = b.inertia * alpha_bias + b.omega.cross(I_omega) + b.r.cross(s.force);
  s.linear = b.mass * b.v;
  s.angular = I_omega + b.r.cross(s.linear);
  return s;
}

RigidSums body_rigid_sums(const BodyMotion& b, const Vec3& v_base, const Vec3& v_locked,
                          const Vec3& omega_locked) noexcept {
  RigidSums s;
  const Vec3 r_dot = b.v - v_base;
  const Vec3 I_omega = b.inertia * omega_locked;
  s.linear = b.mass * (v_locked + omega_locked.cross(b.r));
  s.angular = I_omega + b.r.cross(s.linear);
  s.linear_rate = b.mass * omega_locked.cross(r_dot);
  s.angular_rate = b.omega.cross(I_omega) - b.inertia * b.omega.cross(omega_locked) + r_dot.cross(s.linear) +
                   b.r.cross(s.linear_rate);
  return s;
}

// Shifts a force-like 6-vector from the base origin to the CoM at c (relative to the base origin): X^-T w.
Vec6 shift_to_com(const Vec3& force, const Vec3& moment, const Vec3& c) noexcept {
  Vec6 w;
  w << force, moment - c.cross(force);
  return w;
}

LegPoint foot_point(const std::array<LinkKinematics, kJointsPerLeg>& chain, const Vec3& r_foot) noexcept {
  const LinkKinematics& lower = chain[kJointsPerLeg - 1];
  LegPoint foot;
  foot.p = lower.p_WL + r_foot;
  foot.v = lower.v + lower.omega.cross(r_foot);
  foot.Jdot_v = lower.a_bias + lower.alpha_bias.cross(r_foot) + lower.omega.cross(lower.omega.cross(r_foot));
  for (int k = 0; k < kJointsPerLeg; ++k) foot.J_q.col(k) = chain[k].axis_W.cross(foot.p - chain[k].p_WL);
  return foot;
}

// The contact point stays below the centre while the sphere rolls, so its acceleration has no centripetal term:
// d/dt(v + omega x (-r z)) at v_dot = 0.
LegPoint contact_point(const std::array<LinkKinematics, kJointsPerLeg>& chain, const LegPoint& foot,
                       double radius) noexcept {
  const LinkKinematics& lower = chain[kJointsPerLeg - 1];
  const Vec3 down(0.0, 0.0, -radius);
  LegPoint contact;
  contact.p = foot.p + down;
  contact.v = foot.v + lower.omega.cross(down);
  contact.Jdot_v = foot.Jdot_v + lower.alpha_bias.cross(down);
  for (int k = 0; k < kJointsPerLeg; ++k) contact.J_q.col(k) = foot.J_q.col(k) + chain[k].axis_W.cross(down);
  return contact;
}

}  // namespace

Model::Model(const RobotDescription& robot) : robot_(robot), mass_(robot.total_mass()) {
  const auto body = [](const LinkInertia& i) { return Body{i.mass, i.com, i.inertia}; };
  trunk_ = body(robot.trunk.inertia);
  for (int l = 0; l < kLegs; ++l) {
    const LegDescription& leg = robot.legs[l];
    for (int k = 0; k < kJointsPerLeg; ++k) {
      const Mat3 s = skew(leg.joints[k].axis);
      legs_[l].joints[k] = {leg.joints[k].axis, leg.joints[k].origin, s, s * s};
      legs_[l].links[k] = body(leg.links[k].inertia);
    }
    legs_[l].foot_center = leg.foot_center;
    legs_[l].foot_radius = leg.foot_radius;
  }
}

void Model::compute(const RobotState& state, ModelTerms& t) const noexcept {
  t.state = state;
  t.mass = mass_;
  const Vec3& v_base = state.v_WB;
  const Vec3& omega_base = state.omega_WB;

  // Trunk.
  BodyMotion trunk;
  trunk.mass = trunk_.mass;
  trunk.r = state.R_WB * trunk_.com;
  trunk.omega = omega_base;
  trunk.v = v_base + omega_base.cross(trunk.r);
  trunk.inertia = state.R_WB * trunk_.inertia * state.R_WB.transpose();
  Sums total = body_sums(trunk, omega_base.cross(omega_base.cross(trunk.r)), Vec3::Zero());

  // Legs, outwards: kinematics; inwards: subtree sums.
  PerLeg<std::array<BodyMotion, kJointsPerLeg>> bodies;
  for (int l = 0; l < kLegs; ++l) {
    const LegModel& leg = legs_[l];
    auto& chain = t.link[l];
    std::array<Sums, kJointsPerLeg> subtree;
    const Mat3* R_parent = &state.R_WB;
    Vec3 omega = omega_base;
    Vec3 alpha = Vec3::Zero();
    Vec3 origin = Vec3::Zero();  // relative to the base origin
    Vec3 v = v_base;
    Vec3 a = Vec3::Zero();
    for (int k = 0; k < kJointsPerLeg; ++k) {
      const Joint& joint = leg.joints[k];
      const double q = state.q[3 * l + k];
      const double qd = state.qd[3 * l + k];
      LinkKinematics& link = chain[k];
      const Vec3 d = *R_parent * joint.origin;
      origin += d;
      v += omega.cross(d);
      a += alpha.cross(d) + omega.cross(omega.cross(d));
      const Vec3 axis = *R_parent * joint.axis;
      alpha += omega.cross(axis) * qd;
      omega += axis * qd;
      Mat3 rotation = std::sin(q) * joint.skew_axis + (1.0 - std::cos(q)) * joint.skew_axis_squared;
      rotation.diagonal().array() += 1.0;
      link.R_WL.noalias() = *R_parent * rotation;
      link.p_WL = state.p_WB + origin;
      link.axis_W = axis;
      link.omega = omega;
      link.v = v;
      link.alpha_bias = alpha;
      link.a_bias = a;
      R_parent = &link.R_WL;

      const Body& body = leg.links[k];
      BodyMotion& motion = bodies[l][k];
      const Vec3 r = link.R_WL * body.com;
      motion.mass = body.mass;
      motion.r = origin + r;
      motion.v = v + omega.cross(r);
      motion.omega = omega;
      motion.inertia = link.R_WL * body.inertia * link.R_WL.transpose();
      subtree[k] = body_sums(motion, a + alpha.cross(r) + omega.cross(omega.cross(r)), alpha);
    }
    for (int k = kJointsPerLeg - 1; k >= 0; --k) {
      if (k + 1 < kJointsPerLeg) subtree[k] += subtree[k + 1];
      const Sums& s = subtree[k];
      const int row = 3 * l + k;
      const Vec3& axis = chain[k].axis_W;
      const Vec3 o = chain[k].p_WL - state.p_WB;
      // Column of M_bq: momentum of the subtree when this joint alone turns at unit rate.
      const Vec3 linear = axis.cross(s.first_moment - s.mass * o);
      const Vec3 angular = s.inertia * axis - s.first_moment.cross(axis.cross(o));
      t.M_bq.col(row) << linear, angular;
      for (int i = 0; i <= k; ++i) {
        const Vec3 o_i = chain[i].p_WL - state.p_WB;
        t.M_qq[l](i, k) = t.M_qq[l](k, i) = chain[i].axis_W.dot(angular - o_i.cross(linear));
      }
      const Vec3 angular_o = s.angular - o.cross(s.linear);  // momentum about the joint's origin
      t.h_q[row] = axis.dot(s.moment - o.cross(s.force));
      t.p_q[row] = axis.dot(angular_o);
      t.CTv_q[row] = chain[k].omega.cross(axis).dot(angular_o) + chain[k].v.cross(axis).dot(s.linear);
    }
    total += subtree[0];
    const Vec3 r_foot = chain[kJointsPerLeg - 1].R_WL * leg.foot_center;
    t.foot[l] = foot_point(chain, r_foot);
    t.contact[l] = contact_point(chain, t.foot[l], leg.foot_radius);
  }

  // Base rows of the full space.
  const Mat3 first = skew(total.first_moment);
  t.M_bb << total.mass * Mat3::Identity(), -first, first, total.inertia;
  t.h_b << total.force, total.moment;
  t.p_b << total.linear, total.angular;
  t.CTv_b << Vec3::Zero(), total.linear.cross(v_base);

  // Centroidal quantities.
  const Vec3 c = total.first_moment / total.mass;
  t.p_com = state.p_WB + c;
  t.I_c = total.inertia + total.mass * c * c.transpose();
  t.I_c.diagonal().array() -= total.mass * c.dot(c);
  t.I_c_inv = t.I_c.inverse();
  t.L = total.angular - c.cross(total.linear);
  const Vec3 v_com = total.linear / total.mass;
  const Vec3 omega_locked = t.I_c_inv * t.L;
  t.v_c << v_com, omega_locked;
  Mat6x12 momentum_columns;  // of M_bq, about the CoM
  momentum_columns.topRows<3>() = t.M_bq.topRows<3>();
  momentum_columns.bottomRows<3>().noalias() = t.M_bq.bottomRows<3>() - skew(c) * t.M_bq.topRows<3>();
  t.A_c.topRows<3>() = momentum_columns.topRows<3>() / total.mass;
  t.A_c.bottomRows<3>().noalias() = t.I_c_inv * momentum_columns.bottomRows<3>();

  // Joint rows of (1): M_q = M_qq - M_bq^T A, c_q = h_q - A^T h_b, rho = p_q - A^T p_b.
  t.M_q.noalias() = -t.A_c.transpose() * momentum_columns;
  for (int l = 0; l < kLegs; ++l) t.M_q.block<3, 3>(3 * l, 3 * l) += t.M_qq[l];
  const Vec6 h_c = shift_to_com(total.force, total.moment, c);
  t.c_q.noalias() = t.h_q - t.A_c.transpose() * h_c;
  t.h_c_centrifugal = h_c;
  t.h_c_centrifugal[2] -= total.mass * kGravity;
  Vec6 momentum_c;
  momentum_c << total.linear, t.L;
  t.rho.noalias() = t.p_q - t.A_c.transpose() * momentum_c;

  // Bracket of (3): (C^T v)_q - A^T (C^T v)_b - Adot^T p_b, with Adot^T p_b = d/dt(M_qb) v_locked
  // - A^T d/dt(M_bb) v_locked.
  const Vec3 v_locked = v_com - omega_locked.cross(c);  // at the base origin
  RigidSums rigid_total = body_rigid_sums(trunk, v_base, v_locked, omega_locked);
  Vec12 rigid_rate;
  for (int l = 0; l < kLegs; ++l) {
    RigidSums s;
    for (int k = kJointsPerLeg - 1; k >= 0; --k) {
      s += body_rigid_sums(bodies[l][k], v_base, v_locked, omega_locked);
      const LinkKinematics& link = t.link[l][k];
      const Vec3 o = link.p_WL - state.p_WB;
      rigid_rate[3 * l + k] =
          link.omega.cross(link.axis_W).dot(s.angular - o.cross(s.linear)) +
          link.axis_W.dot(s.angular_rate - (link.v - v_base).cross(s.linear) - o.cross(s.linear_rate));
    }
    rigid_total += s;
  }
  const Vec3 base_moment = t.CTv_b.tail<3>() - rigid_total.angular_rate;
  const Vec6 base_rate = shift_to_com(-rigid_total.linear_rate, base_moment, c);
  t.CqT_qd.noalias() = t.CTv_q - rigid_rate - t.A_c.transpose() * base_rate;
  t.Idot_omega =
      rigid_total.angular_rate - (v_com - v_base).cross(rigid_total.linear) - c.cross(rigid_total.linear_rate);
}

}  // namespace dob
