// The second shipped robot: the published figures, mirrored as its description says, and knees that lead.
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "robot/inverse_kinematics.h"
#include "test/support/shipped_robots.h"

namespace dob::quad12_test {
namespace {

constexpr double kExact = 1e-15;  // sums of numbers below 1

class Quad12 : public testing::TestWithParam<Leg> {
 protected:
  RobotDescription robot = test::kShippedRobots[1].load();
  const LegDescription& leg() const { return robot.legs.at(static_cast<std::size_t>(GetParam())); }
  double left() const { return GetParam() == Leg::kLF || GetParam() == Leg::kLH ? 1.0 : -1.0; }
  double front() const { return GetParam() == Leg::kLF || GetParam() == Leg::kRF ? 1.0 : -1.0; }
  static void expect_body(const LinkDescription& link, double mass, const Vec3& com, const Mat3& inertia) {
    EXPECT_NEAR(link.inertia.mass, mass, kExact) << link.name;
    EXPECT_LE((link.inertia.com - com).norm(), kExact) << link.name;
    EXPECT_LE((link.inertia.inertia - inertia).norm(), kExact) << link.name;
  }
};

Mat3 inertia_of(double xx, double xy, double xz, double yy, double yz, double zz) {
  Mat3 I;
  I << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return I;
}

INSTANTIATE_TEST_SUITE_P(Legs, Quad12, testing::Values(Leg::kLF, Leg::kRF, Leg::kLH, Leg::kRH), [](const auto& param) {
  return std::string(kLegNames.at(static_cast<std::size_t>(param.param)));
});

TEST_P(Quad12, HipAndUpperLegHaveThePublishedInertiaMirrored) {
  const double s = left();
  const double f = front();
  expect_body(
      leg().links[0], 0.595, {f * -0.003875, s * 0.001622, 0.000042},
      inertia_of(0.000402747, f * s * -0.000008709, f * -0.000000297, 0.000691123, s * -0.000000545, 0.000487919));
  // The published one bends to the rear: x is turned round.
  expect_body(leg().links[1], 0.888, {0.003574, s * -0.019529, -0.030323},
              inertia_of(0.005251806, s * 0.000002168, -0.000346889, 0.005000475, s * -0.000028174, 0.0011102));
}

TEST_P(Quad12, LowerLegIsThePublishedCalfWithItsFoot) {
  const Vec3 calf(-0.007105, left() * -0.000239, -0.096933);
  const Vec3 foot(0.0, 0.0, -0.2);
  const Vec3 com = (0.151 * calf + 0.06 * foot) / 0.211;
  const auto about = [&](double mass, const Vec3& p) -> Mat3 { return -mass * skew(p - com) * skew(p - com); };
  const Mat3 inertia = inertia_of(0.002344758, 0.0, 0.000141275, 0.002360755, 0.0, 0.000031158) + about(0.151, calf) +
                       9.6e-6 * Mat3::Identity() + about(0.06, foot);
  expect_body(leg().links[2], 0.211, com, inertia);
  EXPECT_EQ(leg().foot_radius, 0.02);
  EXPECT_LE((leg().foot_center - foot).norm(), kExact);
}

TEST_P(Quad12, JointsHaveThePublishedLengthsAndLimitsMirrored) {
  EXPECT_LE((leg().joints[0].origin - Vec3(front() * 0.1805, left() * 0.047, 0.0)).norm(), kExact);
  EXPECT_LE((leg().joints[1].origin - Vec3(0.0, left() * 0.0838, 0.0)).norm(), kExact);
  EXPECT_LE((leg().joints[2].origin - Vec3(0.0, 0.0, -0.2)).norm(), kExact);
  constexpr double kDegree = 0.017453292519943295;  // [rad]
  constexpr std::array<std::pair<double, double>, 3> kLimits{{{-46, 46}, {-240, 60}, {52.5, 154.5}}};
  for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
    const JointDescription& joint = leg().joints.at(i);
    EXPECT_NEAR(joint.lower, kLimits.at(i).first * kDegree, 5e-5) << joint.name;
    EXPECT_NEAR(joint.upper, kLimits.at(i).second * kDegree, 5e-5) << joint.name;
    EXPECT_EQ(joint.effort_limit, 33.5);
    EXPECT_EQ(joint.velocity_limit, 21.0);
    EXPECT_EQ(joint.axis, i == 0 ? Vec3::UnitX() : Vec3::UnitY());
  }
}

TEST_P(Quad12, StandsWithItsFootBelowTheHipAndItsKneeBeforeIt) {
  const Vec3 q(0.0, -0.8, 1.6);
  const Vec3 foot = foot_center_in_base(robot, GetParam(), q);
  const Vec3 expected(front() * 0.1805, left() * (0.047 + 0.0838), -0.4 * std::cos(0.8));
  EXPECT_LE((foot - expected).norm(), kExact);
  const Mat3 R = Eigen::AngleAxisd(q[1], leg().joints[1].axis).toRotationMatrix();
  EXPECT_NEAR((R * leg().joints[2].origin).x(), 0.2 * std::sin(0.8), kExact);
}

// At any angle of the knee and of the leg at which the knee is above the foot.
TEST_P(Quad12, ShankTouchesFlatGroundOnlyWithItsFoot) {
  ASSERT_EQ(leg().links[2].shapes.size(), 1U);
  const CollisionShape& shank = leg().links[2].shapes.front();
  ASSERT_EQ(shank.kind, CollisionShape::Kind::kCylinder);
  for (int step = -150; step <= 150; ++step) {
    const Mat3 R = Eigen::AngleAxisd(0.01 * step, leg().joints[2].axis).toRotationMatrix();
    const double foot = (R * leg().foot_center).z();
    ASSERT_LT(foot, 0.0);
    const double axis_z = (R * shank.rotation.col(2)).z();
    const double lowest = (R * shank.position).z() - 0.5 * shank.size[1] * std::abs(axis_z) -
                          shank.size[0] * std::sqrt(1.0 - axis_z * axis_z);
    EXPECT_GT(lowest, foot - leg().foot_radius) << "at " << 0.01 * step << " rad";
  }
}

TEST(Quad12Whole, WeighsWhatTheLinksDo) {
  const RobotDescription robot = test::kShippedRobots[1].load();
  EXPECT_EQ(robot.name, "quad12");
  EXPECT_NEAR(robot.total_mass(), 6.0 + 4 * (0.595 + 0.888 + 0.151 + 0.06), 1e-14);
  EXPECT_EQ(robot.trunk.inertia.mass, 6.0);
  EXPECT_EQ(robot.trunk.inertia.com, Vec3(0.0, 0.0041, -0.0005));
  EXPECT_EQ(robot.trunk.inertia.inertia, inertia_of(0.0158533, 0.0000366, 0.0000611, 0.0377999, -0.0000275, 0.0456542));
}

}  // namespace
}  // namespace dob::quad12_test
