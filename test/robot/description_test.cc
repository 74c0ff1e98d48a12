// The loader against the published figures of DogBot and against a second way of writing the same robot.
#include "robot/description.h"

#include <locale>
#include <string>

#include <gtest/gtest.h>

#include "test/robot/urdf_text.h"

namespace dob::description_test {
namespace {

using test::dogbot_text;
using test::dogbot_urdf;
using test::load_text;
using test::replaced;

constexpr double kExact = 1e-15;  // sums and signed permutations of numbers below 1

// One leg of the published description: s = +1 right, -1 left; f = +1 front, -1 back.
struct PublishedLeg {
  Leg leg;
  std::string name;
  double s;
  double f;
};

// The robot walks to -y: what the description calls back right is its left fore leg.
std::array<PublishedLeg, kLegs> published_legs() {
  return {PublishedLeg{Leg::kLF, "back_right", 1.0, -1.0}, PublishedLeg{Leg::kRF, "back_left", -1.0, -1.0},
          PublishedLeg{Leg::kLH, "front_right", 1.0, 1.0}, PublishedLeg{Leg::kRH, "front_left", -1.0, 1.0}};
}

class DogBot : public testing::TestWithParam<PublishedLeg> {
 protected:
  const LegDescription& leg() const { return robot.legs.at(static_cast<std::size_t>(GetParam().leg)); }
  Vec3 published(const Vec3& in_base_axes) const { return robot.R_description_B * in_base_axes; }
  void expect_inertia(const LinkInertia& inertia, double mass, const Vec3& com, const Vec3& moments) const {
    EXPECT_DOUBLE_EQ(inertia.mass, mass);
    EXPECT_LE((published(inertia.com) - com).norm(), kExact);
    const Mat3 I = robot.R_description_B * inertia.inertia * robot.R_description_B.transpose();
    EXPECT_LE((I - Mat3(moments.asDiagonal())).norm(), kExact);
  }
  void expect_joint(std::size_t i, const std::string& name, const Vec3& origin, const Vec3& axis) const {
    EXPECT_EQ(leg().joints.at(i).name, GetParam().name + name);
    EXPECT_LE((published(leg().joints.at(i).origin) - origin).norm(), kExact);
    EXPECT_LE((published(leg().joints.at(i).axis) - axis).norm(), kExact);
    EXPECT_EQ(leg().joints.at(i).effort_limit, 60.0);
    EXPECT_EQ(leg().joints.at(i).velocity_limit, 6.0);
  }
  void expect_limits(std::size_t i, double lower, double upper) const {
    EXPECT_EQ(leg().joints.at(i).lower, lower);
    EXPECT_EQ(leg().joints.at(i).upper, upper);
  }
  RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
};

INSTANTIATE_TEST_SUITE_P(Legs, DogBot, testing::ValuesIn(published_legs()),
                         [](const auto& param) { return param.param.name; });

TEST_P(DogBot, HasThePublishedLinks) {
  const double s = GetParam().s;
  expect_inertia(leg().links[0].inertia, 0.836, {s * 0.0074, 0, 0}, {0.00213, 0.00147, 0.00172});
  expect_inertia(leg().links[1].inertia, 1.851, {s * 0.0418, 0, -0.0517}, {0.0238, 0.0252, 0.0044});
  expect_inertia(leg().links[2].inertia, 0.302, {0, -0.029, -0.1439}, {0.00527, 0.00509, 0.0008});
  EXPECT_EQ(leg().links[0].name, GetParam().name + "_hip");
  EXPECT_EQ(leg().links[1].name, GetParam().name + "_upper_leg");
  EXPECT_EQ(leg().links[2].name, GetParam().name + "_lower_leg");
}

TEST_P(DogBot, HasThePublishedJoints) {
  const double s = GetParam().s;
  const double f = GetParam().f;
  expect_joint(0, "_roll", {s * 0.088, f * 0.2875, 0}, {0, f, 0});
  expect_joint(1, "_pitch", {s * 0.09875, 0, 0}, {s, 0, 0});
  expect_joint(2, "_knee", {0, 0, -0.315}, {-s, 0, 0});
  expect_limits(0, -1.7453, 1.7453);
  expect_limits(1, s > 0 ? -3.1416 : -1.5708, s > 0 ? 1.5708 : 3.1416);
  expect_limits(2, s > 0 ? -0.02 : -2.618, s > 0 ? 2.618 : 0.02);
}

TEST_P(DogBot, HasThePublishedFoot) {
  EXPECT_EQ(leg().foot_radius, 0.028);
  EXPECT_LE((published(leg().foot_center) - Vec3(0, -0.035, -0.3)).norm(), kExact);
  // The published foot frame has six decimals and lies on the sphere.
  const Vec3 foot_frame(-0.0000206, -0.016585, -0.3211);
  EXPECT_NEAR((published(leg().foot_center) - foot_frame).norm(), leg().foot_radius, 1e-5);
}

TEST_P(DogBot, ShankTouchesFlatGroundOnlyWithItsFoot) {
  // Shank cylinder and foot sphere turned about the knee: the sphere reaches lower while the knee is above
  // the foot.
  ASSERT_EQ(leg().links[2].shapes.size(), 1U);
  const CollisionShape& shank = leg().links[2].shapes.front();
  ASSERT_EQ(shank.kind, CollisionShape::Kind::kCylinder);
  const Vec3 along = shank.rotation.col(2);
  for (int step = -150; step <= 150; ++step) {
    const double angle = 0.01 * step;
    const Mat3 R = Eigen::AngleAxisd(angle, leg().joints[2].axis).toRotationMatrix();
    const double foot = (R * leg().foot_center).z();
    if (foot >= 0.0) {
      continue;
    }
    const double axis_z = (R * along).z();
    const double lowest = (R * shank.position).z() - 0.5 * shank.size[1] * std::abs(axis_z) -
                          shank.size[0] * std::sqrt(1.0 - axis_z * axis_z);
    EXPECT_GT(lowest, foot - leg().foot_radius) << "at " << angle << " rad";
  }
}

TEST(DogBotTrunk, HasThePublishedInertiaAndABoxOfTheSameInertia) {
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kPlusX);
  EXPECT_EQ(robot.name, "dogbot");
  EXPECT_EQ(robot.trunk.name, "body");
  EXPECT_EQ(robot.trunk.inertia.mass, 9.3);
  EXPECT_EQ(robot.trunk.inertia.com, Vec3::Zero());
  const Vec3 moments(0.41, 0.091, 0.482);
  EXPECT_EQ(robot.trunk.inertia.inertia, Mat3(moments.asDiagonal()));
  ASSERT_EQ(robot.trunk.shapes.size(), 1U);
  const Vec3 square = robot.trunk.shapes.front().size.cwiseAbs2();
  const Vec3 of_box = 9.3 / 12.0 * (Vec3::Constant(square.sum()) - square);
  // The edges are rounded to 1 cm, so up to 5 mm off: m/12 d(a^2 + b^2) <= m/6 (a + b) 5 mm.
  EXPECT_LE((of_box - moments).cwiseAbs().maxCoeff(), 9.3 / 6.0 * (0.32 + 0.72) * 0.005);
}

TEST(DogBotTrunk, TotalMassIsTheSumOfItsLinks) {
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
  EXPECT_NEAR(robot.total_mass(), 9.3 + 4 * (0.836 + 1.851 + 0.302), 1e-14);
  EXPECT_NEAR(robot.total_mass(), 21.26, 0.005);
}

struct Direction {
  Forward forward;
  Vec3 x_in_description;
  std::array<std::string, kLegs> legs;
};

TEST(ForwardDirection, TurnsTheBaseAxesAndNamesTheLegsByIt) {
  const std::array<Direction, 4> directions{
      Direction{Forward::kPlusY, Vec3::UnitY(), {"front_left", "front_right", "back_left", "back_right"}},
      Direction{Forward::kMinusY, -Vec3::UnitY(), {"back_right", "back_left", "front_right", "front_left"}},
      Direction{Forward::kPlusX, Vec3::UnitX(), {"front_right", "back_right", "front_left", "back_left"}},
      Direction{Forward::kMinusX, -Vec3::UnitX(), {"back_left", "front_left", "back_right", "front_right"}}};
  for (const Direction& direction : directions) {
    const RobotDescription robot = load_robot(dogbot_urdf(), direction.forward);
    EXPECT_EQ(robot.R_description_B.col(0), direction.x_in_description);
    EXPECT_EQ(robot.R_description_B.col(2), Vec3::UnitZ());
    EXPECT_EQ(robot.R_description_B.determinant(), 1.0);
    for (std::size_t i = 0; i < kLegs; ++i) {
      const JointDescription& hip = robot.legs.at(i).joints[0];
      EXPECT_EQ(hip.name, direction.legs.at(i) + "_roll");
      EXPECT_EQ(hip.origin.x() > 0.0, i < 2) << kLegNames.at(i);
      EXPECT_EQ(hip.origin.y() > 0.0, i % 2 == 0) << kLegNames.at(i);
    }
  }
}

TEST(ForwardDirection, LeavesLegsUnchangedWhenTheTrunkFrameIsNotInTheMiddleOfTheHips) {
  const RobotDescription centred = load_robot(dogbot_urdf(), Forward::kMinusY);
  std::string text = dogbot_text();
  for (int side = 0; side < 2; ++side) {
    text = replaced(text, "0.088 0.2875 0", "0.088 1.2875 0");
    text = replaced(text, "0.088 -0.2875 0", "0.088 0.7125 0");
  }
  const RobotDescription shifted = load_text(text, Forward::kMinusY);
  for (std::size_t i = 0; i < kLegs; ++i) {
    EXPECT_EQ(shifted.legs.at(i).links[0].name, centred.legs.at(i).links[0].name);
  }
}

TEST(Loader, NormalisesJointAxes) {
  const RobotDescription robot = load_text(replaced(dogbot_text(), "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 30 40\"/>"));
  EXPECT_LE((robot.legs[0].joints[0].axis - Vec3(0, 0.6, 0.8)).norm(), kExact);
}

TEST(Loader, TakesTheLinkBelowAFloatingJointForTheTrunk) {
  const std::string world =
      "<link name=\"world\"/><joint name=\"float\" type=\"floating\"><parent link=\"world\"/><child "
      "link=\"body\"/>"
      "<origin xyz=\"1 2 3\" rpy=\"0.1 0.2 0.3\"/></joint>";
  const RobotDescription robot = load_text(replaced(dogbot_text(), "</robot>", world + "</robot>"));
  const RobotDescription plain = load_text(dogbot_text());
  EXPECT_EQ(robot.trunk.name, "body");
  EXPECT_EQ(robot.legs[0].joints[0].origin, plain.legs[0].joints[0].origin);
  EXPECT_EQ(robot.trunk.inertia.inertia, plain.trunk.inertia.inertia);
}

TEST(Loader, TakesAFixedFrameAboveTheTrunkForTheBaseFrame) {
  const std::string base =
      "<link name=\"base\"/><joint name=\"base_to_body\" type=\"fixed\"><parent link=\"base\"/><child "
      "link=\"body\"/>"
      "<origin xyz=\"0 0 0.1\"/></joint>";
  const RobotDescription robot = load_text(replaced(dogbot_text(), "</robot>", base + "</robot>"));
  EXPECT_EQ(robot.trunk.name, "base");
  EXPECT_LE((robot.trunk.inertia.com - Vec3(0, 0, 0.1)).norm(), kExact);
  EXPECT_LE((robot.trunk.shapes[0].position - Vec3(0, 0, 0.1)).norm(), kExact);
  EXPECT_NEAR(robot.legs[0].joints[0].origin.z(), 0.1, kExact);
}

TEST(Loader, IgnoresMeshesVisualsAndExtensions) {
  std::string text = replaced(dogbot_text(), "<box size=\"0.32 0.72 0.11\"/>", "<mesh filename=\"body.stl\"/>");
  text = replaced(text, "</robot>", "<gazebo reference=\"body\"><mu1>0.6</mu1></gazebo></robot>");
  text = replaced(text, "<link name=\"body\">",
                  "<link name=\"body\"><visual><geometry><box/></geometry><material name=\"missing\"/></visual>");
  EXPECT_TRUE(load_text(text).trunk.shapes.empty());
  EXPECT_EQ(load_text(text).total_mass(), load_text(dogbot_text()).total_mass());
}

struct CommaDecimal : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Loader, ReadsNumbersIndependentlyOfTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaDecimal));
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
  std::locale::global(before);
  EXPECT_EQ(robot.trunk.inertia.mass, 9.3);
}

TEST(ScaleInertia, MultipliesMassesAndInertiasAndNothingElse) {
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
  const RobotDescription heavy = scale_inertia(robot, 1.3);
  EXPECT_NEAR(heavy.total_mass(), 1.3 * robot.total_mass(), 1e-13);
  EXPECT_EQ(heavy.trunk.inertia.inertia, Mat3(1.3 * robot.trunk.inertia.inertia));
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      const LinkInertia& before = robot.legs.at(leg).links.at(i).inertia;
      const LinkInertia& after = heavy.legs.at(leg).links.at(i).inertia;
      EXPECT_EQ(after.mass, 1.3 * before.mass);
      EXPECT_EQ(after.com, before.com);
      EXPECT_EQ(after.inertia, Mat3(1.3 * before.inertia));
    }
  }
}

TEST(ScaleTrunkInertia, MultipliesTheTrunkAlone) {
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
  const RobotDescription heavy = scale_trunk_inertia(robot, 1.3);
  EXPECT_NEAR(heavy.total_mass(), robot.total_mass() + 0.3 * 9.3, 1e-13);
  EXPECT_EQ(heavy.trunk.inertia.inertia, Mat3(1.3 * robot.trunk.inertia.inertia));
  EXPECT_EQ(heavy.trunk.inertia.com, robot.trunk.inertia.com);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      EXPECT_EQ(heavy.legs.at(leg).links.at(i).inertia.mass, robot.legs.at(leg).links.at(i).inertia.mass);
      EXPECT_EQ(heavy.legs.at(leg).links.at(i).inertia.inertia, robot.legs.at(leg).links.at(i).inertia.inertia);
    }
  }
  EXPECT_THROW(scale_trunk_inertia(robot, 0.0), std::invalid_argument);
}

TEST(ScaleRotationalInertia, LeavesMassesAndCentresOfMass) {
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
  const RobotDescription slow = scale_rotational_inertia(robot, 2.5);
  const auto expect_scaled = [](const LinkInertia& after, const LinkInertia& before) {
    EXPECT_EQ(after.mass, before.mass);
    EXPECT_EQ(after.com, before.com);
    EXPECT_EQ(after.inertia, Mat3(2.5 * before.inertia));
  };
  expect_scaled(slow.trunk.inertia, robot.trunk.inertia);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      expect_scaled(slow.legs.at(leg).links.at(i).inertia, robot.legs.at(leg).links.at(i).inertia);
    }
  }
  EXPECT_THROW(scale_rotational_inertia(robot, 0.0), std::invalid_argument);
}

TEST(ScaleInertia, RefusesAFactorThatIsNotPositive) {
  const RobotDescription robot = load_robot(dogbot_urdf(), Forward::kMinusY);
  EXPECT_THROW(scale_inertia(robot, 0.0), std::invalid_argument);
  EXPECT_THROW(scale_inertia(robot, -1.0), std::invalid_argument);
  EXPECT_THROW(scale_inertia(robot, std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(scale_inertia(robot, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace dob::description_test
