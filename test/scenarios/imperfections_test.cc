// [model_error], [sensing] and [[payload]]: how they are read, what is refused, and the scenarios that use them.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::imperfections_test {
namespace {

using testing::HasSubstr;

Scenario load_one(const std::string& name) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = name});
  EXPECT_EQ(scenarios.size(), 1u);
  return scenarios.at(0);
}

TEST(Imperfections, AreNoneUnlessAskedFor) {
  const Scenario s = load_one("undisturbed");
  EXPECT_TRUE(s.model_error.none());
  EXPECT_FALSE(s.sensing.of_state());
  EXPECT_EQ(s.sensing.torque_bias, 0.0);
  EXPECT_EQ(s.sensing.foot_force_bias, 0.0);
  EXPECT_TRUE(s.payloads.empty());
}

TEST(Imperfections, SayWhatIsWrongAndWhere) {
  EXPECT_EQ(error_with("[model_error]\nmass_scale = 0\n"),
            "mine.toml:6:1: model_error.mass_scale: 0; allowed: a number above 0 to 10");
  EXPECT_EQ(error_with("[model_error]\ntrunk_scale = 1.3\n"),
            "mine.toml:6:1: model_error.trunk_scale: unknown key 'trunk_scale'; allowed: mass_scale, trunk_mass_scale, "
            "rotational_inertia_scale");
  EXPECT_EQ(error_with("[sensing]\n  delay_ticks = 11\n"),
            "mine.toml:6:3: sensing.delay_ticks: 11; allowed: a whole number from 0 to 10");
  EXPECT_EQ(error_with("[sensing]\ndelay_ticks = 1.5\n"),
            "mine.toml:6:1: sensing.delay_ticks: 1.5; allowed: a whole number from 0 to 10");
  EXPECT_EQ(error_with("[sensing]\ntorque_bias_Nm = -0.5\n"),
            "mine.toml:6:1: sensing.torque_bias_Nm: -0.5; allowed: a number from 0 to 10000");
  EXPECT_EQ(error_with("[sensing]\nbase_velocity_noise_m_s = \"0.1\"\n"),
            "mine.toml:6:1: sensing.base_velocity_noise_m_s: \"0.1\"; allowed: a number from 0 to 10");
  EXPECT_EQ(error_with("[[payload]]\nat_s = 1\nmass_kg = 0\npoint_m = [0, 0, 0]\n"),
            "mine.toml:7:1: payload.0.mass_kg: 0; allowed: a number above 0 to 1000");
  EXPECT_EQ(error_with("[[payload]]\nat_s = 1\nmass_kg = 3\npoint_m = [0, 0]\n"),
            "mine.toml:8:1: payload.0.point_m: [0, 0]; allowed: three numbers, each from -10 to 10");
  EXPECT_THAT(error_with("[[payload]]\nat_s = 1\nmass_kg = 3\n"),
              HasSubstr("mine.toml:5:1: payload.0.point_m: missing"));
}

TEST(Case5, IsCase4WithAllMassesOfTheModelWrongBy30Percent) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = "case5"});
  const Scenario case4 = load_one("case4");
  ASSERT_EQ(scenarios.size(), 2u);
  EXPECT_EQ(scenarios[0].variant, "plus_30");
  EXPECT_EQ(scenarios[0].model_error.mass_scale, 1.3);
  EXPECT_EQ(scenarios[1].variant, "minus_30");
  EXPECT_EQ(scenarios[1].model_error.mass_scale, 0.7);
  for (const Scenario& s : scenarios) {
    EXPECT_EQ(s.model_error.trunk_mass_scale, 1.0);
    EXPECT_EQ(s.duration, case4.duration);
    ASSERT_EQ(s.random_pushes.size(), 1u);
    EXPECT_EQ(s.random_pushes[0].max_N, case4.random_pushes.at(0).max_N);
  }
  EXPECT_EQ(scenario_info("case5").set, ScenarioSet::kPaper);
}

TEST(MassErrorTrunk, IsWrongInTheTrunkAlone) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = "mass_error_trunk"});
  ASSERT_EQ(scenarios.size(), 2u);
  EXPECT_EQ(scenarios[0].model_error.trunk_mass_scale, 1.3);
  EXPECT_EQ(scenarios[1].model_error.trunk_mass_scale, 0.7);
  for (const Scenario& s : scenarios) EXPECT_EQ(s.model_error.mass_scale, 1.0);
  EXPECT_EQ(scenario_info("mass_error_trunk").set, ScenarioSet::kExtra);
}

TEST(ImperfectSensing, HasOneErrorAtATimeOverCase4) {
  for (const Scenario& s : load_scenarios({.name = "imperfect_sensing"})) {
    const SensingErrors& e = s.sensing;
    const int errors = static_cast<int>(e.base_velocity_noise != 0.0) + static_cast<int>(e.torque_bias != 0.0) +
                       static_cast<int>(e.foot_force_bias != 0.0) + static_cast<int>(e.delay_ticks != 0);
    EXPECT_EQ(errors, 1) << s.variant;
    EXPECT_EQ(s.random_pushes.size(), 1u);
    EXPECT_EQ(s.noise.torque_relative, 0.0);
  }
  for (int delay = 1; delay <= 3; ++delay) {
    EXPECT_EQ(load_one("imperfect_sensing/delay_" + std::to_string(delay)).sensing.delay_ticks, delay);
  }
}

TEST(PayloadScenario, Puts3KilogramsOnTheTrunkAt5Seconds) {
  const std::vector<Scenario> scenarios = load_scenarios({.name = "payload"});
  ASSERT_EQ(scenarios.size(), 2u);
  for (const Scenario& s : scenarios) {
    ASSERT_EQ(s.payloads.size(), 1u);
    EXPECT_EQ(s.payloads[0].start_s, 5.0);
    EXPECT_EQ(s.payloads[0].mass, 3.0);
    EXPECT_TRUE(s.disturbances.empty());
  }
  EXPECT_EQ(scenarios[0].payloads[0].p_B, Vec3(0.0, 0.0, 0.08));
  EXPECT_EQ(scenarios[1].payloads[0].p_B, Vec3(0.2, 0.1, 0.08));
}

}  // namespace
}  // namespace dob::imperfections_test
