#include "robot/inverse_kinematics.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "test/robot/urdf_text.h"
#include "test/support/shipped_robots.h"

namespace dob::inverse_kinematics_test {
namespace {

// The published standing posture, by leg (LF is the description's back right, and so on).
Vec3 standing(Leg leg) {
  const bool right = leg == Leg::kLF || leg == Leg::kLH;
  return right ? Vec3(0.0, 0.886, 1.604) : Vec3(0.0, -0.884, -1.604);
}

std::string name_of(Leg leg) {
  return std::string(kLegNames.at(static_cast<std::size_t>(leg)));
}

struct LegOf {
  test::ShippedRobot robot;
  Leg leg;

  Vec3 standing_seed() const { return robot.forward == Forward::kMinusY ? standing(leg) : Vec3(0.0, -0.8, 1.6); }
};

std::vector<LegOf> all_legs() {
  std::vector<LegOf> all;
  for (const test::ShippedRobot& robot : test::kShippedRobots) {
    for (const Leg leg : {Leg::kLF, Leg::kRF, Leg::kLH, Leg::kRH}) all.push_back({robot, leg});
  }
  return all;
}

class LegKinematics : public testing::TestWithParam<LegOf> {
 protected:
  const LegDescription& leg() const { return robot.legs.at(static_cast<std::size_t>(GetParam().leg)); }
  bool within_limits(const Vec3& q) const {
    bool within = true;
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      const double angle = q[static_cast<Eigen::Index>(i)];
      within = within && leg().joints.at(i).lower <= angle && angle <= leg().joints.at(i).upper;
    }
    return within;
  }
  Vec3 foot_at(const Vec3& q) const { return foot_center_in_base(robot, GetParam().leg, q); }
  std::optional<Vec3> solve(const Vec3& p_BF) const { return solve_leg(robot, GetParam().leg, p_BF, seed); }

  RobotDescription robot = GetParam().robot.load();
  Vec3 seed = GetParam().standing_seed();
};

std::string name_of(const LegOf& leg) {
  std::string name = leg.robot.name;
  name += '_';
  return name += name_of(leg.leg);
}

INSTANTIATE_TEST_SUITE_P(Robots, LegKinematics, testing::ValuesIn(all_legs()),
                         [](const auto& param) { return name_of(param.param); });

class DogBotsPosture : public testing::TestWithParam<Leg> {
 protected:
  RobotDescription robot = load_robot(test::dogbot_urdf(), Forward::kMinusY);
  Vec3 foot_at(const Vec3& q) const { return foot_center_in_base(robot, GetParam(), q); }
};

INSTANTIATE_TEST_SUITE_P(Legs, DogBotsPosture, testing::Values(Leg::kLF, Leg::kRF, Leg::kLH, Leg::kRH),
                         [](const auto& param) { return name_of(param.param); });

TEST_P(DogBotsPosture, FootOfTheStandingPostureIsWhereThePlanarLegPutsIt) {
  // Roll 0: a chain of two bars in the y-z plane of the description, turned about its x axis.
  const Vec3 q = standing(GetParam());
  const double side = q[1] > 0.0 ? 1.0 : -1.0;
  const double thigh = side * q[1];
  const double shank = thigh - side * q[2];
  const double y = 0.315 * std::sin(thigh) - 0.035 * std::cos(shank) + 0.3 * std::sin(shank);
  const double z = -0.315 * std::cos(thigh) - 0.035 * std::sin(shank) - 0.3 * std::cos(shank);
  const bool hind = GetParam() == Leg::kLH || GetParam() == Leg::kRH;  // the description's front
  const Vec3 expected(side * (0.088 + 0.09875), (hind ? 0.2875 : -0.2875) + y, z);
  EXPECT_LE((robot.R_description_B * foot_at(q) - expected).norm(), 1e-15);
}

TEST_P(DogBotsPosture, StandingPostureCarriesTheTrunkAtThePublishedHeightOverThePublishedFeet) {
  const Vec3 p = foot_at(standing(GetParam()));
  EXPECT_NEAR(robot.legs.front().foot_radius - p.z(), 0.43, 0.002);  // published: about 0.43
  EXPECT_NEAR(std::abs(p.y()), 0.187, 0.0005);
  EXPECT_NEAR(std::abs(p.x()), 0.287,
              0.022);  // the published posture leans: both pairs of feet 20 mm to the rear
}

TEST_P(LegKinematics, RoundTripReachesEveryFootPositionFromTheStandingPosture) {
  std::mt19937 random(7);
  for (int sample = 0; sample < 200; ++sample) {
    Vec3 q;
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      const JointDescription& joint = leg().joints.at(i);
      q[static_cast<Eigen::Index>(i)] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
    }
    const Vec3 target = foot_at(q);
    const std::optional<Vec3> solution = solve(target);
    ASSERT_TRUE(solution) << "q = " << q.transpose();
    EXPECT_TRUE(within_limits(*solution));
    EXPECT_LE((foot_at(*solution) - target).norm(), 1e-12);
  }
}

TEST_P(LegKinematics, NearbySeedGivesTheNearbySolution) {
  const Vec3 q = seed + Vec3(0.1, -0.05, 0.08);
  const std::optional<Vec3> solution = solve(foot_at(q));
  ASSERT_TRUE(solution);
  EXPECT_LE((*solution - q).norm(), 1e-11);  // 1e-12 m over the smallest singular value of J, about 0.2 m
}

TEST_P(LegKinematics, FootOutOfReachHasNoSolution) {
  const Vec3 hip = leg().joints[0].origin;
  EXPECT_FALSE(solve(hip + Vec3(0.0, 0.0, -0.7)));
  EXPECT_FALSE(solve(hip));  // the lateral offset cannot be folded away
  EXPECT_FALSE(solve(Vec3::Constant(std::nan(""))));
}

TEST_P(LegKinematics, FootReachedOnlyBeyondTheJointLimitsHasNoSolution) {
  const Vec3 target = foot_at(seed);
  JointDescription& knee = robot.legs.at(static_cast<std::size_t>(GetParam().leg)).joints[2];
  const double side = knee.upper > 1.0 ? 1.0 : -1.0;
  knee.lower = side > 0.0 ? 0.5 : -0.6;  // the distance of the foot from the hip needs 1.6 rad
  knee.upper = side > 0.0 ? 0.6 : -0.5;
  EXPECT_FALSE(solve(target));
}

}  // namespace
}  // namespace dob::inverse_kinematics_test
