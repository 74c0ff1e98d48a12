// Figures of the paper that do not say what they seem to: what follows from them, by closed forms.
#include <cmath>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "controller/compensation.h"
#include "test/support/standing_dogbot.h"

namespace dob::printed_figures_test {
namespace {

// Section 5.1: K_d,sw = 100, K_p,sw = 25. An error obeys s^2 + K_d s + K_p = 0 when (30) is met exactly.
TEST(PrintedSwingGains, LeaveAnErrorOfTheFootAsItIsForAWholeSwing) {
  const WbcOptions printed;
  const double root = std::sqrt(printed.swing_kd * printed.swing_kd / 4.0 - printed.swing_kp);
  const double slow = -printed.swing_kd / 2.0 + root, fast = -printed.swing_kd / 2.0 - root;
  EXPECT_NEAR(slow, -0.25, 1e-3);  // [rad/s]
  // From rest: (slow e^(fast t) - fast e^(slow t)) / (slow - fast) is left after t.
  const double t = 0.115;  // [s] a swing
  EXPECT_GT((slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast), 0.97);
}

// Moments about the line between two feet cannot come from them: only the cost of the forces (R of (17)) makes these
// unique.
TEST(TwoStandingFeet, GiveNoMomentAboutTheLineBetweenThem) {
  const ModelTerms m = test::standing_dogbot(test::dogbot_model());
  const PerLeg<bool> trot{true, false, false, true};
  const PerLeg<LegPoint> points = task_points(m, trot);
  const auto wrenches = [&](const PerLeg<bool>& stance) {
    Eigen::MatrixXd W(6, 0);
    for (int l = 0; l < kLegs; ++l) {
      if (!stance[l]) continue;
      W.conservativeResize(6, W.cols() + 3);
      W.rightCols<3>() = point_jacobian_com(m, points[l].p).transpose();
    }
    return W;
  };
  const auto rank = [](const Eigen::MatrixXd& W) {
    const Eigen::VectorXd s = W.jacobiSvd().singularValues();
    return (s.array() > 1e-9 * s[0]).count();
  };
  EXPECT_EQ(rank(wrenches(trot)), 5);
  EXPECT_EQ(rank(wrenches({true, true, true, false})), 6);
  Vec6 about_the_line;
  const Vec3 line = (points[3].p - points[0].p).normalized();
  about_the_line << Vec3::Zero(), line;
  about_the_line.head<3>() = (points[0].p - m.p_com).cross(line);  // orthogonal to every force at either foot
  EXPECT_LT((wrenches(trot).transpose() * about_the_line).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace dob::printed_figures_test
