// The true robot in free flight: M v_dot + h = S^T tau + J^T f in full space, integrated by RK4 with forces
// at any leg points, beside the CONTINUOUS observer eqs (6)-(7) driven by the true disturbance. Nothing here
// uses the project's CoM coordinates, except through what an observer is told.
#pragma once

#include <vector>

#include <Eigen/Cholesky>

#include "observers/momentum_gains.h"
#include "robot/model.h"

namespace dob::test {

struct Push {
  Leg leg = Leg::kLF;
  LegLink link = LegLink::kLower;
  Vec3 p_L = Vec3::Zero();    // [m] where it acts, in the link's frame
  Vec3 force = Vec3::Zero();  // [N] along W
};

class FreeFlight {
 public:
  RobotState state;
  Vec12 torque = Vec12::Zero();         // [N m]
  Vec12 contact_force = Vec12::Zero();  // [N] at the contact points of all feet, known to the observer
  Push push;                            // unknown to it

  FreeFlight(const Model& model, const RobotState& start, const MomentumGains& gains)
      : state(start), model_(model), K_(gains.K), gamma_(K_.size(), Vec12::Zero()) {}

  // Constant torque and forces for a time dt, in steps of at most 0.25 ms.
  void advance(double dt) {
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / 0.25e-3 - 1e-9)));
    for (int i = 0; i < steps; ++i) step(dt / steps);
  }

  ModelTerms terms() const {
    ModelTerms t;
    model_.compute(state, t);
    return t;
  }

  // The push at the joints in CoM coordinates, J_j^T f = (J^T f)_q - (M_bb^-1 M_bq)^T (J^T f)_b.
  Vec12 disturbance(const ModelTerms& t) const {
    const Vec18 w = generalized(t, push.leg, leg_point(t, push.leg, push.link, push.p_L), push.force);
    return w.tail<12>() - t.M_bq.transpose() * t.M_bb.llt().solve(w.head<6>());
  }

  // What the continuous observer (6)-(7), started from zero, estimates of it.
  const Vec12& filtered_disturbance() const { return gamma_.back(); }

 private:
  struct Rates {
    Mat3 R;
    Vec18 v, v_dot;
    std::vector<Vec12> gamma;
  };

  static Vec18 generalized(const ModelTerms& t, Leg leg, const LegPoint& point, const Vec3& force) {
    Vec18 w = Vec18::Zero();
    w.head<3>() = force;
    w.segment<3>(3) = (point.p - t.state.p_WB).cross(force);
    w.segment<3>(6 + 3 * static_cast<int>(leg)) = point.J_q.transpose() * force;
    return w;
  }

  Rates rates(const RobotState& x, const std::vector<Vec12>& gamma) const {
    ModelTerms t;
    model_.compute(x, t);
    Vec18 w = generalized(t, push.leg, leg_point(t, push.leg, push.link, push.p_L), push.force);
    w.tail<12>() += torque;
    for (int l = 0; l < kLegs; ++l) {
      w += generalized(t, static_cast<Leg>(l), t.contact[l], contact_force.segment<3>(3 * l));
    }
    w.head<6>() -= t.h_b;
    w.tail<12>() -= t.h_q;
    Rates rates{skew(x.omega_WB) * x.R_WB, t.velocity(), t.mass_matrix().llt().solve(w), gamma};
    for (std::size_t i = 0; i < K_.size(); ++i) {
      rates.gamma[i] = K_[i] * ((i == 0 ? disturbance(t) : gamma[i - 1]) - gamma.back());
    }
    return rates;
  }

  static void add(RobotState& x, std::vector<Vec12>& gamma, const Rates& k, double s) {
    x.p_WB += s * k.v.head<3>();
    x.R_WB += s * k.R;
    x.q += s * k.v.tail<12>();
    x.v_WB += s * k.v_dot.head<3>();
    x.omega_WB += s * k.v_dot.segment<3>(3);
    x.qd += s * k.v_dot.tail<12>();
    for (std::size_t i = 0; i < gamma.size(); ++i) gamma[i] += s * k.gamma[i];
  }

  Rates rates_after(const Rates& k, double s) const {
    RobotState x = state;
    std::vector<Vec12> gamma = gamma_;
    add(x, gamma, k, s);
    return rates(x, gamma);
  }

  void step(double h) {
    const Rates k1 = rates(state, gamma_);
    const Rates k2 = rates_after(k1, h / 2);
    const Rates k3 = rates_after(k2, h / 2);
    const Rates k4 = rates_after(k3, h);
    add(state, gamma_, k1, h / 6);
    add(state, gamma_, k2, h / 3);
    add(state, gamma_, k3, h / 3);
    add(state, gamma_, k4, h / 6);
  }

  const Model& model_;
  std::vector<double> K_;
  std::vector<Vec12> gamma_;
};

}  // namespace dob::test
