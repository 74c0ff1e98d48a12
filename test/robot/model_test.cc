#include "robot/model.h"

#include <array>
#include <random>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/oracles/mujoco_robot.h"
#include "test/robot/urdf_text.h"
#include "test/support/random_state.h"
#include "test/support/shipped_robots.h"

namespace dob::model_test {
namespace {

constexpr int kStates = 1000;

class ModelTest : public ::testing::TestWithParam<test::ShippedRobot> {
 protected:
  RobotDescription robot = GetParam().load();
  Model model{robot};
  std::mt19937_64 random{20260101};
  ModelTerms t;

  RobotState sample() { return test::random_state(random); }

  ModelTerms at(const RobotState& state) const {
    ModelTerms terms;
    model.compute(state, terms);
    return terms;
  }

  static double relative(const auto& a, const auto& b) {
    return (a - b).cwiseAbs().maxCoeff() / std::max(1.0, b.cwiseAbs().maxCoeff());
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, ModelTest, ::testing::ValuesIn(test::kShippedRobots),
                         [](const auto& param) { return param.param.name; });

// State after moving along v for a time s (exact on SO(3), so that central differences are second order).
RobotState moved(const RobotState& x, double s) {
  RobotState y = x;
  y.p_WB += s * x.v_WB;
  const double angle = s * x.omega_WB.norm();
  if (angle != 0.0) y.R_WB = Eigen::AngleAxisd(angle, x.omega_WB.normalized()).toRotationMatrix() * x.R_WB;
  y.q += s * x.qd;
  return y;
}

Mat3x18 full_jacobian(const ModelTerms& t, const LegPoint& point, int leg) {
  Mat3x18 J = Mat3x18::Zero();
  J.leftCols<3>().setIdentity();
  J.middleCols<3>(3) = -skew(point.p - t.state.p_WB);
  J.middleCols<3>(6 + 3 * leg) = point.J_q;
  return J;
}

TEST_P(ModelTest, AgreesWithMujocoAtRandomStates) {
  oracle::MujocoRobot mujoco(GetParam().file(), robot);
  oracle::MujocoTerms o;
  for (int i = 0; i < kStates; ++i) {
    const RobotState state = sample();
    model.compute(state, t);
    mujoco.set_state(state);
    mujoco.compute(o);
    ASSERT_LT(relative(t.mass_matrix(), o.M), 1e-10);
    Vec18 h;
    h << t.h_b, t.h_q;
    ASSERT_LT(relative(h, o.h), 1e-10);
    ASSERT_LT((t.p_com - o.p_com).norm(), 1e-10);
    for (int l = 0; l < kLegs; ++l) {
      ASSERT_LT((t.foot[l].p - o.p_foot[l]).norm(), 1e-10);
      ASSERT_LT(relative(full_jacobian(t, t.foot[l], l), o.J_foot[l]), 1e-10);
      ASSERT_LT(relative(t.foot[l].Jdot_v, o.Jdot_v_foot[l]), 1e-10);
      const Mat3x18 J_contact = o.J_foot[l] - skew(Vec3(0, 0, -robot.legs[l].foot_radius)) * o.J_lower_angular[l];
      ASSERT_LT(relative(full_jacobian(t, t.contact[l], l), J_contact), 1e-10);
    }
  }
}

// The shipped robots turn about x and y alone, and a term of z would not be missed.
TEST(ModelOfARobotWithSkewJoints, AgreesWithMujoco) {
  const std::array axes{"0.48 0.6 0.64", "-0.6 0.64 0.48", "0.64 -0.48 0.6", "-0.8 0 -0.6", "0 0.6 -0.8"};
  std::string text = test::dogbot_text();
  std::size_t at = 0, joint = 0;
  while ((at = text.find("<axis xyz=\"", at)) != std::string::npos) {
    at += 11;
    text.replace(at, text.find('"', at) - at, axes.at(joint++ % axes.size()));
  }
  ASSERT_EQ(joint, 12U);
  const test::TemporaryUrdf file(text);
  const RobotDescription robot = load_robot(file.path(), Forward::kMinusY);
  const Model model{robot};
  oracle::MujocoRobot mujoco(file.path(), robot);
  std::mt19937_64 random{7};
  ModelTerms t;
  oracle::MujocoTerms o;
  for (int i = 0; i < 100; ++i) {
    const RobotState state = test::random_state(random);
    model.compute(state, t);
    mujoco.set_state(state);
    mujoco.compute(o);
    const Vec18 h = (Vec18() << t.h_b, t.h_q).finished();
    ASSERT_LT((t.mass_matrix() - o.M).cwiseAbs().maxCoeff(), 1e-10);
    ASSERT_LT((h - o.h).cwiseAbs().maxCoeff(), 1e-10 * o.h.cwiseAbs().maxCoeff());
    ASSERT_LT((t.p_com - o.p_com).norm(), 1e-10);
    for (int l = 0; l < kLegs; ++l) {
      ASSERT_LT((t.foot[l].p - o.p_foot[l]).norm(), 1e-10);
      ASSERT_LT((full_jacobian(t, t.foot[l], l) - o.J_foot[l]).cwiseAbs().maxCoeff(), 1e-10);
    }
  }
}

TEST_P(ModelTest, JacobianRatesAgreeWithFiniteDifferences) {
  const double s = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const RobotState state = sample();
    model.compute(state, t);
    const ModelTerms plus = at(moved(state, s)), minus = at(moved(state, -s));
    for (int l = 0; l < kLegs; ++l) {
      for (const auto points : {&ModelTerms::foot, &ModelTerms::contact}) {
        const Vec3 rate = (full_jacobian(plus, (plus.*points)[l], l) - full_jacobian(minus, (minus.*points)[l], l)) *
                          t.velocity() / (2.0 * s);
        ASSERT_LT(relative((t.*points)[l].Jdot_v, rate), 1e-6);
      }
      const LegPoint knee = leg_point(t, Leg{l}, LegLink::kLower, Vec3(0.01, -0.02, 0.03));
      const Vec3 rate = (full_jacobian(plus, leg_point(plus, Leg{l}, LegLink::kLower, Vec3(0.01, -0.02, 0.03)), l) -
                         full_jacobian(minus, leg_point(minus, Leg{l}, LegLink::kLower, Vec3(0.01, -0.02, 0.03)), l)) *
                        t.velocity() / (2.0 * s);
      ASSERT_LT(relative(knee.Jdot_v, rate), 1e-6);
    }
  }
}

// C^T v = Mdot v - C v with C v = h - g: holds for any Coriolis matrix with Mdot = C + C^T.
TEST_P(ModelTest, TransposedCoriolisTermAgreesWithTheRateOfTheMassMatrix) {
  const double s = 1e-6;
  for (int i = 0; i < 200; ++i) {
    RobotState state = sample();
    model.compute(state, t);
    const Mat18 M_dot = (at(moved(state, s)).mass_matrix() - at(moved(state, -s)).mass_matrix()) / (2.0 * s);
    const Vec18 v = t.velocity();
    RobotState rest = state;
    rest.v_WB.setZero();
    rest.omega_WB.setZero();
    rest.qd.setZero();
    const ModelTerms gravity = at(rest);
    Vec18 expected = M_dot * v, actual;
    expected -= (Vec18() << t.h_b - gravity.h_b, t.h_q - gravity.h_q).finished();
    actual << t.CTv_b, t.CTv_q;
    ASSERT_LT(relative(actual, expected), 1e-6);
  }
}

TEST_P(ModelTest, MomentumIsMassMatrixTimesVelocity) {
  for (int i = 0; i < 200; ++i) {
    model.compute(sample(), t);
    const Vec18 p = t.mass_matrix() * t.velocity();
    ASSERT_LT(relative(t.p_b, p.head<6>()), 1e-12);
    ASSERT_LT(relative(t.p_q, p.tail<12>()), 1e-12);
    ASSERT_LT(relative(t.rho, t.M_q * t.state.qd), 1e-12);
  }
}

// The CoM-coordinate form must be the full-space dynamics, whatever forces act (no approximation of the paper).
TEST_P(ModelTest, CentroidalFormReproducesFullSpaceAccelerations) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    model.compute(sample(), t);
    Vec12 tau, f;
    for (int k = 0; k < 12; ++k) {
      tau[k] = 30.0 * uniform(random);
      f[k] = 100.0 * uniform(random);
    }
    Vec18 force = Vec18::Zero();
    force.tail<12>() = tau;
    for (int l = 0; l < kLegs; ++l) {
      force += full_jacobian(t, t.contact[l], l).transpose() * f.segment<3>(3 * l);
    }
    const Vec18 h = (Vec18() << t.h_b, t.h_q).finished();
    const Vec18 v_dot = t.mass_matrix().ldlt().solve(force - h);
    const Vec12 qdd = v_dot.tail<12>();

    EXPECT_LT(relative(Vec12(t.M_q * qdd + t.c_q), Vec12(tau + joint_torques(t, t.contact, f))), 1e-9);
    EXPECT_LT(relative(joint_torques(t, t.contact, f), Vec12(jacobian_joints(t, t.contact).transpose() * f)), 1e-12);
    Mat6 M_com = Mat6::Zero();
    M_com.topLeftCorner<3, 3>() = t.mass * Mat3::Identity();
    M_com.bottomRightCorner<3, 3>() = t.I_c;
    Vec6 wrench = com_wrench(t, t.contact, f);
    wrench[2] -= t.mass * kGravity;
    const Vec6 rdd_c = M_com.ldlt().solve(wrench);
    const Vec12 expected =
        jacobian_com(t, t.contact) * rdd_c + jacobian_joints(t, t.contact) * qdd + acceleration_bias(t, t.contact);
    for (int l = 0; l < kLegs; ++l) {
      const Vec3 a = full_jacobian(t, t.contact[l], l) * v_dot + t.contact[l].Jdot_v;
      ASSERT_LT(relative(Vec3(expected.segment<3>(3 * l)), a), 1e-9);
    }
  }
}

TEST_P(ModelTest, CentroidalVelocityAndPointVelocitiesAreConsistent) {
  for (int i = 0; i < 200; ++i) {
    model.compute(sample(), t);
    const Vec12 feet = jacobian_com(t, t.foot) * t.v_c + jacobian_joints(t, t.foot) * t.state.qd;
    for (int l = 0; l < kLegs; ++l) ASSERT_LT((feet.segment<3>(3 * l) - t.foot[l].v).norm(), 1e-11);
    ASSERT_LT((t.I_c * t.v_c.tail<3>() - t.L).norm(), 1e-11);
  }
}

TEST_P(ModelTest, CompositeInertiaRateAgreesWithFiniteDifferences) {
  const double s = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const RobotState state = sample();
    model.compute(state, t);
    const Mat3 I_dot = (at(moved(state, s)).I_c - at(moved(state, -s)).I_c) / (2.0 * s);
    ASSERT_LT(relative(t.Idot_omega, Vec3(I_dot * t.v_c.tail<3>())), 1e-6);
  }
}

// (3) along motions with random joint torques and contact forces: d/dt(M_q qd) by a central difference of rho
// along the accelerated motion equals CqT_qd + tau + J_j^T f.
TEST_P(ModelTest, LegMomentumRateObeysEquation3) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double s = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const RobotState state = sample();
    model.compute(state, t);
    Vec12 tau, f;
    for (int k = 0; k < 12; ++k) {
      tau[k] = 30.0 * uniform(random);
      f[k] = 100.0 * uniform(random);
    }
    Vec18 force = Vec18::Zero();
    force.tail<12>() = tau;
    for (int l = 0; l < kLegs; ++l) {
      force += full_jacobian(t, t.contact[l], l).transpose() * f.segment<3>(3 * l);
    }
    const Vec18 v_dot = t.mass_matrix().ldlt().solve(force - (Vec18() << t.h_b, t.h_q).finished());
    const auto after = [&](double h) {
      RobotState y = moved(state, h);
      y.v_WB += h * v_dot.head<3>();
      y.omega_WB += h * v_dot.segment<3>(3);
      y.qd += h * v_dot.tail<12>();
      return at(y).rho;
    };
    const Vec12 rate = (after(s) - after(-s)) / (2.0 * s);
    ASSERT_LT(relative(Vec12(t.CqT_qd + tau + joint_torques(t, t.contact, f)), rate), 1e-6);
  }
}

}  // namespace
}  // namespace dob::model_test
