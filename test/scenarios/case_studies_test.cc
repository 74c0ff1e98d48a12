// The case studies and their relatives as the shipped files have them.
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/load_one.h"

namespace dob::case_studies_test {
namespace {

using testing::ElementsAre;

TEST(Case1, WalksTheCurvedPathOf5Point5Metres) {
  for (const Scenario& s : load_scenarios({.name = "case1"})) {
    ASSERT_EQ(s.path.size(), 5u);
    const double durations[] = {10.0, 10.0, 5.8, 10.0, 10.0};
    const double yaw_rates[] = {0.0, 0.05, 0.0, -0.05, 0.0};
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(s.path[i].duration, durations[i]);
      EXPECT_EQ(s.path[i].speed, 0.12);
      EXPECT_EQ(s.path[i].yaw_rate, yaw_rates[i]);
    }
    EXPECT_NEAR(ReferencePath(s.path).length(), 5.496, 1e-12);
    EXPECT_NEAR(s.duration, 45.8, 1e-12);
    EXPECT_EQ(s.metric_leg, Leg::kLF);
  }
}

TEST(Case1, PushesKneeOrTipLaterallyOrSagittallyWithTheSameSine) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = "case1"});
  ASSERT_EQ(scenarios.size(), 4u);
  const char* variants[] = {"knee_lateral", "tip_lateral", "knee_sagittal", "tip_sagittal"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scenarios[i].name, "case1");
    EXPECT_EQ(scenarios[i].variant, variants[i]);
    ASSERT_EQ(scenarios[i].disturbances.size(), 1u);
    const Disturbance& d = scenarios[i].disturbances[0];
    EXPECT_EQ(d.profile.kind, ForceProfile::Kind::kSine);
    EXPECT_EQ(d.profile.amplitude_N, 20.0);
    EXPECT_EQ(d.profile.period_s, 2.0 * std::numbers::pi);
    EXPECT_EQ(d.profile.phase_rad, 0.0);
    EXPECT_EQ(d.profile.start_s, 0.0);
    EXPECT_EQ(d.profile.duration_s, std::numeric_limits<double>::infinity());
    EXPECT_EQ(d.leg, static_cast<int>(Leg::kLF));
    EXPECT_EQ(d.link, LegLink::kLower);
    EXPECT_EQ(d.direction, i < 2 ? Vec3::UnitY() : Vec3::UnitX());
    EXPECT_EQ(d.frame, Disturbance::Frame::kWorld);
    // The knee is the lower leg's origin; the foot's sphere is 35 mm behind and 300 mm below it (0, -0.035, -0.3
    // in the description, whose -y is forward).
    const bool tip = i % 2 == 1;
    EXPECT_LT((d.p_L - (tip ? Vec3(0.035, 0.0, -0.3) : Vec3(0.0, 0.0, 0.0))).norm(), 1e-12) << d.p_L.transpose();
  }
}

TEST(Case1, WithoutSwingCompensationPushesTheSameAndLeavesTheTermOut) {
  for (const std::string point : {"knee_lateral", "tip_lateral"}) {
    const Scenario with = load_one({.name = "case1/" + point});
    const Scenario without = load_one({.name = "case1_no_swing/" + point});
    EXPECT_TRUE(with.swing_compensation);
    EXPECT_FALSE(without.swing_compensation);
    EXPECT_EQ(without.disturbances.at(0).p_L, with.disturbances.at(0).p_L);
    EXPECT_EQ(without.disturbances[0].direction, Vec3::UnitY());
    EXPECT_EQ(without.duration, with.duration);
  }
}

TEST(Case2, IsCase1WithThePapersThreeObservers) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = "case2"});
  const std::vector<Scenario> case1 = load_scenarios({.name = "case1"});
  ASSERT_EQ(scenarios.size(), case1.size());
  for (std::size_t i = 0; i < case1.size(); ++i) {
    EXPECT_EQ(scenarios[i].name, "case1");
    EXPECT_EQ(scenarios[i].variant, case1[i].variant);
  }
  std::vector<std::string> observers;
  for (const WrittenText& observer : scenario_info("case2").observers) observers.push_back(observer.text);
  EXPECT_THAT(observers, ElementsAre("momentum", "com_wrench", "nonlinear_dob"));
}

TEST(Case3, PushesTheFrontRightKneeAtAShareOfItsSwingNotBefore2Point8Seconds) {
  struct Expected {
    const char* variant;
    Vec3 direction;
    double phase;
  };
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  const Expected all[] = {{"left_10", y, 0.1},    {"left_30", y, 0.3},     {"left_50", y, 0.5},   {"left_80", y, 0.8},
                          {"right_10", -y, 0.1},  {"right_30", -y, 0.3},   {"right_50", -y, 0.5}, {"right_80", -y, 0.8},
                          {"forward_10", x, 0.1}, {"backward_10", -x, 0.1}};
  const std::vector<Scenario> scenarios = load_scenarios({.name = "case3"});
  ASSERT_EQ(scenarios.size(), std::size(all));
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const Scenario& s = scenarios[i];
    EXPECT_EQ(s.variant, all[i].variant);
    EXPECT_EQ(s.metric_leg, Leg::kRF);
    ASSERT_EQ(s.disturbances.size(), 1u);
    const Disturbance& d = s.disturbances[0];
    EXPECT_EQ(d.profile.kind, ForceProfile::Kind::kConstant);
    EXPECT_EQ(d.profile.amplitude_N, 80.0);
    EXPECT_EQ(d.profile.duration_s, 0.2);
    EXPECT_EQ(d.profile.start_s, 2.8);
    EXPECT_EQ(d.leg, static_cast<int>(Leg::kRF));
    EXPECT_EQ(d.link, LegLink::kLower);
    EXPECT_EQ(d.p_L, Vec3(0.0, 0.0, 0.0));
    EXPECT_EQ(d.direction, all[i].direction) << s.variant;
    ASSERT_TRUE(d.trigger.has_value());
    EXPECT_EQ(d.trigger->leg, Leg::kRF);
    EXPECT_EQ(d.trigger->phase, all[i].phase) << s.variant;
    // Straight, and 10 s after the latest end of the push that any seed can have.
    ASSERT_EQ(s.path.size(), 1u);
    EXPECT_EQ(s.path[0].yaw_rate, 0.0);
    EXPECT_GE(s.duration, 2.8 + s.seed_variation.disturbance_onset + s.gait.pattern.cycle() + 0.2 + 10.0);
  }
}

TEST(Case4, DrawsTenTo35NewtonEveryTwoSecondsOnAnyLegAlongThePathOf3Point7Metres) {
  const Scenario s = load_one({.name = "case4"});
  const double durations[] = {8.0, 8.0, 6.8, 8.0};
  const double yaw_rates[] = {0.0, 0.05, 0.0, -0.05};
  ASSERT_EQ(s.path.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(s.path[i].duration, durations[i]);
    EXPECT_EQ(s.path[i].speed, 0.12);
    EXPECT_EQ(s.path[i].yaw_rate, yaw_rates[i]);
  }
  EXPECT_NEAR(ReferencePath(s.path).length(), 3.696, 1e-12);
  EXPECT_FALSE(s.metric_leg.has_value());
  EXPECT_TRUE(s.disturbances.empty());
  ASSERT_EQ(s.random_pushes.size(), 1u);
  const RandomPush& push = s.random_pushes[0];
  EXPECT_EQ(push.min_N, 10.0);
  EXPECT_EQ(push.max_N, 35.0);
  EXPECT_EQ(push.hold_s, 2.0);
  EXPECT_EQ(push.start_s, 1.0);
  EXPECT_EQ(push.duration_s, std::numeric_limits<double>::infinity());
  EXPECT_THAT(push.legs, ElementsAre(Leg::kLF, Leg::kRF, Leg::kLH, Leg::kRH));
}

TEST(Case4Noise, IsCase4With10PercentOnTorquesAndFootForces) {
  const Scenario noisy = load_one({.name = "case4_noise"});
  const Scenario s = load_one({.name = "case4"});
  EXPECT_EQ(noisy.name, "case4_noise");
  EXPECT_EQ(noisy.noise.torque_relative, 0.1);
  EXPECT_EQ(noisy.noise.foot_force_relative, 0.1);
  EXPECT_EQ(s.noise.torque_relative, 0.0);
  EXPECT_EQ(noisy.duration, s.duration);
  ASSERT_EQ(noisy.random_pushes.size(), 1u);
  EXPECT_EQ(noisy.random_pushes[0].max_N, s.random_pushes.at(0).max_N);
}

TEST(OrderStudy, BringsOrders1To5AtEqualBandwidthAndWithEqualGains) {
  const ScenarioInfo info = scenario_info("order_study");
  ASSERT_EQ(info.observers.size(), 11u);
  EXPECT_EQ(info.observers[0].text, "none");
  std::string gains = "6.28";
  for (std::size_t order = 1; order <= 5; ++order) {
    EXPECT_EQ(info.observers[order].text, fmt::format("momentum:family=bessel,order={},bandwidth_rad_s=72.26", order));
    EXPECT_EQ(info.observers[order + 5].text, fmt::format("momentum:gains={},allow_unstable=true", gains));
    gains += ";6.28";
  }
  ASSERT_EQ(info.profiles.size(), 1u);
  EXPECT_EQ(info.profiles[0].text, "paper");
}

TEST(PushTrunk, ActsOnTheTrunkAsAConstantAPulseAndARamp) {
  using Kind = ForceProfile::Kind;
  const std::vector<Scenario> scenarios = load_scenarios({.name = "push_trunk"});
  ASSERT_EQ(scenarios.size(), 6u);
  const Kind kinds[] = {Kind::kConstant, Kind::kConstant, Kind::kRamp};
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const Disturbance& d = scenarios[i].disturbances.at(0);
    EXPECT_EQ(d.leg, AppliedForce::kTrunk);
    EXPECT_EQ(d.profile.kind, kinds[i / 2]) << scenarios[i].variant;
    EXPECT_EQ(d.direction, i % 2 == 0 ? Vec3::UnitY() : Vec3(-Vec3::UnitX())) << scenarios[i].variant;
    EXPECT_EQ(d.profile.duration_s, i / 2 == 1 ? 0.1 : 6.0);
  }
  EXPECT_EQ(scenarios[4].disturbances[0].profile.ramp_s, 3.0);
}

TEST(ChirpKnee, SweepsTo10Hertz) {
  const Scenario s = load_scenarios({.name = "chirp_knee"}).at(0);
  const ForceProfile& p = s.disturbances.at(0).profile;
  EXPECT_EQ(p.kind, ForceProfile::Kind::kChirp);
  EXPECT_EQ(p.f0_Hz, 0.05);
  EXPECT_EQ(p.f1_Hz, 10.0);
  EXPECT_LE(p.start_s + p.duration_s, s.duration);
}

TEST(StartInMotion, StartsAtThePathsSpeed) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = "start_in_motion"});
  ASSERT_EQ(scenarios.size(), 2u);
  for (const Scenario& s : scenarios) {
    EXPECT_EQ(s.robot.initial_speed, s.path.at(0).speed);
    EXPECT_EQ(s.planner.footsteps.start_ramp, 0.0);
  }
  EXPECT_TRUE(scenarios[0].disturbances.empty());
  EXPECT_EQ(scenarios[1].disturbances.size(), 1u);
  EXPECT_EQ(load_one({.name = "undisturbed"}).robot.initial_speed, 0.0);
}

TEST(Case4, MayBeNarrowedToAWindowAndToSomeLegs) {
  const Scenario s = load_one(
      {.name = "case4",
       .overrides = {"disturbance.0.legs=[\"RH\", \"LF\"]", "disturbance.0.max_N=20", "disturbance.0.duration_s=7"}});
  EXPECT_THAT(s.random_pushes.at(0).legs, ElementsAre(Leg::kRH, Leg::kLF));
  EXPECT_EQ(s.random_pushes[0].max_N, 20.0);
  EXPECT_EQ(s.random_pushes[0].duration_s, 7.0);
  EXPECT_THAT(load_one({.name = "case4", .overrides = {"disturbance.0.legs=LH"}}).random_pushes.at(0).legs,
              ElementsAre(Leg::kLH));
}

}  // namespace
}  // namespace dob::case_studies_test
