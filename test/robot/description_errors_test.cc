// Descriptions that cannot be used: one message each, with the file, the place, the value and what is
// allowed.
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/description.h"
#include "test/robot/urdf_text.h"

namespace dob::description_errors_test {
namespace {

using test::dogbot_text;
using test::load_error;
using test::replaced;
using test::TemporaryUrdf;

struct Damage {
  std::string name;
  std::string from;
  std::string to;
  std::vector<std::string> message;  // parts that must occur
  std::string after;                 // where to look for `from`
};

const std::string kHipJoint = "<joint name=\"back_left_roll\"";
const std::string kHip = "<link name=\"back_left_hip\"";
const std::string kKnee = "<joint name=\"back_left_knee\"";
const std::string kLower = "<link name=\"back_left_lower_leg\"";
const std::string kFoot = "<link name=\"back_left_foot\"";
const std::string kLimit = "<limit lower=\"-1.7453\" upper=\"1.7453\" effort=\"60\" velocity=\"6\"/>";
const std::string kExtraJoint =
    "<joint name=\"extra\" type=\"revolute\"><parent link=\"PARENT\"/><child link=\"tool\"/><axis xyz=\"1 0 "
    "0\"/>"
    "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint><link "
    "name=\"tool\"><inertial><mass "
    "value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
    "izz=\"1\"/></inertial></link></robot>";

std::vector<Damage> damaged_xml() {
  return {
      {"UnclosedTag", "</link>", "</lnk>", {"line 25", "column 3", "not valid XML"}, ""},
      {"UnclosedQuote", "value=\"9.3\"", "value=\"9.3", {"line 20", "not valid XML"}, ""},
      {"NoRobot", "<robot name=\"dogbot\">", "<robots></robots><robot name=\"dogbot\">", {"'robots'", "<robot>"}, ""},
      {"TwoRoots", "</robot>", "</robot><robot/>", {"second root", "'robot'"}, ""},
      {"NoName", " name=\"dogbot\"", "", {"No name given for the robot"}, ""},
      {"ZeroByte", "dogbot", std::string(1, '\0'), {"zero byte"}, ""},
      {"MassNotANumber", "9.3", "heavy", {"line 19", "link 'body'", "mass value is heavy; allowed"}, "<robot"},
      {"MassWithUnit", "9.3", "9.3kg", {"mass value is 9.3kg; allowed"}, "<robot"},
      {"MassWithComma", "9.3", "9,3", {"mass value is 9,3; allowed"}, "<robot"},
      {"MassNaN", "9.3", "nan", {"mass value is nan; allowed"}, "<robot"},
      {"MassInfinite", "9.3", "inf", {"mass value is inf; allowed"}, "<robot"},
      {"MassOverflow", "9.3", "1e999", {"mass value is 1e999; allowed"}, "<robot"},
      {"MissingMass", "<mass value=\"9.3\"/>", "", {"must have a mass", "Link [body]"}, ""},
      {"MissingMoment", "ixx=\"0.41\"", "", {"missing ixx", "Link [body]"}, ""},
      {"TwoNumbersForThree", "-0.2875 0\"", "-0.2875\"", {"2 elements but 3", "joint [back_left_roll]"}, kHipJoint},
      {"NanOrigin", "-0.088", "nan", {"joint 'back_left_roll'", "origin xyz is nan; allowed"}, kHipJoint},
      {"BadRotation",
       "<origin",
       "<origin rpy=\"0 0 up\"",
       {"joint 'back_left_roll'", "origin rpy is up; allowed"},
       kHipJoint},
      {"UnknownJointType", "revolute", "rotary", {"[rotary]", "Joint [back_left_roll]"}, kHipJoint},
      {"UnknownParent", "\"body\"", "\"bode\"", {"[bode]", "joint [back_left_roll]"}, kHipJoint},
      {"SameLinkNameTwice", "back_left_hip", "back_right_hip", {"'back_right_hip'", "not unique"}, kHip},
      {"SameJointNameTwice", "back_left_roll", "back_right_roll", {"'back_right_roll'", "not unique"}, kHipJoint},
      {"ChildOfTwoJoints",
       "child link=\"back_left_hip\"",
       "child link=\"back_right_hip\"",
       {"link 'back_right_hip'", "'back_left_roll'", "'back_right_roll'", "only one"},
       kHipJoint},
      {"Loop", "\"body\"", "\"back_left_foot\"", {"joint 'back_left_", "loop", "tree"}, kHipJoint},
      {"OwnParent", "\"body\"", "\"back_left_hip\"", {"joint 'back_left_roll'", "loop"}, kHipJoint},
      {"MissingLimit", kLimit, "", {"[back_left_roll]", "REVOLUTE", "limits"}, kHipJoint},
      {"MissingEffort", " effort=\"60\"", "", {"no effort", "joint [back_left_roll]"}, kHipJoint},
      {"MissingVelocity", " velocity=\"6\"", "", {"no velocity", "joint [back_left_roll]"}, kHipJoint},
      {"UnknownShape", "<sphere", "<capsule", {"'capsule'", "Link [back_left_foot]"}, kFoot},
  };
}

std::vector<Damage> damaged_values() {
  return {
      {"NegativeMass",
       "9.3",
       "-9.3",
       {"line 19, column ", "link 'body'", "mass value is -9.3", "from 0 to 1000 kg"},
       "<robot"},
      {"ZeroMassWithInertia", "9.3", "0", {"link 'body'", "mass is 0", "positive"}, "<robot"},
      {"AbsurdMass",
       "9.3",
       "1e300",
       {"line 19, column ", "link 'body'", "mass value is 1e300", "from 0 to 1000 kg"},
       "<robot"},
      {"NegativeMoment", "0.41", "-0.41", {"link 'body'", "ixx is -0.41", "from 0 to 1000 kg m^2"}, "<robot"},
      {"IndefiniteInertia", "ixy=\"0\"", "ixy=\"0.3\"", {"link 'body'", "must be positive"}, "<robot"},
      {"TriangleInequality", "0.482", "0.502", {"link 'body'", "0.502", "triangle inequality"}, "<robot"},
      {"AbsurdInertia", "0.41", "1e300", {"link 'body'", "ixx is 1e300", "from 0 to 1000 kg m^2"}, "<robot"},
      {"AbsurdOrigin",
       "-0.088",
       "-1e9",
       {"joint 'back_left_roll'", "origin xyz is -1e9", "from -10 to 10 m"},
       kHipJoint},
      {"ZeroAxis", "0 -1 0", "0 0 0", {"joint 'back_left_roll'", "axis is (0, 0, 0)", "direction"}, kHipJoint},
      {"LowerAboveUpper",
       "lower=\"-1.7453\"",
       "lower=\"2\"",
       {"joint 'back_left_roll'", "lower limit is 2 rad", "1.7453"},
       kHipJoint},
      {"NoRange", "upper=\"1.7453\"", "upper=\"-1.7453\"", {"joint 'back_left_roll'", "less than"}, kHipJoint},
      {"ZeroEffort",
       "effort=\"60\"",
       "effort=\"0\"",
       {"joint 'back_left_roll'", "limit effort is 0", "above 0 to 10000 N m"},
       kHipJoint},
      {"NegativeVelocity",
       "velocity=\"6\"",
       "velocity=\"-6\"",
       {"joint 'back_left_roll'", "limit velocity is -6", "above 0 to 1000 rad/s"},
       kHipJoint},
      {"Mimic",
       "<limit",
       "<mimic joint=\"back_right_roll\"/><limit",
       {"joint 'back_left_roll'", "mimics joint 'back_right_roll'", "motor of its own"},
       kHipJoint},
      {"ZeroFootRadius", "0.028", "0", {"link 'back_left_foot'", "sphere radius is 0", "above 0 to 10 m"}, kFoot},
      {"NegativeBox", "0.32 0.72", "-0.32 0.72", {"link 'body'", "box size is -0.32", "above 0 to 10 m"}, ""},
      {"ZeroCylinder",
       "length=\"0.24\"",
       "length=\"0\"",
       {"link 'back_left_lower_leg'", "cylinder length is 0", "above 0 to 10 m"},
       kLower},
  };
}

std::vector<Damage> damaged_topology() {
  const auto extra_on = [](const std::string& link) { return replaced(kExtraJoint, "PARENT", link); };
  return {
      {"ContinuousJoint",
       "revolute",
       "continuous",
       {"joint 'back_left_roll'", "continuous", "revolute", "<limit>"},
       kHipJoint},
      {"PrismaticJoint", "revolute", "prismatic", {"joint 'back_left_knee'", "prismatic", "revolute"}, kKnee},
      {"FloatingHip", "revolute", "floating", {"joint 'back_left_roll'", "floating", "revolute"}, kHipJoint},
      {"FixedHip",
       "revolute",
       "fixed",
       {"link 'back_left_lower_leg'", "0 moving joints (none)", "three revolute joints"},
       kHipJoint},
      {"FifthJointOnTheTrunk", "</robot>", extra_on("body"), {"link 'body'", "5 moving joints", "'extra'", "four"}, ""},
      {"LegOfTwoJoints",
       "revolute",
       "fixed",
       {"link 'back_left_upper_leg'", "0 moving joints (none)", "three revolute joints"},
       kKnee},
      {"LegOfFourJoints",
       "</robot>",
       extra_on("back_left_foot"),
       {"link 'back_left_lower_leg'", "1 moving joints ('extra')", "must be fixed"},
       ""},
      {"BranchingLeg",
       "</robot>",
       extra_on("back_left_hip"),
       {"link 'back_left_hip'", "2 moving joints ('back_left_pitch', 'extra')", "exactly one"},
       ""},
      {"FootWithoutSphere",
       "<sphere radius=\"0.028\"/>",
       "<mesh filename=\"foot.stl\"/>",
       {"link 'back_left_lower_leg'", "0 collision spheres", "exactly one"},
       kFoot},
      {"FootWithTwoSpheres",
       "</collision>",
       "</collision><collision><geometry><sphere radius=\"1\"/></geometry></collision>",
       {"link 'back_left_lower_leg'", "2 collision spheres", "exactly one"},
       kFoot},
      {"TwoHipsInOneQuadrant",
       "-0.088 -0.2875 0",
       "-0.088 0.2875 0",
       {"joint 'back_left_roll'", "same quadrant", "'front_left_roll'", "one hip per quadrant"},
       kHipJoint},
      {"WorldWithMass",
       "</robot>",
       "<link name=\"w\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" "
       "iyz=\"0\" "
       "izz=\"1\"/></inertial></link><joint name=\"float\" type=\"floating\"><parent link=\"w\"/><child "
       "link=\"body\"/></joint></robot>",
       {"link 'w'", "has mass", "'float'", "none is allowed"},
       ""},
  };
}

// For GoogleTest's messages.
void PrintTo(const Damage& damage, std::ostream* out) {
  *out << damage.name;
}

class DamagedUrdf : public testing::TestWithParam<Damage> {};

TEST_P(DamagedUrdf, IsRefusedWithOneMessageThatNamesFileAndPlace) {
  const Damage& damage = GetParam();
  const TemporaryUrdf file(replaced(dogbot_text(), damage.from, damage.to, damage.after));
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const std::string message = load_error(file.path());
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(message, testing::StartsWith(file.path().string() + ": "));
  for (const std::string& part : damage.message) {
    EXPECT_THAT(message, testing::HasSubstr(part));
  }
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

std::string damage_name(const testing::TestParamInfo<Damage>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Xml, DamagedUrdf, testing::ValuesIn(damaged_xml()), damage_name);
INSTANTIATE_TEST_SUITE_P(Values, DamagedUrdf, testing::ValuesIn(damaged_values()), damage_name);
INSTANTIATE_TEST_SUITE_P(Topology, DamagedUrdf, testing::ValuesIn(damaged_topology()), damage_name);

// Cuts out [from, to); `to` is looked for after `from`.
std::string without(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  const std::size_t end = text.find(to, begin);
  return text.substr(0, begin) + text.substr(end);
}

TEST(DamagedRobot, MovingLinkWithoutMassIsNamed) {
  const std::size_t hip = dogbot_text().find(kHip);
  const std::string text = dogbot_text().substr(0, hip) + without(dogbot_text().substr(hip), "<inertial>", "</link>");
  const TemporaryUrdf file(text);
  EXPECT_THAT(load_error(file.path()),
              testing::AllOf(testing::HasSubstr("link 'back_left_hip'"), testing::HasSubstr("no mass")));
}

TEST(DamagedRobot, ThreeLegsAreNotEnough) {
  const TemporaryUrdf file(without(dogbot_text(), "<!-- back left leg -->", "</robot>"));
  EXPECT_THAT(load_error(file.path()),
              testing::AllOf(testing::HasSubstr("link 'body'"), testing::HasSubstr("3 moving joints"),
                             testing::HasSubstr("'back_right_roll'"), testing::HasSubstr("exactly four")));
}

TEST(DamagedRobot, HipsInARowAreNeitherLeftNorRight) {
  std::string text = dogbot_text();
  for (int side = 0; side < 2; ++side) {  // "-0.088 ..." ends like "0.088 ..."
    text = replaced(text, "0.088 0.2875 0", "0 0.2875 0");
    text = replaced(text, "0.088 -0.2875 0", "0 -0.2875 0");
  }
  const TemporaryUrdf file(text);
  EXPECT_THAT(load_error(file.path()), testing::HasSubstr("left or right must be clear"));
}

}  // namespace
}  // namespace dob::description_errors_test
