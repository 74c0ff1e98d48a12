// The shipped data files, and what the layers make of them.
#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/gains_name.h"
#include "scenarios/loader.h"
#include "test/scenarios/load_one.h"
#include "test/scenarios/scratch_files.h"

namespace dob::scenario_files_test {
namespace {

using testing::ElementsAre;

Scenario load_text(const ScratchFiles& files, const std::string& text) {
  return load_one({.name = files.write("mine.toml", kSmallest + text)});
}

TEST(ShippedScenarios, AreListedWithTheirVariants) {
  const std::vector<ScenarioInfo> list = list_scenarios();
  const auto undisturbed =
      std::find_if(list.begin(), list.end(), [](const ScenarioInfo& i) { return i.name == "undisturbed"; });
  ASSERT_NE(undisturbed, list.end());
  EXPECT_THAT(undisturbed->variants, ElementsAre());
  EXPECT_EQ(undisturbed->summary, "120 s straight trot, no disturbance");
  EXPECT_TRUE(std::filesystem::is_regular_file(undisturbed->path));
  EXPECT_TRUE(std::is_sorted(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
  EXPECT_THAT(scenario_info("case1").variants,
              ElementsAre("knee_lateral", "tip_lateral", "knee_sagittal", "tip_sagittal"));
  EXPECT_THAT(scenario_info("crawl").variants,
              ElementsAre("undisturbed", "knee_lateral", "tip_lateral", "random_push"));
  EXPECT_THAT(scenario_info("order_study").variants, ElementsAre("standing", "trotting"));
}

TEST(ShippedScenarios, OfTheCaseStudiesAreThePapersSetAndOthersAreNot) {
  for (const char* name : {"order_study", "case1", "case1_no_swing", "case2", "case3", "case4", "case4_noise", "case6"})
    EXPECT_EQ(scenario_info(name).set, ScenarioSet::kPaper) << name;
  for (const char* name :
       {"undisturbed", "crawl", "push_trunk", "chirp_knee", "start_in_motion", "friction_sweep", "block_height_sweep"})
    EXPECT_EQ(scenario_info(name).set, ScenarioSet::kExtra) << name;
}

TEST(ShippedScenarios, AllLoadWithEveryGainSet) {
  for (const ScenarioInfo& info : list_scenarios()) {
    for (const std::string& gains : list_gain_sets()) {
      const std::vector<Scenario> scenarios = load_scenarios({.name = info.name, .gains = gains});
      EXPECT_EQ(scenarios.size(), std::max<std::size_t>(1, info.variants.size()));
    }
  }
}

TEST(Undisturbed, Is120SecondsStraightWithoutAForce) {
  const Scenario s = load_one({.name = "undisturbed"});
  EXPECT_EQ(s.name, "undisturbed");
  EXPECT_EQ(s.variant, "");
  EXPECT_EQ(s.duration, 120.0);
  ASSERT_EQ(s.path.size(), 1u);
  EXPECT_EQ(s.path[0].duration, 120.0);
  EXPECT_EQ(s.path[0].speed, 0.12);
  EXPECT_EQ(s.path[0].yaw_rate, 0.0);
  EXPECT_TRUE(s.disturbances.empty());
  EXPECT_FALSE(s.metric_leg.has_value());
}

TEST(Defaults, AreThoseOfTheOptionStructs) {
  const Scenario s = load_one({.name = "undisturbed"});
  const Scenario d;
  EXPECT_EQ(s.gait.pattern.stance_duration, d.gait.pattern.stance_duration);
  EXPECT_EQ(s.gait.pattern.swing_duration, d.gait.pattern.swing_duration);
  EXPECT_EQ(s.gait.early_touchdown_window, d.gait.early_touchdown_window);
  EXPECT_EQ(s.gait.touchdown_force, d.gait.touchdown_force);
  EXPECT_EQ(s.gait.late_wait, d.gait.late_wait);
  EXPECT_EQ(s.gait.pattern.gait, d.gait.pattern.gait);
  EXPECT_TRUE(s.gait.switches.empty());
  EXPECT_EQ(s.planner.kind, d.planner.kind);
  EXPECT_EQ(s.planner.horizon, d.planner.horizon);
  EXPECT_EQ(s.planner.zmp.line_half_width, d.planner.zmp.line_half_width);
  EXPECT_EQ(s.planner.zmp.margin, d.planner.zmp.margin);
  EXPECT_EQ(s.planner.zmp.sample, d.planner.zmp.sample);
  EXPECT_EQ(s.planner.zmp.sigma_position, d.planner.zmp.sigma_position);
  EXPECT_EQ(s.planner.zmp.sigma_velocity, d.planner.zmp.sigma_velocity);
  EXPECT_EQ(s.planner.zmp.sigma_jerk, d.planner.zmp.sigma_jerk);
  EXPECT_EQ(s.planner.footsteps.max_reach, d.planner.footsteps.max_reach);
  EXPECT_EQ(s.planner.com_height, d.planner.com_height);
  EXPECT_EQ(s.planner.footsteps.foot_offset_x, d.planner.footsteps.foot_offset_x);
  EXPECT_EQ(s.planner.footsteps.foot_offset_y, d.planner.footsteps.foot_offset_y);
  EXPECT_EQ(s.planner.footsteps.velocity_feedback, d.planner.footsteps.velocity_feedback);
  EXPECT_EQ(s.planner.swing.step_height, d.planner.swing.step_height);
  EXPECT_EQ(s.planner.swing.landing_offset, d.planner.swing.landing_offset);
  EXPECT_EQ(s.planner.swing.descent_speed, d.planner.swing.descent_speed);
  EXPECT_EQ(s.sim.dt, d.sim.dt);
  EXPECT_EQ(s.sim.erp, d.sim.erp);
  EXPECT_EQ(s.sim.cfm, d.sim.cfm);
  EXPECT_EQ(s.sim.contact_erp, d.sim.contact_erp);
  EXPECT_EQ(s.sim.contact_cfm, d.sim.contact_cfm);
  EXPECT_EQ(s.sim.gravity, d.sim.gravity);
  EXPECT_EQ(s.sim.robot_friction, d.sim.robot_friction);
  EXPECT_EQ(s.sim.contacts, d.sim.contacts);
  EXPECT_EQ(s.sim.joint_stops, d.sim.joint_stops);
}

TEST(Defaults, OfTheTrialAreThoseOfTheOptionStructs) {
  const Scenario s = load_one({.name = "undisturbed"});
  const Scenario d;
  EXPECT_EQ(s.controller.friction, d.controller.friction);
  EXPECT_EQ(s.controller.min_normal_force, d.controller.min_normal_force);
  EXPECT_EQ(s.controller.torque_limit, d.controller.torque_limit);
  EXPECT_EQ(s.controller.wrench_weight, d.controller.wrench_weight);
  EXPECT_EQ(s.controller.regularization, d.controller.regularization);
  EXPECT_EQ(s.controller.slack_weight, d.controller.slack_weight);
  EXPECT_EQ(s.controller.qp_rate, d.controller.qp_rate);
  EXPECT_EQ(s.controller.orientation_error, d.controller.orientation_error);
  EXPECT_EQ(s.controller.coriolis, d.controller.coriolis);
  EXPECT_EQ(s.controller.torque_rows, d.controller.torque_rows);
  EXPECT_EQ(s.controller.joint_acceleration_limits, d.controller.joint_acceleration_limits);
  EXPECT_EQ(s.controller.acceleration_horizon, d.controller.acceleration_horizon);
  EXPECT_EQ(s.controller.torque_between_solves, d.controller.torque_between_solves);
  EXPECT_EQ(s.controller.printed_sign_21, d.controller.printed_sign_21);
  EXPECT_EQ(s.terrain.ground_friction, d.terrain.ground_friction);
  EXPECT_TRUE(s.terrain.boxes.empty());
  EXPECT_EQ(s.noise.torque_relative, d.noise.torque_relative);
  EXPECT_EQ(s.noise.foot_force_relative, d.noise.foot_force_relative);
  EXPECT_EQ(s.fall.min_height_ratio, d.fall.min_height_ratio);
  EXPECT_EQ(s.fall.max_tilt, d.fall.max_tilt);
  EXPECT_EQ(s.seed_variation.gait_phase, d.seed_variation.gait_phase);
  EXPECT_EQ(s.seed_variation.position, d.seed_variation.position);
  EXPECT_EQ(s.seed_variation.velocity, d.seed_variation.velocity);
  EXPECT_EQ(s.seed_variation.disturbance_onset, d.seed_variation.disturbance_onset);
}

TEST(Controller, KnowsTheDescriptionsJointLimits) {
  const JointLimits limits = load_one({.name = "undisturbed"}).controller.joint_limits;
  EXPECT_EQ(limits.velocity, Vec12::Constant(6.0));
  EXPECT_EQ(limits.upper[0], 1.7453);  // roll of LF, the description's back_right
  EXPECT_EQ(limits.lower.segment<2>(1), Vec2(-3.1416, -0.02));
  EXPECT_EQ(limits.upper.segment<2>(1), Vec2(1.5708, 2.618));
}

TEST(Defaults, StandDogBotAsThePublishedCodeDoes) {
  const RobotConfig robot = load_one({.name = "undisturbed"}).robot;
  EXPECT_EQ(robot.urdf, std::filesystem::path(DOB_SOURCE_DIR) / "robot/dogbot/dogbot.urdf");
  EXPECT_EQ(robot.forward, Forward::kMinusY);
  ASSERT_EQ(robot.posture.size(), 12u);
  for (const std::string end : {"front", "back"}) {
    for (const auto& [side, pitch, knee] : {std::tuple("right", 0.886, 1.604), std::tuple("left", -0.884, -1.604)}) {
      const std::string leg = end + "_" + side + "_";
      EXPECT_EQ(robot.posture.at(leg + "roll"), 0.0);
      EXPECT_EQ(robot.posture.at(leg + "pitch"), pitch);
      EXPECT_EQ(robot.posture.at(leg + "knee"), knee);
    }
  }
}

TEST(Gait, SwitchesAreReadInOrderAndRefusedOutOfIt) {
  const ScratchFiles files;
  const auto text = [](double second) {
    return fmt::format(
        "[gait]\nswitch = [{{ at_s = 3.0, kind = \"crawl\", stance_s = 0.5, swing_s = 0.3 }}, "
        "{{ at_s = {}, kind = \"stand\", stance_s = 0.5, swing_s = 0.3 }}]\n",
        second);
  };
  const GaitOptions gait = load_text(files, text(8.0)).gait;
  ASSERT_EQ(gait.switches.size(), 2u);
  EXPECT_EQ(gait.switches[0].time, 3.0);
  EXPECT_EQ(gait.switches[0].pattern.gait, Gait::kCrawl);
  EXPECT_EQ(gait.switches[1].pattern.gait, Gait::kStand);
  EXPECT_THROW(load_text(files, text(2.0)), InputError);
}

TEST(Planner, HorizonIsAWholeNumberThatTheSamplingHasRoomFor) {
  const ScratchFiles files;
  EXPECT_EQ(load_text(files, "[planner]\nhorizon_footsteps = 3\n").planner.horizon, 3);
  for (const char* bad :
       {"[planner]\nhorizon_footsteps = 2.5\n", "[planner]\nhorizon_footsteps = 4\n", "[planner]\nkind = \"best\"\n"}) {
    EXPECT_THROW(load_text(files, bad), InputError) << bad;
  }
}

struct Gains {
  const char* name;
  double wrench_kp, wrench_kd, swing_kp, swing_kd;
};

TEST(GainSets, AreThePrintedThePublishedSwingAndTheStiffOnes) {
  EXPECT_THAT(list_gain_sets(), ElementsAre("paper", "swing300", "stiff"));
  const Gains sets[] = {{"paper", 250, 50, 25, 100}, {"swing300", 250, 50, 300, 20}, {"stiff", 2500, 250, 25, 100}};
  for (const Gains& set : sets) {
    const WbcOptions wbc = load_one({.name = "undisturbed", .gains = set.name}).controller;
    EXPECT_EQ(wbc.wrench_kp, Vec6::Constant(set.wrench_kp)) << set.name;
    EXPECT_EQ(wbc.wrench_kd, Vec6::Constant(set.wrench_kd)) << set.name;
    EXPECT_EQ(wbc.swing_kp, set.swing_kp) << set.name;
    EXPECT_EQ(wbc.swing_kd, set.swing_kd) << set.name;
  }
}

TEST(GainSets, OfAScenarioAreKeptUntilAnotherIsAskedFor) {
  const ScratchFiles files;
  const std::string path =
      files.write("mine.toml", kSmallest + "[gains]\nswing_kp_1_s2 = 7\nwrench_kp_linear_N_m = [1, 2, 3]\n");
  const WbcOptions own = load_one({.name = path}).controller;
  EXPECT_EQ(own.swing_kp, 7.0);
  EXPECT_EQ(own.swing_kd, 100.0);  // the rest is the paper's
  EXPECT_EQ(own.wrench_kp, (Vec6() << 1, 2, 3, 250, 250, 250).finished());
  EXPECT_EQ(load_one({.name = path, .gains = "own"}).controller.swing_kp, 7.0);
  EXPECT_EQ(load_one({.name = path, .gains = "paper"}).controller.swing_kp, 25.0);
}

TEST(GainSets, AreCalledByWhatTheScenarioHas) {
  const ScratchFiles files;
  const auto name = [&files](const std::string& text, const ScenarioRequest& request) {
    files.write("mine.toml", kSmallest + text);
    return gains_name({(files.directory() / "mine.toml").string(), request.gains, {}, request.overrides}, "");
  };
  EXPECT_EQ(name("", {}), "paper");
  EXPECT_EQ(name("", {.gains = "own"}), "paper");
  EXPECT_EQ(name("[gains]\nswing_kp_1_s2 = 300\nswing_kd_1_s = 20\n", {}), "swing300");
  EXPECT_EQ(name("[gains]\nswing_kp_1_s2 = 301\nswing_kd_1_s = 20\n", {}), "own");
  EXPECT_EQ(name("[gains]\nswing_kp_1_s2 = 301\n", {.gains = "stiff"}), "stiff");
  EXPECT_EQ(name("", {.overrides = {"gains.swing_kp_1_s2=7"}}), "paper");  // says so in a column of its own
}

TEST(GainSets, OfAVariantAreItsOwn) {
  const ScratchFiles files;
  const std::string path =
      files.write("mine.toml", kSmallest + "[variant.as_printed]\n[variant.slow.gains]\nswing_kd_1_s = 50\n");
  EXPECT_EQ(gains_name({.name = path}, "as_printed"), "paper");
  EXPECT_EQ(gains_name({.name = path}, "slow"), "own");
}

TEST(GainSets, OfAResolvedFileKeepTheirNameAndTheirValues) {
  const ScratchFiles files;
  const std::string stiff = files.write("stiff.toml", resolved_toml({.name = "undisturbed", .gains = "stiff"}, ""));
  EXPECT_EQ(gains_name({.name = stiff}, ""), "stiff");
  EXPECT_EQ(load_one({.name = stiff}).controller.wrench_kp[0], 2500.0);
}

TEST(Layers, OneVariantCanBeAskedForByNameAndByPath) {
  EXPECT_EQ(load_one({.name = "case1/tip_sagittal"}).variant, "tip_sagittal");
  const std::string path = std::string(DOB_SOURCE_DIR) + "/scenarios/case1.toml";
  EXPECT_EQ(load_one({.name = path + "/tip_sagittal"}).variant, "tip_sagittal");
  EXPECT_EQ(load_scenarios({.name = path}).size(), 4u);
}

TEST(Layers, AVariantIsLaidOverItsFileAndOverridesOverBoth) {
  const ScratchFiles files;
  const std::string path = files.write(
      "mine.toml", kSmallest + "[gait]\nstance_s = 0.2\nswing_s = 0.3\n[variant.slow.gait]\nswing_s = 0.4\n");
  const GaitOptions variant = load_one({.name = path}).gait;
  EXPECT_EQ(variant.pattern.stance_duration, 0.2);
  EXPECT_EQ(variant.pattern.swing_duration, 0.4);
  EXPECT_EQ(variant.late_wait, 0.1);
  const Scenario s = load_one({.name = path, .overrides = {"gait.swing_s=0.5", "gait.swing_s=0.6", "metric_leg=RH"}});
  EXPECT_EQ(s.gait.pattern.swing_duration, 0.6);
  EXPECT_EQ(s.metric_leg, Leg::kRH);
}

TEST(Layers, OverridesReachIntoListsOfTables) {
  const Scenario s =
      load_one({.name = "case1/knee_lateral", .overrides = {"disturbance.0.amplitude_N=30", "path.4.duration_s=11.5"}});
  EXPECT_EQ(s.disturbances[0].profile.amplitude_N, 30.0);
  EXPECT_EQ(s.disturbances[0].profile.period_s, 2.0 * std::numbers::pi);
  EXPECT_NEAR(s.duration, 47.3, 1e-12);
}

TEST(Layers, APostureGoesWithItsRobot) {
  const ScratchFiles files;
  std::string urdf = read_text(std::string(DOB_SOURCE_DIR) + "/robot/dogbot/dogbot.urdf");
  for (std::size_t at = 0; (at = urdf.find("front_right_knee", at)) != std::string::npos; ++at) urdf[at] = 'F';
  files.write("other.urdf", urdf);
  const std::string robot = "[robot]\nurdf = \"other.urdf\"\n[robot.posture_rad]\n";
  std::string posture = "Front_right_knee = 1.5\nfront_right_roll = 0.1\nfront_right_pitch = 0.8\n";
  for (const std::string leg : {"front_left", "back_left", "back_right"}) {
    for (const std::string joint : {"roll", "pitch", "knee"})
      posture.append(leg).append("_").append(joint).append(" = 0.0\n");
  }
  const RobotConfig config = load_text(files, robot + posture).robot;
  EXPECT_EQ(config.urdf, files.directory() / "other.urdf");
  EXPECT_EQ(config.posture.size(), 12u);
  EXPECT_EQ(config.posture.at("Front_right_knee"), 1.5);
}

TEST(Layers, TheTorqueLimitOfAnotherRobotIsTheSmallestEffortOfItsJointsUnlessAFileSaysOne) {
  const ScratchFiles files;
  const std::string robot = std::string(DOB_SOURCE_DIR) + "/scenarios/config/robots/quad12.toml";
  const auto limit = [&](const std::string& text) {
    files.write("below.toml", kSmallest + "[controller]\ntorque_limit_Nm = 50\n");
    return load_one({.name = files.write("mine.toml", "base = [\"below.toml\", \"" + robot + "\"]\n" + text)})
        .controller.torque_limit;
  };
  EXPECT_EQ(load_one({.name = "undisturbed"}).controller.torque_limit, 60.0);
  EXPECT_EQ(limit(""), 33.5);
  EXPECT_EQ(limit("[controller]\ntorque_limit_Nm = 20\n"), 20.0);
  std::string weak = read_text(std::string(DOB_SOURCE_DIR) + "/robot/quad12/quad12.urdf");
  const std::size_t one = weak.rfind("effort=\"33.5\"");
  files.write("weak.urdf", weak.replace(one, 13, "effort=\"17\""));
  EXPECT_EQ(limit("[robot]\nurdf = \"weak.urdf\"\nposture_rad = { front_left_roll = 0, front_left_pitch = -0.8, "
                  "front_left_knee = 1.6, front_right_roll = 0, front_right_pitch = -0.8, front_right_knee = 1.6, "
                  "hind_left_roll = 0, hind_left_pitch = -0.8, hind_left_knee = 1.6, hind_right_roll = 0, "
                  "hind_right_pitch = -0.8, hind_right_knee = 1.6 }\n"),
            17.0);
}

TEST(Layers, ABoxAndAPointOnTheTrunkAreReadAsWritten) {
  const ScratchFiles files;
  const Scenario s = load_text(
      files,
      "[[terrain.boxes]]\ncenter_m = [1, 0, 0]\nsize_m = [0.15, 0.2, 0.04]\nfriction = 0.6\n"
      "[[disturbance]]\nprofile = \"constant\"\namplitude_N = -5\nstart_s = 2\nduration_s = 0.2\nleg = \"trunk\"\n"
      "point_m = [0.1, 0, 0.05]\ndirection = [3, 0, -4]\nframe = \"base\"\n");
  ASSERT_EQ(s.terrain.boxes.size(), 1u);
  EXPECT_EQ(s.terrain.boxes[0].center, Vec3(1, 0, 0));
  EXPECT_EQ(s.terrain.boxes[0].size, Vec3(0.15, 0.2, 0.04));
  EXPECT_EQ(s.terrain.boxes[0].yaw_rad, 0.0);
  EXPECT_EQ(s.terrain.boxes[0].friction, 0.6);
  ASSERT_EQ(s.disturbances.size(), 1u);
  const Disturbance& d = s.disturbances[0];
  EXPECT_EQ(d.leg, AppliedForce::kTrunk);
  EXPECT_EQ(d.profile.amplitude_N, -5.0);
  EXPECT_EQ(d.profile.start_s, 2.0);
  EXPECT_EQ(d.profile.duration_s, 0.2);
  EXPECT_EQ(d.p_L, Vec3(0.1, 0, 0.05));
  EXPECT_LT((d.direction - Vec3(0.6, 0, -0.8)).norm(), 1e-15);
  EXPECT_EQ(d.frame, Disturbance::Frame::kBase);
}

TEST(DataDirectory, CanBeChosenByTheEnvironment) {
  const ScratchFiles files;
  std::filesystem::copy(std::string(DOB_SOURCE_DIR) + "/scenarios/config", files.directory() / "config",
                        std::filesystem::copy_options::recursive);
  files.write("other.toml", kSmallest);
  setenv("DOBBENCH_SCENARIOS", files.directory().c_str(), 1);
  const std::vector<ScenarioInfo> list = list_scenarios();
  unsetenv("DOBBENCH_SCENARIOS");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].name, "other");
}

}  // namespace
}  // namespace dob::scenario_files_test
