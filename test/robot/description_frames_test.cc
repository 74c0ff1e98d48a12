// A robot written twice: once with all link frames parallel, once with every frame turned and parts behind
// fixed joints. The loader must not see a difference.
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "robot/description.h"
#include "robot/inverse_kinematics.h"
#include "test/robot/urdf_text.h"

namespace dob::description_frames_test {
namespace {

// Random values of one robot, and the two ways to write it.
class TwinWriter {
 public:
  TwinWriter(std::mt19937& random, bool turned) : random_(random), turned_(turned) {}

  std::string robot() {
    std::string text = "<robot name=\"twin\"><link name=\"trunk\">" + inertial(8.0, Mat3::Identity()) + "</link>";
    for (const double x : {1.0, -1.0}) {
      for (const double y : {1.0, -1.0}) {
        text += leg(fmt::format("leg_{}_{}", x > 0 ? "a" : "b", y > 0 ? "a" : "b"), Vec3(0.4 * x, 0.2 * y, 0.03));
      }
    }
    return text + "</robot>";
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  Mat3 rotation() {  // drawn in both ways of writing, so that both see the same random numbers
    const Eigen::Quaterniond q(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return turned_ ? q.normalized().toRotationMatrix() : Mat3(Mat3::Identity());
  }
  static std::string origin(const Vec3& p, const Mat3& R) {
    const Vec3 ypr = R.eulerAngles(2, 1, 0);
    return fmt::format("<origin xyz=\"{:.17g} {:.17g} {:.17g}\" rpy=\"{:.17g} {:.17g} {:.17g}\"/>", p.x(), p.y(), p.z(),
                       ypr[2], ypr[1], ypr[0]);
  }
  static std::string inertial(double mass, const Vec3& com, const Mat3& R, const Mat3& I) {
    return fmt::format(
        "<inertial>{}<mass value=\"{:.17g}\"/><inertia ixx=\"{:.17g}\" ixy=\"{:.17g}\" ixz=\"{:.17g}\" "
        "iyy=\"{:.17g}\" iyz=\"{:.17g}\" izz=\"{:.17g}\"/></inertial>",
        origin(com, R), mass, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2));
  }
  // Of a link whose frame is turned by R from the base axes.
  std::string inertial(double mass, const Mat3& R) {
    const Vec3 com = vector(0.05);
    const Vec3 half_diagonal = vector(0.1);  // of a set of masses: any such inertia is possible
    const Mat3 I = mass * (0.01 * Mat3::Identity() - skew(half_diagonal) * skew(half_diagonal));
    const Mat3 axes = rotation();  // of the inertial frame, from the base axes
    return inertial(mass, R.transpose() * com, R.transpose() * axes, axes.transpose() * I * axes);
  }

  std::string leg(const std::string& name, const Vec3& hip) {
    const std::array<Vec3, 3> origins{hip, vector(0.2), vector(0.4)};
    std::string text;
    std::string parent = "trunk";
    Mat3 R_parent = Mat3::Identity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Mat3 R = rotation();
      const Vec3 axis = vector(1.0);
      const std::string link = fmt::format("{}_{}", name, i);
      text += joint(link, parent, R_parent.transpose() * origins.at(i), R_parent.transpose() * R, "revolute",
                    R.transpose() * axis);
      text += "<link name=\"" + link + "\">" + inertial(1.0 + static_cast<double>(i), R) + "</link>";
      parent = link;
      R_parent = R;
    }
    return text + foot(name, parent, R_parent);
  }

  static std::string joint(const std::string& child, const std::string& parent, const Vec3& p, const Mat3& R,
                           const std::string& type, const Vec3& axis) {
    return fmt::format(
        "<joint name=\"to_{0}\" type=\"{2}\"><parent link=\"{1}\"/><child link=\"{0}\"/>{3}"
        "<axis xyz=\"{4:.17g} {5:.17g} {6:.17g}\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" "
        "velocity=\"1\"/></joint>",
        child, parent, type, origin(p, R), axis.x(), axis.y(), axis.z());
  }

  // Two links behind fixed joints: a mass, and the sphere on a massless one.
  std::string foot(const std::string& name, const std::string& lower, const Mat3& R_lower) {
    const Mat3 R_mass = rotation();
    const Mat3 R_foot = rotation();
    const Vec3 p_mass = vector(0.1);
    const Vec3 p_foot = vector(0.3);
    const Vec3 p_sphere = vector(0.02);
    return joint(name + "_mass", lower, R_lower.transpose() * p_mass, R_lower.transpose() * R_mass, "fixed",
                 Vec3::UnitX()) +
           "<link name=\"" + name + "_mass\">" + inertial(0.5, R_mass) + "</link>" +
           joint(name + "_foot", name + "_mass", R_mass.transpose() * p_foot, R_mass.transpose() * R_foot, "fixed",
                 Vec3::UnitX()) +
           "<link name=\"" + name + "_foot\"><collision>" + origin(R_foot.transpose() * p_sphere, Mat3::Identity()) +
           "<geometry><sphere radius=\"0.02\"/></geometry></collision></link>";
  }

  std::mt19937& random_;
  bool turned_;
};

constexpr double kRounding = 1e-14;  // a few products of rotations and numbers of order one

void expect_same(const LinkInertia& a, const LinkInertia& b) {
  EXPECT_NEAR(a.mass, b.mass, kRounding);
  EXPECT_LE((a.com - b.com).norm(), kRounding);
  EXPECT_LE((a.inertia - b.inertia).norm(), kRounding);
}

class Twins : public testing::TestWithParam<unsigned> {
 protected:
  static RobotDescription twin(bool turned) {
    std::mt19937 random(GetParam());
    return test::load_text(TwinWriter(random, turned).robot());
  }
  RobotDescription plain = twin(false);
  RobotDescription turned = twin(true);
};

INSTANTIATE_TEST_SUITE_P(Seeds, Twins, testing::Range(1U, 11U));

TEST_P(Twins, HaveTheSameCanonicalLinksAndJoints) {
  expect_same(plain.trunk.inertia, turned.trunk.inertia);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      const JointDescription& a = plain.legs.at(leg).joints.at(i);
      const JointDescription& b = turned.legs.at(leg).joints.at(i);
      EXPECT_EQ(a.name, b.name);
      EXPECT_LE((a.origin - b.origin).norm(), kRounding);
      EXPECT_LE((a.axis - b.axis).norm(), kRounding);
      expect_same(plain.legs.at(leg).links.at(i).inertia, turned.legs.at(leg).links.at(i).inertia);
    }
  }
}

TEST_P(Twins, PutTheirFeetInTheSamePlaces) {
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> angle(-1.0, 1.0);
  for (int i = 0; i < kLegs; ++i) {
    for (int sample = 0; sample < 10; ++sample) {
      const Vec3 q(angle(random), angle(random), angle(random));
      const auto leg = static_cast<Leg>(i);
      EXPECT_LE((foot_center_in_base(plain, leg, q) - foot_center_in_base(turned, leg, q)).norm(), kRounding);
    }
  }
}

// Second moments about the origin add; the loader works with the parallel axis theorem instead.
TEST(FixedJoints, MergeInertiasLikeOneBody) {
  const std::string part =
      "<joint name=\"weld\" type=\"fixed\"><parent link=\"body\"/><child link=\"box\"/>"
      "<origin xyz=\"0.1 0.2 0.3\" rpy=\"0 0 1.5707963267948966\"/></joint>"
      "<link name=\"box\"><inertial><origin xyz=\"0.05 0 0\"/><mass value=\"2\"/>"
      "<inertia ixx=\"0.03\" ixy=\"0\" ixz=\"0\" iyy=\"0.04\" iyz=\"0\" izz=\"0.05\"/></inertial>"
      "<collision><origin xyz=\"0.05 0 0\"/><geometry><box size=\"1 2 3\"/></geometry></collision></link>";
  const RobotDescription robot = test::load_text(test::replaced(test::dogbot_text(), "</robot>", part + "</robot>"));
  const auto about_origin = [](double mass, const Vec3& com, const Mat3& inertia) -> Mat3 {
    return inertia + mass * (com.squaredNorm() * Mat3::Identity() - com * com.transpose());
  };
  const Vec3 p(0.1, 0.25, 0.3);              // the box's centre: its x axis points along y
  const Vec3 box_moments(0.04, 0.03, 0.05);  // x and y exchanged
  const Vec3 body_moments(0.41, 0.091, 0.482);
  const LinkInertia& merged = robot.trunk.inertia;
  EXPECT_DOUBLE_EQ(merged.mass, 11.3);
  EXPECT_LE((merged.com - 2.0 / 11.3 * p).norm(), kRounding);
  EXPECT_LE((about_origin(merged.mass, merged.com, merged.inertia) - Mat3(body_moments.asDiagonal()) -
             about_origin(2.0, p, box_moments.asDiagonal()))
                .norm(),
            kRounding);
  ASSERT_EQ(robot.trunk.shapes.size(), 2U);
  EXPECT_LE((robot.trunk.shapes[1].position - p).norm(), kRounding);
  EXPECT_LE((robot.trunk.shapes[1].rotation * Vec3::UnitX() - Vec3::UnitY()).norm(), kRounding);
}

}  // namespace
}  // namespace dob::description_frames_test
