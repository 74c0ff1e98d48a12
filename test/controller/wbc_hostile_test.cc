// Whole-body problems as hostile as a robot, its options and a broken sensor can make them: a status, never a hang, and
// no claim without a proof.
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "bench/trial.h"
#include "controller/goldfarb_idnani.h"
#include "controller/whole_body_controller.h"
#include "robot/standing_pose.h"
#include "scenarios/loader.h"
#include "test/support/draws.h"
#include "test/support/qp_checks.h"
#include "test/support/wbc_instances.h"

namespace dob::wbc_hostile_test {
namespace {

using test::WbcInstance;

struct Hostile {
  WbcInstance in;
  WbcOptions options;
  Routing routing;
};

class HostileInstances {
 public:
  explicit HostileInstances(std::uint64_t seed)
      : engine_(seed),
        scenario_(load_scenarios({.name = "undisturbed", .gains = "", .planner = "", .overrides = {}}).front()),
        model_(load_robot(scenario_.robot.urdf, scenario_.robot.forward)),
        standing_(standing_pose(model_, scenario_.planner.com_height, scenario_.planner.footsteps.foot_offset_x,
                                scenario_.planner.footsteps.foot_offset_y, scenario_.robot.posture)) {
    for (int l = 0; l < kLegs; ++l) stretched_knee_[static_cast<std::size_t>(l)] = find_stretched_knee(l);
  }

  Hostile draw() {
    Hostile h;
    RobotState state = standing_;
    state.R_WB = rotation(chance(0.2) ? 3.0 : 0.3);
    state.v_WB = vec3(0.5);
    state.omega_WB = vec3(1.0);
    for (double& q : state.q) q += uniform(-0.3, 0.3);
    for (double& qd : state.qd) qd = uniform(-3.0, 3.0) * (chance(0.05) ? 100.0 : 1.0);
    if (chance(0.2)) {  // a knee that is nearly stretched, or stretched
      const auto leg = static_cast<int>(uniform(0.0, 4.0));
      const double bent = chance(0.1) ? 0.0 : log_uniform(1e-9, 0.1);
      state.q[3 * leg + 2] = stretched_knee_[static_cast<std::size_t>(leg)] + (chance(0.5) ? bent : -bent);
    }
    model_.compute(state, h.in.m);
    for (bool& stands : h.in.stance) stands = chance(0.6);
    draw_reference(h.in);
    draw_estimate(h.in);
    draw_options(h);
    return h;
  }

  // A NaN or an infinity in one of the inputs.
  void poison(WbcInstance& in) {
    const double bad = chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
    const auto leg = static_cast<int>(uniform(0.0, 4.0));
    switch (static_cast<int>(uniform(0.0, 6.0))) {
      case 0:
        in.reference.com.a[2] = bad;
        break;
      case 1:
        in.reference.foot[leg].p[1] = bad;
        break;
      case 2:
        in.estimate.leg_torque[3 * leg] = bad;
        in.estimate.has_legs = true;
        break;
      case 3:
        in.m.M_q(3, 3) = bad;
        break;
      case 4:
        in.m.A_c(2, 3 * leg) = bad;
        break;
      default:
        in.m.foot[leg].J_q(1, 1) = bad;
        in.m.contact[leg].J_q(1, 1) = bad;
    }
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

 private:
  double log_uniform(double from, double to) { return std::pow(10.0, uniform(std::log10(from), std::log10(to))); }

  // Knee angle [rad] at which the leg is straight, by bisection of the determinant's sign.
  double find_stretched_knee(int leg) {
    ModelTerms m;
    RobotState state = standing_;
    const auto determinant = [&](double knee) {
      state.q[3 * leg + 2] = knee;
      model_.compute(state, m);
      return m.foot[leg].J_q.determinant();
    };
    double low = -0.5, high = 0.5;
    const bool sign = determinant(low) > 0.0;
    while (high - low > 1e-15) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      ((determinant(middle) > 0.0) == sign ? low : high) = middle;
    }
    return low;
  }

  // (Draws of one expression in braces: in their order with every compiler.)
  Vec3 vec3(double scale) {
    const std::array<double, 3> v{uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
    return scale * Vec3(v[0], v[1], v[2]);
  }
  Mat3 rotation(double largest) {
    const double angle = uniform(0.0, largest);
    return Eigen::AngleAxisd(angle, vec3(1.0).normalized()).toRotationMatrix();
  }

  void draw_reference(WbcInstance& in) {
    const double scale = chance(0.2) ? log_uniform(1.0, 1e4) : 1.0;
    in.reference.com = {in.m.p_com + scale * vec3(0.05), scale * vec3(0.5), scale * vec3(2.0)};
    in.reference.R_WB = rotation(0.2);
    if (chance(0.2)) {  // free fall: the desired wrench is zero, and with it every normal force
      in.reference.com = {in.m.p_com, in.m.v_c.head<3>(), Vec3(0.0, 0.0, -kGravity)};
      in.reference.R_WB = in.m.state.R_WB;
      in.reference.omega = in.m.state.omega_WB;
    }
    for (int l = 0; l < kLegs; ++l) {
      in.reference.foot[l] = {in.m.foot[l].p + scale * vec3(0.05), scale * vec3(0.5), scale * vec3(5.0)};
    }
  }

  void draw_estimate(WbcInstance& in) {
    const double scale = chance(0.2) ? log_uniform(1.0, 1e4) : 15.0;
    in.estimate.has_legs = chance(0.7);
    for (double& torque : in.estimate.leg_torque) torque = scale * uniform(-1.0, 1.0);
    in.estimate.has_com = chance(0.5);
    in.estimate.com_wrench.head<3>() = scale * vec3(1.0);
    in.estimate.com_wrench.tail<3>() = 0.1 * scale * vec3(1.0);
  }

  void draw_options(Hostile& h) {
    WbcOptions& o = h.options;
    o.friction = log_uniform(1e-4, 10.0);
    o.min_normal_force = chance(0.5) ? 0.0 : log_uniform(1e-3, 300.0);
    o.torque_limit = chance(0.1) ? log_uniform(0.1, 10.0) : log_uniform(10.0, 300.0);
    o.torque_rows = chance(0.8);
    o.joint_acceleration_limits = chance(0.4);
    if (o.joint_acceleration_limits) {
      o.joint_limits.lower = standing_.q.array() - log_uniform(1e-3, 1.0);
      o.joint_limits.upper = standing_.q.array() + log_uniform(1e-3, 1.0);
      o.joint_limits.velocity.setConstant(log_uniform(0.1, 10.0));
    }
    o.wrench_weight = log_uniform(1.0, 1e4);
    o.regularization = log_uniform(1e-3, 10.0);
    o.slack_weight = log_uniform(1e6, 1e9);
    using Source = Routing::WrenchSource;
    h.routing.dynamics_18 = chance(0.5);
    h.routing.wrench_source = chance(0.5) ? Source::kCom : Source::kAllLegs;
    h.routing.torque_36 = chance(0.5);
    h.routing.swing_31 = chance(0.5) ? Routing::Swing::kProjected : Routing::Swing::kDirect;
  }

  std::mt19937_64 engine_;
  Scenario scenario_;
  Model model_;
  RobotState standing_;
  PerLeg<double> stretched_knee_{};  // [rad]
};

// Largest residual of (20) and (32) in the recovered solution, over its largest term.
double foot_row_residual(const WbcInstance& in, const PerLeg<LegPoint>& points, const Compensation& c,
                         const WbcOptions& o, const WbcSolution& s) {
  const Mat12 J_j = jacobian_joints(in.m, points);
  const Vec12 from_joints = J_j * s.qdd;
  const Vec12 from_com = jacobian_com(in.m, points) * s.rdd_c;
  Vec12 wanted = -acceleration_bias(in.m, points);
  double largest = std::max({1.0, (J_j * s.qdd.asDiagonal()).cwiseAbs().maxCoeff(), from_com.cwiseAbs().maxCoeff()});
  for (int l = 0; l < kLegs; ++l) {
    if (in.stance[l]) continue;
    const Motion<Vec3>& ref = in.reference.foot[l];
    wanted.segment<3>(3 * l) += ref.a + o.swing_kd * (ref.v - points[l].v) + o.swing_kp * (ref.p - points[l].p) -
                                c.swing_acceleration.segment<3>(3 * l) + s.tracking_error.segment<3>(3 * l);
  }
  largest = std::max(largest, wanted.cwiseAbs().maxCoeff());
  return (from_joints + from_com - wanted).cwiseAbs().maxCoeff() / largest;
}

struct Tally {
  int optimal = 0, infeasible = 0, singular = 0, inaccurate = 0, other = 0;
  int force_free = 0, all_friction = 0;
};

void judge(const Hostile& h, Tally& tally) {
  const PerLeg<LegPoint> points = task_points(h.in.m, h.in.stance);
  TaskJacobian J;
  if (!J.factorize(h.in.m, points)) {
    ++tally.singular;
    return;
  }
  const Compensation c = compensate(h.in.m, points, J, h.in.stance, h.in.estimate, h.routing, true);
  WholeBodyQp qp(h.options);
  qp.assemble(h.in.m, h.in.stance, h.in.reference, c, points, J);
  GoldfarbIdnani<kWbcVariables, kWbcMaxRows> solver;
  WbcQpSolution solution;
  switch (solver.solve(qp.problem(), solution)) {
    case QpStatus::kOptimal: {
      ++tally.optimal;
      EXPECT_LE(test::checked_kkt_residual(qp.problem(), solution), 1e-8);
      const WbcSolution s = qp.recover(solution.x, J);
      EXPECT_LE(foot_row_residual(h.in, points, c, h.options, s), 1e-8);
      tally.force_free += s.foot_force.cwiseAbs().maxCoeff() < 1e-3 ? 1 : 0;
      int friction = 0;
      for (int k = 0; k < solution.active.size; ++k) friction += solution.active[k].row % 5 < 4 ? 1 : 0;
      tally.all_friction += friction >= 6 ? 1 : 0;
      break;
    }
    case QpStatus::kInfeasible:
      ++tally.infeasible;
      EXPECT_TRUE((test::is_contradiction<kWbcVariables, kWbcMaxRows>(qp.problem(), solution.farkas)));
      break;
    case QpStatus::kInaccurate:
      ++tally.inaccurate;
      break;
    default:
      ++tally.other;
  }
}

TEST(HostileWholeBodyQp, NeverClaimsMoreThanItCanProve) {
  constexpr int kDraws = test::draws(100000);
  HostileInstances instances(1);
  Tally tally;
  for (int draw = 0; draw < kDraws && !HasFailure(); ++draw) {
    SCOPED_TRACE(draw);
    judge(instances.draw(), tally);
  }
  RecordProperty("optimal", tally.optimal);
  RecordProperty("infeasible", tally.infeasible);
  RecordProperty("singular", tally.singular);
  RecordProperty("inaccurate", tally.inaccurate);
  EXPECT_EQ(tally.other, 0);
  EXPECT_GE(tally.optimal, 0.4 * kDraws);
  EXPECT_GE(tally.infeasible, 0.2 * kDraws);
  EXPECT_GT(tally.singular, 0.01 * kDraws);
  EXPECT_LE(tally.inaccurate, 0.01 * kDraws);  // nearly opposite friction facets, mostly
  EXPECT_GT(tally.force_free, 0.01 * kDraws);
  EXPECT_GT(tally.all_friction, 0.01 * kDraws);
}

TEST(HostileWholeBodyQp, WhatIsNotFiniteIsRefusedAndNeverSent) {
  HostileInstances instances(2);
  for (int draw = 0; draw < test::draws(10000); ++draw) {
    SCOPED_TRACE(draw);
    Hostile h = instances.draw();
    WholeBodyController controller(h.options, h.routing);
    instances.poison(h.in);
    const WbcTick tick = controller.update(0, 1e-3, h.in.m, h.in.stance, h.in.reference, h.in.estimate);
    ASSERT_TRUE(tick.torque.allFinite());
    ASSERT_LE(tick.torque.cwiseAbs().maxCoeff(), h.options.torque_limit);
    if (tick.event == QpEvent::kSolved) {  // the poisoned input does not enter this problem
      ASSERT_TRUE(controller.solution().qdd.allFinite());
      ASSERT_TRUE(controller.solution().foot_force.allFinite());
    } else {
      ASSERT_NE(tick.qp_status, QpStatus::kOptimal);
    }
  }
}

}  // namespace
}  // namespace dob::wbc_hostile_test
