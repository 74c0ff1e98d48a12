// Every class of bad input: the exact message, with the exact place.
#include "scenarios/input_error.h"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::input_error_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string error_of(const ScenarioRequest& request) {
  try {
    load_scenarios(request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// What is said about the text, without the file's directory.
std::string error_in(const std::string& text) {
  const ScratchFiles files;
  std::string message = error_of({.name = files.write("mine.toml", text)});
  const std::string directory = files.directory().string() + "/";
  const std::size_t at = message.find(directory);
  return at == std::string::npos ? message : message.erase(at, directory.size());
}

std::string error_with(const std::string& appended) {
  return error_in(kSmallest + appended);
}

std::string error_set(const std::string& text) {
  return error_of({.name = "case1/tip_lateral", .overrides = {text}});
}

const std::string kPush =
    "[[disturbance]]\nprofile = \"constant\"\namplitude_N = 5.0\nleg = \"LF\"\nlink = \"lower\"\n"
    "point = \"origin\"\ndirection = [0, 1, 0]\n";

TEST(InputError, TheSmallestScenarioHasNone) {
  EXPECT_EQ(error_with(""), "no error");
  EXPECT_EQ(error_with(kPush), "no error");
}

TEST(InputError, ASamplingThatTheGaitAndTheHorizonHaveNoRoomForIsNamedWhereItIsWritten) {
  EXPECT_EQ(error_with("[planner.zmp]\nsample_s = 0.001\n"),
            "mine.toml:6:1: planner.zmp.sample_s: 0.001; allowed: at most 300 samples over the 2 footsteps of the "
            "horizon, these are 680 (a stance of 0.15 s, a swing of 0.115 s)");
  EXPECT_EQ(error_with("[planner]\nkind = \"spline\"\n[planner.zmp]\nsample_s = 0.001\n"), "no error");
}

TEST(InputError, ASwitchOfTheGaitThatDoesNotFitTheOthersIsNamedWhereItIsWritten) {
  const std::string crawl = "[[gait.switch]]\nat_s = 3\nkind = \"crawl\"\nstance_s = 0.5\nswing_s = 0.3\n";
  const std::string stand = "[[gait.switch]]\nat_s = 2\nkind = \"stand\"\nstance_s = 0.5\nswing_s = 0.3\n";
  EXPECT_EQ(error_with(stand + crawl), "no error");
  EXPECT_EQ(error_with(crawl + stand),
            "mine.toml:11:1: gait.switch.1.at_s: 2; allowed: not before the previous switch, 3 s");
  EXPECT_EQ(error_with("[gait]\nswing_s = 0.4\nearly_touchdown_window_s = 0.35\n" + crawl),
            "mine.toml:12:1: gait.switch.0.swing_s: 0.3; allowed: at least early_touchdown_window_s, 0.35");
}

TEST(InputError, UnknownKeysNameTheOneThatWasMeant) {
  EXPECT_EQ(error_with("[gait]\nstance_ms = 150\n"),
            "mine.toml:6:1: gait.stance_ms: unknown key 'stance_ms'; did you mean 'stance_s'?");
  EXPECT_EQ(error_with("[[disturbance]]\nprofile = \"constant\"\n  amplitude_kN = 5.0\n"),
            "mine.toml:7:3: disturbance.0.amplitude_kN: unknown key 'amplitude_kN'; did you mean 'amplitude_N'?");
  EXPECT_EQ(error_with("[fall]\nmax_tilt_deg = 40\n"),
            "mine.toml:6:1: fall.max_tilt_deg: unknown key 'max_tilt_deg'; did you mean 'max_tilt_rad'?");
  EXPECT_EQ(error_with("[[path]]\nyaw_rate = 0.05\n"),
            "mine.toml:6:1: path.1.yaw_rate: unknown key 'yaw_rate'; did you mean 'yaw_rate_rad_s'?");
  EXPECT_EQ(error_with("[sim]\ndt = 0.001\n"), "mine.toml:6:1: sim.dt: unknown key 'dt'; did you mean 'dt_s'?");
  EXPECT_EQ(error_with("[gaits]\nstance_s = 0.1\n"), "mine.toml:5:2: gaits: unknown key 'gaits'; did you mean 'gait'?");
  EXPECT_EQ(error_with("[noise]\nwhatever = 1\n"),
            "mine.toml:6:1: noise.whatever: unknown key 'whatever'; allowed: torque_relative, foot_force_relative");
}

TEST(InputError, WhatIsAllowedIsNamedOnce) {
  const std::string error = error_in("zzzzzzzz = 1\n" + kSmallest);
  const std::size_t path = error.find(" path,");
  ASSERT_NE(path, std::string::npos) << error;
  EXPECT_EQ(error.find(" path,", path + 1), std::string::npos) << error;
}

TEST(InputError, KeysThatHaveNoMeaningHereAreUnknown) {
  EXPECT_THAT(error_with(kPush + "period_s = 1.0\n"),
              StartsWith("mine.toml:12:1: disturbance.0.period_s: unknown key 'period_s'"));
  EXPECT_THAT(error_with("[[disturbance]]\nprofile = \"constant\"\namplitude_N = 1\nleg = \"trunk\"\nlink = \"hip\"\n"
                         "point = \"origin\"\ndirection = [1, 0, 0]\n"),
              StartsWith("mine.toml:9:1: disturbance.0.link: unknown key 'link'"));
  EXPECT_THAT(error_with("[variant.a.variant.b]\n"), StartsWith("mine.toml:5:12: variant: unknown key 'variant'"));
}

TEST(InputError, WrongTypesSayWhatIsAllowed) {
  EXPECT_EQ(error_with("[gait]\nstance_s = \"0.15\"\n"),
            "mine.toml:6:1: gait.stance_s: \"0.15\"; allowed: a number above 0 to 10");
  EXPECT_EQ(error_with("[gait]\nstance_s = [1]\n"),
            "mine.toml:6:1: gait.stance_s: [1]; allowed: a number above 0 to 10");
  EXPECT_EQ(error_with("[gait]\nstance_s.x = 1\n"),
            "mine.toml:6:1: gait.stance_s: a table; allowed: a number above 0 to 10");
  EXPECT_EQ(error_with("[sim]\njoint_stops = 1\n"), "mine.toml:6:1: sim.joint_stops: 1; allowed: true or false");
  EXPECT_EQ(error_in("summary = 5\n"), "mine.toml:1:1: summary: 5; allowed: text in quotes");
  EXPECT_EQ(error_in("gait = 5\n" + kSmallest), "mine.toml:1:1: gait: 5; allowed: a table");
  EXPECT_EQ(error_in("disturbance = 5\n" + kSmallest),
            "mine.toml:1:1: disturbance: 5; allowed: an array of tables, [[disturbance]]");
  EXPECT_EQ(error_in("disturbance = [1]\n" + kSmallest), "mine.toml:1:16: disturbance.0: 1; allowed: a table");
  EXPECT_EQ(error_in("summary = \"s\"\npath = []\n"),
            "mine.toml:2:1: path: []; allowed: at least one [[path]] segment");
  EXPECT_EQ(error_with("[sim]\ndt_s = 1979-05-27\n"),
            "mine.toml:6:1: a date or a time; allowed: true, false, numbers, strings, arrays, tables");
}

TEST(InputError, NumbersHaveARange) {
  EXPECT_EQ(error_with("[gait]\nstance_s = 0\n"), "mine.toml:6:1: gait.stance_s: 0; allowed: a number above 0 to 10");
  EXPECT_EQ(error_with("[sim]\n\n  dt_s = 1.0 # ms?\n"),
            "mine.toml:7:3: sim.dt_s: 1; allowed: a number from 1e-05 to 0.01");
  EXPECT_EQ(error_with("[planner]\nlanding_offset_m = 0.05\n"),
            "mine.toml:6:1: planner.landing_offset_m: 0.05; allowed: a number from 0 to below 0.05");
  EXPECT_EQ(error_with("[gait]\nstance_s = 9007199254740993\n"),
            "mine.toml:6:1: gait.stance_s: 9007199254740992; allowed: a number above 0 to 10");
  EXPECT_EQ(error_with("[gait]\nswing_s = 0.2\nearly_touchdown_window_s = 0.3\n"),
            "mine.toml:7:1: gait.early_touchdown_window_s: 0.3; allowed: a number from 0 to 0.2");
  EXPECT_EQ(error_with("[terrain]\nground_friction = -0.1\n"),
            "mine.toml:6:1: terrain.ground_friction: -0.1; allowed: a number from 0 to 10");
}

TEST(InputError, NotANumberAndInfinityAreRefusedEverywhere) {
  EXPECT_EQ(error_with("[gait]\nlate_wait_s = nan\n"),
            "mine.toml:6:1: gait.late_wait_s: nan; allowed: a number from 0 to 10");
  EXPECT_EQ(error_with("[gait]\nlate_wait_s = inf\n"),
            "mine.toml:6:1: gait.late_wait_s: inf; allowed: a number from 0 to 10");
  EXPECT_EQ(error_with(kPush + "duration_s = inf\n"),
            "mine.toml:12:1: disturbance.0.duration_s: inf; allowed: a number above 0 to 100000");
  EXPECT_EQ(error_with("[gains]\nwrench_kp_linear_N_m = [1, nan, 1]\n"),
            "mine.toml:6:1: gains.wrench_kp_linear_N_m: [1, nan, 1]; "
            "allowed: a number from 0 to 1000000, or three for x, y, z");
}

TEST(InputError, WordsAreListed) {
  EXPECT_EQ(error_in("metric_leg = \"FL\"\n" + kSmallest),
            "mine.toml:1:1: metric_leg: \"FL\"; allowed: one of all, LF, RF, LH, RH");
  EXPECT_EQ(error_with("[planner]\nkind = \"best\"\n"),
            "mine.toml:6:1: planner.kind: \"best\"; allowed: one of zmp, spline, paper_split");
  EXPECT_EQ(error_with("[robot]\nforward = 3\n"), "mine.toml:6:1: robot.forward: 3; allowed: one of +x, -x, +y, -y");
}

TEST(InputError, VectorsHaveThreeNumbersAndADirectionIsNotZero) {
  EXPECT_EQ(error_with("[[terrain.boxes]]\ncenter_m = [1, 2]\n"),
            "mine.toml:6:1: terrain.boxes.0.center_m: [1, 2]; allowed: three numbers, each from -10000 to 10000");
  std::string push = kPush;
  push.replace(push.find("[0, 1, 0]"), 9, "[0, 0, 0]");
  EXPECT_EQ(error_with(push),
            "mine.toml:11:1: disturbance.0.direction: [0, 0, 0]; allowed: a vector with a norm of at least 1e-06");
}

TEST(InputError, AFootIsOnlyOnALowerLinkAndAPointIsGivenOnce) {
  EXPECT_EQ(error_with(kPush + "point_m = [0, 0, 0]\n"),
            "mine.toml:10:1: disturbance.0.point: \"origin\"; allowed: either point or point_m, not both");
  EXPECT_EQ(error_with("[[disturbance]]\nprofile = \"constant\"\namplitude_N = 5.0\nleg = \"LF\"\nlink = \"upper\"\n"
                       "point = \"foot\"\ndirection = [0, 1, 0]\n"),
            "mine.toml:10:1: disturbance.0.point: \"foot\"; "
            "allowed: foot only on the lower link of a leg; else origin");
}

TEST(InputError, ProfilesNeedTheirParametersAndRefuseWhatCannotBe) {
  const auto with = [](const std::string& profile) {
    return error_with("[[disturbance]]\nprofile = " + profile +
                      "\namplitude_N = 5.0\nleg = \"LF\"\nlink = \"lower\"\npoint = \"origin\"\n"
                      "direction = [0, 1, 0]\n");
  };
  EXPECT_EQ(with("\"pulse\"\nduration_s = 0.2"), "no error");
  EXPECT_EQ(with("\"ramp\"\nramp_s = 2.0"), "no error");
  EXPECT_EQ(with("\"chirp\"\nf0_Hz = 0\nf1_Hz = 10\nduration_s = 5\nphase_rad = 1"), "no error");
  EXPECT_EQ(with("\"pulse\""), "mine.toml:5:1: disturbance.0.duration_s: missing; the key is needed here");
  EXPECT_EQ(with("\"chirp\"\nf0_Hz = 0\nf1_Hz = 10"),
            "mine.toml:5:1: disturbance.0.duration_s: missing; the key is needed here");
  EXPECT_EQ(with("\"ramp\"\nramp_s = 2.0\nduration_s = 1.5"),
            "mine.toml:7:1: disturbance.0.ramp_s: 2; allowed: at most duration_s, 1.5");
  EXPECT_EQ(with("\"ramp\"\nramp_s = 0"),
            "mine.toml:7:1: disturbance.0.ramp_s: 0; allowed: a number above 0 to 100000");
  EXPECT_EQ(with("\"chirp\"\nf0_Hz = 0\nf1_Hz = 501\nduration_s = 5"),
            "mine.toml:8:1: disturbance.0.f1_Hz: 501; allowed: a number from 0 to 500");
  EXPECT_THAT(with("\"sine\"\nperiod_s = 0.0019"),
              HasSubstr("disturbance.0.period_s: 0.0019; allowed: a number from 0.002 to"));
  EXPECT_EQ(with("\"sine\"\nperiod_s = 0.002"), "no error");
  EXPECT_THAT(with("\"sine\"\nperiod_s = 1\nramp_s = 1"), HasSubstr("disturbance.0.ramp_s: unknown key 'ramp_s'"));
}

TEST(InputError, ATriggerHasALegAPhaseAndAGaitThatWalks) {
  const auto with = [](const std::string& trigger) { return error_with(kPush + trigger + "\n"); };
  const std::string gait_phase = "trigger = \"gait_phase\"\ntrigger_leg = \"RF\"\n";
  EXPECT_EQ(with(gait_phase + "phase = 0.1\nnot_before_s = 2.8"), "no error");
  EXPECT_EQ(with("trigger = \"time\"\nstart_s = 1.0"), "no error");
  EXPECT_EQ(with("trigger = \"touchdown\""),
            "mine.toml:12:1: disturbance.0.trigger: \"touchdown\"; allowed: one of time, gait_phase");
  EXPECT_EQ(with(gait_phase + "phase = 1.0"),
            "mine.toml:14:1: disturbance.0.phase: 1; allowed: a number from 0 to below 1");
  EXPECT_EQ(with("trigger = \"gait_phase\"\ntrigger_leg = \"trunk\"\nphase = 0.1"),
            "mine.toml:13:1: disturbance.0.trigger_leg: \"trunk\"; allowed: one of LF, RF, LH, RH");
  EXPECT_EQ(with(gait_phase), "mine.toml:5:1: disturbance.0.phase: missing; the key is needed here");
  EXPECT_THAT(with(gait_phase + "phase = 0.1\nstart_s = 1.0"), HasSubstr("disturbance.0.start_s: unknown key"));
  EXPECT_THAT(with("phase = 0.1"), HasSubstr("disturbance.0.phase: unknown key"));
  EXPECT_EQ(with(gait_phase + "phase = 0.1\n[gait]\nkind = \"stand\""),
            "mine.toml:12:1: disturbance.0.trigger: \"gait_phase\"; "
            "allowed: time, as no leg swings while the gait stands");
}

TEST(InputError, ARandomDisturbanceIsCheckedLikeAWrittenOne) {
  const std::string random =
      "[[disturbance]]\nprofile = \"random\"\nmin_N = 10\nmax_N = 35\nhold_s = 2\nlegs = \"any\"\n";
  EXPECT_EQ(error_with(random), "no error");
  const auto with = [&](const std::string& line, const std::string& other) {
    std::string text = random;
    return error_with(text.replace(text.find(line), line.size(), other));
  };
  EXPECT_EQ(
      with("\"random\"", "\"noise\""),
      "mine.toml:6:1: disturbance.0.profile: \"noise\"; allowed: one of constant, pulse, sine, ramp, chirp, random");
  EXPECT_EQ(with("min_N = 10", "min_N = -1"),
            "mine.toml:7:1: disturbance.0.min_N: -1; allowed: a number from 0 to 100000");
  EXPECT_EQ(with("max_N = 35", "max_N = 5"),
            "mine.toml:8:1: disturbance.0.max_N: 5; allowed: a number from 10 to 100000");
  EXPECT_EQ(with("hold_s = 2", "hold_s = 0"),
            "mine.toml:9:1: disturbance.0.hold_s: 0; allowed: a number from 0.05 to 100000");
  EXPECT_EQ(with("hold_s = 2", "hold_ms = 2"),
            "mine.toml:9:1: disturbance.0.hold_ms: unknown key 'hold_ms'; did you mean 'hold_s'?");
  const std::string legs = "; allowed: \"any\", or a list of LF, RF, LH, RH, each at most once";
  EXPECT_EQ(with("\"any\"", "\"FL\""), "mine.toml:10:1: disturbance.0.legs: \"FL\"" + legs);
  EXPECT_EQ(with("\"any\"", "[\"LF\", \"LF\"]"), "mine.toml:10:1: disturbance.0.legs: [\"LF\", \"LF\"]" + legs);
  EXPECT_EQ(with("\"any\"", "[\"LF\", \"any\"]"), "mine.toml:10:1: disturbance.0.legs: [\"LF\", \"any\"]" + legs);
  EXPECT_EQ(with("\"any\"", "[]"), "mine.toml:10:1: disturbance.0.legs: []; allowed: a text, or a list of texts");
  EXPECT_EQ(with("\"any\"", "[1]"), "mine.toml:10:1: disturbance.0.legs: [1]; allowed: a text, or a list of texts");
  EXPECT_THAT(with("legs = \"any\"\n", ""), HasSubstr("disturbance.0.legs: missing"));
  EXPECT_THAT(error_with(random + "direction = [1, 0, 0]\n"),
              StartsWith("mine.toml:11:1: disturbance.0.direction: unknown key 'direction'"));
}

TEST(InputError, MissingKeysNameTheirTable) {
  EXPECT_EQ(error_in("summary = \"s\"\n"), "mine.toml:1:1: path: missing; the key is needed here");
  EXPECT_EQ(error_in("[[path]]\nduration_s = 1\nspeed_m_s = 0.1\n"),
            "mine.toml:1:1: summary: missing; the key is needed here");
  EXPECT_EQ(error_with("[[path]]\nspeed_m_s = 0.1\n"),
            "mine.toml:5:1: path.1.duration_s: missing; the key is needed here");
}

TEST(InputError, BrokenTomlHasLineAndColumn) {
  EXPECT_THAT(error_with("[gait\nstance_s = 1\n"), StartsWith("mine.toml:5:6: "));
  EXPECT_THAT(error_with("[gait]\nstance_s = \n"), StartsWith("mine.toml:6:12: "));
  EXPECT_THAT(error_with("[gait]\nstance_s = 1\nstance_s = 2\n"), StartsWith("mine.toml:7:"));
  EXPECT_THAT(error_in("summary = \"\xff\"\n"), StartsWith("mine.toml:1:"));
}

TEST(InputError, MissingFilesAndScenariosAreNamed) {
  const ScratchFiles files;
  const std::string missing = (files.directory() / "none.toml").string();
  EXPECT_EQ(error_of({.name = missing}),
            missing + ": cannot be opened: No such file or directory; a TOML file is needed");
  const std::string directory = (files.directory() / "folder.toml").string();
  std::filesystem::create_directory(directory);
  EXPECT_EQ(error_of({.name = directory}), directory + ": is a directory; a TOML file is needed");
  std::string shipped;
  for (const ScenarioInfo& info : list_scenarios()) shipped += (shipped.empty() ? "" : ", ") + info.name;
  EXPECT_EQ(error_of({.name = "case9"}), "scenario: there is no 'case9'; there are: " + shipped);
  EXPECT_EQ(error_of({.name = ""}), "scenario: there is no ''; there are: " + shipped);
  EXPECT_EQ(error_of({.name = "../scenarios/case1"}), "scenario: there is no '..'; there are: " + shipped);
}

TEST(InputError, VariantsAreNamed) {
  EXPECT_EQ(error_of({.name = "case1/hip"}),
            "variant: there is no 'hip'; there are: knee_lateral, tip_lateral, knee_sagittal, tip_sagittal");
  EXPECT_THAT(error_of({.name = "undisturbed/hip"}), HasSubstr("there is no variant 'hip'; the scenario has none"));
  EXPECT_EQ(error_with("[variant]\n"), "mine.toml:5:2: variant: empty; allowed: tables [variant.NAME]");
  EXPECT_EQ(error_with("[variant]\na = 1\n"), "mine.toml:6:1: variant.a: 1; allowed: a table");
  EXPECT_EQ(error_with("[variant.\"a/b\"]\n"),
            "mine.toml:5:10: variant.a/b: allowed in a name: letters, digits, _ and -, at most 100 of them");
}

TEST(InputError, ANameIsAWordAndMayHoldAVariantOnlyWithoutVariants) {
  const std::string allowed = "; allowed: \"NAME\", or \"NAME/VARIANT\" in a file without variants";
  EXPECT_EQ(error_in("name = \"a b\"\n" + kSmallest), "mine.toml:1:1: name: \"a b\"" + allowed);
  const ScratchFiles files;
  EXPECT_THAT(error_of({.name = files.write("a b.toml", kSmallest)}),
              HasSubstr("a b.toml: 'a b' is no name; allowed: "));
  EXPECT_EQ(error_in("name = 3\n" + kSmallest), "mine.toml:1:1: name: 3" + allowed);
  EXPECT_EQ(error_in("name = \"a/b\"\n" + kSmallest + "[variant.c]\n"), "mine.toml:1:1: name: \"a/b\"" + allowed);
}

TEST(InputError, RobotDescriptionsThatCannotBeUsedAreRefusedWhereTheyAreNamed) {
  EXPECT_THAT(error_with("[robot]\nurdf = \"none.urdf\"\n"), StartsWith("mine.toml:6:1: robot.urdf: "));
  EXPECT_EQ(error_with("[robot.posture_rad]\nfront_left_knee = 1.0\n"),
            "mine.toml:6:1: robot.posture_rad.front_left_knee: 1; allowed: a number from -2.618 to 0.02");
  EXPECT_EQ(error_with("[robot.posture_rad]\nfront_left_kneee = 1.0\n"),
            "mine.toml:6:1: robot.posture_rad.front_left_kneee: unknown key 'front_left_kneee'; "
            "did you mean 'front_left_knee'?");
  const std::string dogbot = std::string(DOB_SOURCE_DIR) + "/robot/dogbot/dogbot.urdf";
  EXPECT_THAT(error_with("[robot]\nurdf = \"" + dogbot + "\"\nposture_rad.front_left_knee = -1.6\n"),
              testing::MatchesRegex("mine.toml:7:1: robot.posture_rad..*: missing; the key is needed here"));
}

TEST(InputError, GainSetsAndPlannersAreNamed) {
  EXPECT_EQ(error_of({.name = "case1", .gains = "soft"}),
            "--gains: there is no 'soft'; there are: own, paper, swing300, stiff");
  EXPECT_EQ(error_of({.name = "case1", .planner = "best"}),
            "--planner planner.kind: \"best\"; allowed: one of zmp, spline, paper_split");
}

TEST(InputError, OverridesNameTheirKey) {
  EXPECT_EQ(error_set("sim.dt_s=0.0005"), "no error");
  EXPECT_EQ(error_set("sim.dt_s=1"), "--set sim.dt_s: 1; allowed: a number from 1e-05 to 0.01");
  EXPECT_EQ(error_set("sim.dt_s=fast"), "--set sim.dt_s: \"fast\"; allowed: a number from 1e-05 to 0.01");
  EXPECT_EQ(error_set("sim.dt_ms=1"), "--set sim.dt_ms: unknown key 'dt_ms'; did you mean 'dt_s'?");
  EXPECT_EQ(error_set("simm.dt_s=1"), "--set simm: unknown key 'simm'; did you mean 'sim'?");
  EXPECT_THAT(error_set("name=x"), StartsWith("--set name: unknown key 'name'"));
  EXPECT_EQ(error_set("disturbance.0.amplitude_N=nan"),
            "--set disturbance.0.amplitude_N: nan; allowed: a number from -100000 to 100000");
  EXPECT_EQ(error_set("disturbance.1.amplitude_N=1"),
            "--set disturbance.1.amplitude_N: no element '1'; there are 1, counted from 0");
  EXPECT_EQ(error_set("disturbance.first.amplitude_N=1"),
            "--set disturbance.first.amplitude_N: no element 'first'; there are 1, counted from 0");
  EXPECT_EQ(error_set("gait.stance_s.x=1"), "--set gait.stance_s.x: nothing is called 'x' below 0.15");
}

TEST(InputError, OverridesAreAKeyAndOneTomlValue) {
  EXPECT_EQ(error_set("sim.dt_s"), "--set sim.dt_s: no '='; allowed: KEY=VALUE");
  EXPECT_EQ(error_set("=1"), "--set: a part of the key is empty");
  EXPECT_EQ(error_set("sim..dt_s=1"), "--set sim..dt_s: a part of the key is empty");
  EXPECT_THAT(error_set("sim.dt_s="), StartsWith("--set sim.dt_s: ; "));
  EXPECT_THAT(error_set("sim.dt_s=[1"), StartsWith("--set sim.dt_s: [1; "));
  EXPECT_EQ(error_set("sim.dt_s=1\nx = 2"), "--set sim.dt_s: more than one value; allowed: one TOML value");
}

TEST(InputError, ShippedFilesCutShortLoadOrAreRefused) {
  const ScratchFiles files;
  int refused = 0;
  for (const ScenarioInfo& info : list_scenarios()) {
    const std::string text = read_text(info.path);
    for (std::size_t length = 0; length < text.size(); length += 50) {
      const std::string path = files.write("cut.toml", text.substr(0, length));
      if (error_of({.name = path}) != "no error") ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

TEST(InputError, ShippedSettingsCutShortLoadOrAreRefused) {
  const ScratchFiles files;
  const std::filesystem::path project = DOB_SOURCE_DIR;
  const auto recursive = std::filesystem::copy_options::recursive;
  std::filesystem::copy(project / "scenarios", files.directory() / "scenarios", recursive);
  std::filesystem::copy(project / "robot", files.directory() / "robot", recursive);
  setenv("DOBBENCH_SCENARIOS", (files.directory() / "scenarios").c_str(), 1);
  const auto loads = [] {
    try {
      load_scenarios({.name = "undisturbed"});
      load_observer("momentum", "matched");
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  EXPECT_TRUE(loads());
  for (const std::string name : {"defaults.toml", "gains.toml", "profiles/matched.toml"}) {
    const std::string text = read_text(project / "scenarios/config" / name);
    int refused = 0;
    for (std::size_t length = 0; length < text.size(); length += 50) {
      files.write("scenarios/config/" + name, text.substr(0, length));
      if (!loads()) ++refused;
    }
    EXPECT_GE(refused, 2) << name;
    files.write("scenarios/config/" + name, text);
  }
  unsetenv("DOBBENCH_SCENARIOS");
}

}  // namespace
}  // namespace dob::input_error_test
