#include "test/controller/full_wbc_problem.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace dob::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSlackUnit = 1e-4;  // [m/s^2]
constexpr double kInf = WbcProblem::kInfinity;

// Full-space quantities and the change to CoM coordinates, from M and h alone (reference equations of
// robot/model_terms.h: v_c = X (v_b + A qd)).
struct Coordinates {
  Mat18 M;
  Vec18 h;
  Mat6 M_bb_inv, X, X_inv;
  Mat6x12 A;

  explicit Coordinates(const ModelTerms& m) : M(m.mass_matrix()) {
    h << m.h_b, m.h_q;
    M_bb_inv = M.topLeftCorner<6, 6>().ldlt().solve(Mat6::Identity());
    A = M_bb_inv * M.topRightCorner<6, 12>();
    X.setIdentity();
    X.topRightCorner<3, 3>() = -skew(m.p_com - m.state.p_WB);
    X_inv = X.inverse();
  }
};

Mat3x18 jacobian(const ModelTerms& m, const LegPoint& point, int leg) {
  Mat3x18 J = Mat3x18::Zero();
  J.leftCols<3>().setIdentity();
  J.middleCols<3>(3) = -skew(point.p - m.state.p_WB);
  J.middleCols<3>(6 + 3 * leg) = point.J_q;
  return J;
}

// The literal term of (31): J_sw M_c^-1 P J_sw^T f_sw with P = I - pinv(J_st) J_st and M_c = P M + I - P, in CoM
// coordinates.
VectorXd printed_swing_term(const MatrixXd& M, const MatrixXd& J_st, const MatrixXd& J_sw, const VectorXd& f_sw) {
  const MatrixXd I = MatrixXd::Identity(18, 18);
  const MatrixXd P = I - J_st.completeOrthogonalDecomposition().pseudoInverse() * J_st;
  const MatrixXd M_c = P * M + I - P;
  return J_sw * M_c.partialPivLu().solve(P * J_sw.transpose() * f_sw);
}

// The desired wrench (16) from its definition.
Vec6 printed_wrench(const ModelTerms& m, const MotionReference& ref, const WbcOptions& o) {
  Vec3 turn;
  if (o.orientation_error == WbcOptions::OrientationError::kZyxAngles) {
    const auto angles = [](const Mat3& R) {
      return Vec3(std::atan2(R(2, 1), R(2, 2)), -std::asin(R(2, 0)), std::atan2(R(1, 0), R(0, 0)));
    };
    turn = angles(ref.R_WB) - angles(m.state.R_WB);  // instances keep away from +-pi
  } else {
    Eigen::Quaterniond q(Mat3(ref.R_WB * m.state.R_WB.transpose()));
    if (q.w() < 0.0) q.coeffs() *= -1.0;
    const double s = q.vec().norm();
    turn = s > 0.0 ? Vec3(2.0 * std::atan2(s, q.w()) / s * q.vec()) : Vec3::Zero();
  }
  Vec6 wrench;
  for (int i = 0; i < 3; ++i) {
    wrench[i] = o.wrench_kp[i] * (ref.com.p[i] - m.p_com[i]) + o.wrench_kd[i] * (ref.com.v[i] - m.v_c[i]) +
                m.mass * (ref.com.a[i] + (i == 2 ? kGravity : 0.0));
    wrench[3 + i] = o.wrench_kp[3 + i] * turn[i] + o.wrench_kd[3 + i] * (ref.omega[i] - m.state.omega_WB[i]) +
                    m.I_c.row(i).dot(ref.alpha);
  }
  return wrench;
}

// Largest (sign = 1) or smallest (-1) acceleration of joint j, see controller/acceleration_limits.h.
double acceleration_bound(const ModelTerms& m, const WbcOptions& o, int j, double rest, double sign) {
  const double q = sign * m.state.q[j], qd = sign * m.state.qd[j], T = o.acceleration_horizon;
  const double q_max = sign > 0.0 ? o.joint_limits.upper[j] : -o.joint_limits.lower[j];
  const double bound = std::min((o.joint_limits.velocity[j] - qd) / T, 2.0 * (q_max - q - qd * T) / (T * T));
  return sign * std::max(bound, sign * rest);
}

}  // namespace

FullProblem full_problem(const WbcInstance& in, const WbcOptions& o, const Routing& routing) {
  const ModelTerms& m = in.m;
  const Coordinates c(m);
  std::vector<int> stance, swing;
  for (int l = 0; l < kLegs; ++l) (in.stance[l] ? stance : swing).push_back(l);
  FullProblem p;
  p.n_stance = static_cast<int>(stance.size());
  p.n_swing = static_cast<int>(swing.size());
  const int nf = 3 * p.n_stance, ns = 3 * p.n_swing, n = 18 + nf + ns;

  // Jacobians and bias accelerations in CoM coordinates.
  const Vec6 gravity_b = (Vec6() << 0, 0, m.mass * kGravity, 0, 0, 0).finished();
  const auto split = [&](int leg, const LegPoint& point, MatrixXd& J, VectorXd& bias, int row) {
    const Mat3x18 full = jacobian(m, point, leg);
    J.block(row, 0, 3, 6) = full.leftCols<6>() * c.X_inv;
    J.block(row, 6, 3, 12) = full.rightCols<12>() - full.leftCols<6>() * c.A;
    bias.segment(row, 3) =
        point.Jdot_v + full.leftCols<6>() * c.M_bb_inv * (c.X.transpose() * gravity_b - c.h.head<6>());
  };
  MatrixXd J_st(nf, 18), J_sw(ns, 18);
  VectorXd bias_st(nf), bias_sw(ns);
  for (int i = 0; i < p.n_stance; ++i) split(stance[i], m.contact[stance[i]], J_st, bias_st, 3 * i);
  for (int i = 0; i < p.n_swing; ++i) split(swing[i], m.foot[swing[i]], J_sw, bias_sw, 3 * i);

  MatrixXd M = MatrixXd::Zero(18, 18);  // block-diagonal in CoM coordinates
  M.topLeftCorner(6, 6) = c.X_inv.transpose() * c.M.topLeftCorner<6, 6>() * c.X_inv;
  M.bottomRightCorner(12, 12) = c.M.bottomRightCorner<12, 12>() - c.A.transpose() * c.M.topRightCorner<6, 12>();
  VectorXd c_q = c.h.tail<12>() - c.A.transpose() * c.h.head<6>();
  if (o.coriolis == WbcOptions::Coriolis::kNeglected) c_q.setZero();

  // Tip forces f_hat from F_hat = J_j^T f_hat of all feet.
  MatrixXd J_all(12, 12);
  for (int i = 0; i < p.n_stance; ++i) J_all.middleRows(3 * stance[i], 3) = J_st.block(3 * i, 6, 3, 12);
  for (int i = 0; i < p.n_swing; ++i) J_all.middleRows(3 * swing[i], 3) = J_sw.block(3 * i, 6, 3, 12);
  const VectorXd f_hat = J_all.transpose().fullPivLu().solve(VectorXd(in.estimate.leg_torque));
  VectorXd f_hat_st(nf), f_hat_sw(ns);
  for (int i = 0; i < p.n_stance; ++i) f_hat_st.segment(3 * i, 3) = f_hat.segment(3 * stance[i], 3);
  for (int i = 0; i < p.n_swing; ++i) f_hat_sw.segment(3 * i, 3) = f_hat.segment(3 * swing[i], 3);

  // Cost (17).
  const MatrixXd W = J_st.leftCols(6).transpose();
  VectorXd w_hat = W * f_hat_st;
  if (routing.wrench_source == Routing::WrenchSource::kAllLegs) w_hat += J_sw.leftCols(6).transpose() * f_hat_sw;
  if (routing.wrench_source == Routing::WrenchSource::kCom && in.estimate.has_com) w_hat = in.estimate.com_wrench;
  const VectorXd w = (routing.wrench_17 ? 1.0 : 0.0) * w_hat - VectorXd(printed_wrench(m, in.reference, o));
  p.H = o.regularization * MatrixXd::Identity(n, n);
  p.H.block(18, 18, nf, nf) += o.wrench_weight * W.transpose() * W;
  p.H.bottomRightCorner(ns, ns) = o.slack_weight * MatrixXd::Identity(ns, ns);
  p.g = VectorXd::Zero(n);
  p.g.segment(18, nf) = o.wrench_weight * W.transpose() * w;

  // Equality rows (18), (20).
  p.E = MatrixXd::Zero(6 + nf, n);
  p.E.topLeftCorner(6, 6) = M.topLeftCorner(6, 6);
  p.E.block(0, 18, 6, nf) = o.printed_sign_21 ? W : MatrixXd(-W);
  p.E.block(6, 0, nf, 18) = J_st;
  p.e.resize(6 + nf);
  p.e << (routing.dynamics_18 ? 1.0 : 0.0) * w_hat - gravity_b, -bias_st;

  // Inequality rows (23), (24), joint accelerations, (33).
  p.n_torque_rows = o.torque_rows ? kJoints : 0;
  p.n_acceleration_rows = o.joint_acceleration_limits ? kJoints : 0;
  p.D = MatrixXd::Zero(p.swing_row() + 2 * ns, n);
  p.lower = VectorXd::Constant(p.D.rows(), -kInf);
  p.upper = VectorXd::Constant(p.D.rows(), kInf);
  for (int i = 0; i < p.n_stance; ++i) {
    for (int k = 0; k < 4; ++k) {
      const int row = 5 * i + k;
      p.D(row, 18 + 3 * i + k / 2) = k % 2 == 0 ? 1.0 : -1.0;
      p.D(row, 18 + 3 * i + 2) = -o.friction;
      p.upper[row] = 0.0;
    }
    p.D(5 * i + 4, 18 + 3 * i + 2) = 1.0;
    p.lower[5 * i + 4] = o.min_normal_force;
  }
  p.torque = MatrixXd::Zero(12, n);
  p.torque.middleCols(6, 12) = M.bottomRightCorner(12, 12);
  p.torque.middleCols(18, nf) = -J_st.rightCols(12).transpose();
  if (o.torque_rows) {
    VectorXd sent = VectorXd::Zero(12);
    if (routing.torque_36) sent += J_st.rightCols(12).transpose() * f_hat_st;
    if (routing.swing_31 == Routing::Swing::kDirect) sent += J_sw.rightCols(12).transpose() * f_hat_sw;
    p.D.middleRows(p.torque_row(), 12) = p.torque;
    p.lower.segment(p.torque_row(), 12) = -VectorXd::Constant(12, o.torque_limit) - c_q + sent;
    p.upper.segment(p.torque_row(), 12) = VectorXd::Constant(12, o.torque_limit) - c_q + sent;
  }
  if (o.joint_acceleration_limits) {
    Vec12 rest = Vec12::Zero();
    for (int i = 0; i < p.n_stance; ++i) {
      const int l = stance[i];
      rest.segment<3>(3 * l) = m.contact[l].J_q.fullPivLu().solve(Vec3(-bias_st.segment(3 * i, 3)));
    }
    for (int j = 0; j < kJoints; ++j) {
      const int row = p.acceleration_row() + j;
      p.D(row, 6 + j) = 1.0;
      p.lower[row] = acceleration_bound(m, o, j, rest[j], -1.0);
      p.upper[row] = acceleration_bound(m, o, j, rest[j], 1.0);
    }
  }
  VectorXd command(ns);
  for (int i = 0; i < p.n_swing; ++i) {
    const Motion<Vec3>& ref = in.reference.foot[swing[i]];
    const LegPoint& foot = m.foot[swing[i]];
    command.segment(3 * i, 3) = ref.a + o.swing_kd * (ref.v - foot.v) + o.swing_kp * (ref.p - foot.p);
  }
  if (routing.swing_31 == Routing::Swing::kProjected && ns > 0) {
    command -= printed_swing_term(M, J_st, J_sw, f_hat_sw);
  }
  const int s = p.swing_row();
  for (int sign = 0; sign < 2; ++sign) {
    const double q = sign == 0 ? 1.0 : -1.0;
    p.D.block(s + sign * ns, 0, ns, 18) = q * J_sw;
    p.D.block(s + sign * ns, p.gamma(), ns, ns) = -MatrixXd::Identity(ns, ns);
    p.upper.segment(s + sign * ns, ns) = q * (command - bias_sw);
  }
  return p;
}

DenseQp FullProblem::as_dense() const {
  DenseQp qp{H, g, MatrixXd(E.rows() + D.rows(), H.cols()), VectorXd(E.rows() + D.rows()),
             VectorXd(E.rows() + D.rows())};
  qp.C << E, D;
  qp.lower << e, lower;
  qp.upper << e, upper;
  const int ns = 3 * n_swing;
  qp.H.bottomRightCorner(ns, ns) *= kSlackUnit * kSlackUnit;
  qp.C.rightCols(ns) *= kSlackUnit;
  return qp;
}

VectorXd FullProblem::from_dense(VectorXd x) const {
  x.tail(3 * n_swing) *= kSlackUnit;
  return x;
}

VectorXd full_point(const FullProblem& p, const PerLeg<bool>& stance, const WbcSolution& s) {
  VectorXd zeta(p.H.cols());
  zeta.head(18) << s.rdd_c, s.qdd;
  int f = 18, gamma = p.gamma();
  for (int l = 0; l < kLegs; ++l) {
    if (stance[l]) {
      zeta.segment(f, 3) = s.foot_force.segment<3>(3 * l);
      f += 3;
    } else {
      zeta.segment(gamma, 3) = s.tracking_error.segment<3>(3 * l).cwiseAbs();
      gamma += 3;
    }
  }
  return zeta;
}

double full_kkt_residual(const FullProblem& p, const PerLeg<bool>& stance, const WbcSolution& s,
                         const WbcQpSolution& reduced) {
  const VectorXd zeta = full_point(p, stance, s);
  const int ns = 3 * p.n_swing;
  VectorXd y = VectorXd::Zero(p.D.rows());  // signed: > 0 at an upper bound
  y.head(p.swing_row()) = reduced.multipliers.head(p.swing_row());
  int i = 0;
  for (int l = 0; l < kLegs; ++l) {
    if (stance[l]) continue;
    for (int k = 0; k < 3; ++k, ++i) {
      const double delta = s.tracking_error[3 * l + k];
      const double force = p.H(p.gamma() + i, p.gamma() + i) * std::abs(delta);
      y[p.swing_row() + (delta > 0.0 ? i : ns + i)] = force;
    }
  }
  const VectorXd Hz = p.H * zeta;
  const VectorXd Dy = p.D.transpose() * y;
  const VectorXd gradient = Hz + p.g + Dy;
  const VectorXd nu = p.E.transpose().colPivHouseholderQr().solve(-gradient);
  const VectorXd Enu = p.E.transpose() * nu;
  const auto scale = [](std::initializer_list<double> terms) {
    return std::max(1.0, *std::max_element(terms.begin(), terms.end()));
  };
  const auto largest = [](const VectorXd& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); };
  const double stationarity = largest(gradient + Enu) / scale({largest(Hz), largest(p.g), largest(Dy), largest(Enu)});
  const double equality = largest(p.E * zeta - p.e) / scale({largest(p.E * zeta), largest(p.e)});
  const VectorXd value = p.D * zeta;
  const VectorXd violation = (p.lower - value).cwiseMax(value - p.upper).cwiseMax(0.0);
  double complementarity = 0.0, complementarity_scale = 1.0;
  for (int r = 0; r < y.size(); ++r) {
    if (y[r] == 0.0) continue;
    const double bound = y[r] > 0.0 ? p.upper[r] : p.lower[r];
    complementarity = std::max(complementarity, std::abs(y[r] * (value[r] - bound)));
    complementarity_scale = std::max(complementarity_scale, std::abs(y[r] * value[r]));
  }
  return std::max(
      {stationarity, equality, largest(violation) / scale({largest(value)}), complementarity / complementarity_scale});
}

}  // namespace dob::test
