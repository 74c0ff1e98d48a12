// What a scenario's file may say about itself: what it is laid over, whose trials it names, what it is about.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::scenario_source_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// What loading the file says, without the directory.
std::string error_of(const ScratchFiles& files, const std::string& request) {
  try {
    load_scenarios({.name = (files.directory() / request).string()});
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string directory = files.directory().string() + "/";
    for (std::size_t at = 0; (at = message.find(directory)) != std::string::npos;) message.erase(at, directory.size());
    return message;
  }
  return "no error";
}

std::vector<Scenario> load(const ScratchFiles& files, const std::string& request) {
  return load_scenarios({.name = (files.directory() / request).string()});
}

TEST(Base, IsLaidBelowTheFileAndAboveTheDefaults) {
  const ScratchFiles files;
  files.write("below.toml", kSmallest + "[gait]\nstance_s = 0.2\nswing_s = 0.3\n[variant.a.gait]\nlate_wait_s = 0.7\n");
  files.write("above.toml", "base = \"below.toml\"\nsummary = \"t\"\n[gait]\nswing_s = 0.4\n");
  const std::vector<Scenario> scenarios = load(files, "above.toml");
  ASSERT_EQ(scenarios.size(), 1u);  // the base's variants stay with it
  EXPECT_EQ(scenarios[0].name, "above");
  EXPECT_EQ(scenarios[0].variant, "");
  EXPECT_EQ(scenarios[0].summary, "t");
  EXPECT_EQ(scenarios[0].duration, 10.0);
  EXPECT_EQ(scenarios[0].gait.pattern.stance_duration, 0.2);
  EXPECT_EQ(scenarios[0].gait.pattern.swing_duration, 0.4);
  EXPECT_EQ(scenarios[0].gait.late_wait, 0.1);
}

TEST(Base, MayBeAVariantAndHaveABaseItself) {
  const ScratchFiles files;
  files.write("one.toml", kSmallest + "[variant.a.gait]\nlate_wait_s = 0.7\n");
  files.write("folder/two.toml", "base = \"../one.toml/a\"\n[gait]\nstance_s = 0.2\n");
  files.write("three.toml", "base = \"folder/two.toml\"\n[variant.x]\n[variant.y.gait]\nswing_s = 0.5\n");
  const std::vector<Scenario> scenarios = load(files, "three.toml");
  ASSERT_EQ(scenarios.size(), 2u);
  EXPECT_EQ(scenarios[1].variant, "y");
  EXPECT_EQ(scenarios[1].gait.late_wait, 0.7);
  EXPECT_EQ(scenarios[1].gait.pattern.stance_duration, 0.2);
  EXPECT_EQ(scenarios[1].gait.pattern.swing_duration, 0.5);
  EXPECT_EQ(scenarios[0].gait.pattern.swing_duration, 0.115);
  EXPECT_EQ(scenarios[0].summary, "s");
}

TEST(Base, MayBeAShippedScenario) {
  const ScratchFiles files;
  files.write("mine.toml", "base = \"case1/tip_sagittal\"\nmetric_leg = \"RH\"\n");
  const Scenario mine = load(files, "mine.toml").at(0);
  const Scenario shipped = load_scenarios({.name = "case1/tip_sagittal"}).at(0);
  EXPECT_EQ(mine.metric_leg, Leg::kRH);
  EXPECT_EQ(mine.duration, shipped.duration);
  EXPECT_EQ(mine.disturbances.at(0).p_L, shipped.disturbances.at(0).p_L);
}

TEST(Base, MayBeSeveralOfWhichTheLaterAreLaidOverTheEarlier) {
  const ScratchFiles files;
  files.write("case.toml", kSmallest + "[gait]\nstance_s = 0.2\nswing_s = 0.3\nlate_wait_s = 0.7\n");
  files.write("robot/mine.toml", "[gait]\nstance_s = 0.4\nswing_s = 0.5\n");  // keys of a robot, no scenario
  files.write("both.toml", "base = [\"case.toml\", \"robot/mine.toml\"]\n[gait]\nswing_s = 0.6\n");
  const Scenario both = load(files, "both.toml").at(0);
  EXPECT_EQ(both.gait.late_wait, 0.7);
  EXPECT_EQ(both.gait.pattern.stance_duration, 0.4);
  EXPECT_EQ(both.gait.pattern.swing_duration, 0.6);
  files.write("both.toml", "base = [\"robot/mine.toml\", \"case.toml/a\"]\n");
  EXPECT_THAT(error_of(files, "both.toml"), HasSubstr("both.toml:1:28: base: there is no 'a'"));
  files.write("both.toml", "base = [\"robot/mine.toml\", 3]\n");
  EXPECT_EQ(error_of(files, "both.toml"), "both.toml:1:28: base: 3; allowed: a scenario's name or file");
  files.write("both.toml", "base = []\n");
  EXPECT_EQ(error_of(files, "both.toml"), "both.toml:1:1: base: empty; allowed: names or files");
}

TEST(Base, ErrorsStayWhereTheyWereWritten) {
  const ScratchFiles files;
  files.write("below.toml", kSmallest + "[gait]\nstance_s = -1\n");
  files.write("above.toml", "base = \"below.toml\"\n[gait]\nswing_ms = 4\n");
  EXPECT_THAT(error_of(files, "above.toml"), HasSubstr("below.toml:6:1: gait.stance_s: -1"));
  files.write("below.toml", kSmallest);
  EXPECT_THAT(error_of(files, "above.toml"), HasSubstr("above.toml:3:1: gait.swing_ms: unknown key 'swing_ms'"));
}

TEST(Base, ThatDoesNotExistOrLeadsBackIsRefusedWhereItIsNamed) {
  const ScratchFiles files;
  const auto with = [&files](const std::string& base) {
    files.write("mine.toml", kSmallest.substr(0, kSmallest.find('\n') + 1) + "base = " + base + "\n");
    return error_of(files, "mine.toml");
  };
  EXPECT_THAT(with("\"case9\""), AllOf(HasSubstr("mine.toml:2:1: base: there is no 'case9'; there are: "),
                                       HasSubstr(" case1, case1_no_swing, case2, ")));
  EXPECT_THAT(with("\"case1/hip\""), HasSubstr("mine.toml:2:1: base: there is no 'hip'; there are: knee_lateral"));
  EXPECT_EQ(with("\"none.toml\""), "mine.toml:2:1: base: there is no file 'none.toml'");
  EXPECT_EQ(with("3"), "mine.toml:2:1: base: 3; allowed: a scenario's name or file");
  EXPECT_EQ(with("\"mine.toml\""), "mine.toml:2:1: base: 'mine.toml' leads back to itself");
  files.write("other.toml", "base = \"./mine.toml\"\n");
  EXPECT_EQ(with("\"other.toml\""), "other.toml:1:1: base: './mine.toml' leads back to itself");
}

TEST(Variants, MayChangeElementsOfAListByTheirNumber) {
  const ScratchFiles files;
  files.write("mine.toml", kSmallest +
                               "[[path]]\nduration_s = 1.0\nspeed_m_s = 0.2\n"
                               "[variant.slow]\npath.1.speed_m_s = 0.05\n[variant.past]\npath.2.speed_m_s = 0.05\n");
  const std::vector<PathSegment> path = load(files, "mine.toml/slow").at(0).path;
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0].speed, 0.12);
  EXPECT_EQ(path[1].speed, 0.05);
  EXPECT_EQ(path[1].duration, 1.0);
  EXPECT_EQ(error_of(files, "mine.toml/past"), "mine.toml:11:6: path.2: no element '2'; there are 2, counted from 0");
}

TEST(CellsOf, NamesTheTrialsOfAnotherScenario) {
  const ScratchFiles files;
  files.write("first.toml", kSmallest + "[variant.a]\n[variant.b]\n");
  files.write(
      "second.toml",
      "summary = \"again\"\ncells_of = \"first.toml\"\nset = \"paper\"\nobservers = [\"none\", \"momentum\"]\n");
  const std::vector<Scenario> scenarios = load(files, "second.toml");
  ASSERT_EQ(scenarios.size(), 2u);
  EXPECT_EQ(scenarios[0].name, "first");
  EXPECT_EQ(load(files, "second.toml/b").at(0).variant, "b");
  const ScenarioInfo info = scenario_info((files.directory() / "second.toml").string());
  EXPECT_EQ(info.name, "second");
  EXPECT_EQ(info.summary, "again");
  EXPECT_EQ(info.set, ScenarioSet::kPaper);
  EXPECT_THAT(info.variants, ElementsAre("a", "b"));
  ASSERT_EQ(info.observers.size(), 2u);
  EXPECT_EQ(info.observers[1].text, "momentum");
}

TEST(CellsOf, LeavesNothingElseToSay) {
  const ScratchFiles files;
  files.write("first.toml", kSmallest + "[variant.a]\n");
  files.write("second.toml", "cells_of = \"first.toml\"\nmetric_leg = \"LF\"\n");
  EXPECT_EQ(error_of(files, "second.toml"),
            "second.toml:2:1: metric_leg: the trials are those that cells_of names; "
            "allowed: cells_of, summary, set, observers, profiles");
  files.write("second.toml", "cells_of = \"second.toml\"\n");
  EXPECT_EQ(error_of(files, "second.toml"), "second.toml:1:1: cells_of: 'second.toml' leads back to itself");
  files.write("second.toml", "cells_of = \"first.toml/a\"\n");
  EXPECT_EQ(error_of(files, "second.toml"), "second.toml:1:1: cells_of: \"first.toml/a\"; allowed: a whole scenario");
}

TEST(FileKeys, AreCheckedAndStayWithTheirFile) {
  const ScratchFiles files;
  const auto with = [&files](const std::string& text) {
    files.write("mine.toml", text + "\n" + kSmallest);
    return error_of(files, "mine.toml");
  };
  EXPECT_EQ(with("set = \"all\""), "mine.toml:1:1: set: \"all\"; allowed: one of paper, extra");
  EXPECT_EQ(with("observers = 3"), "mine.toml:1:1: observers: 3; allowed: a text, or a list of texts");
  EXPECT_EQ(with("profiles = \"paper\""), "mine.toml:1:1: profiles: \"paper\"; allowed: only beside observers");
  EXPECT_EQ(with("profiles = \"best\"\nobservers = \"none\""),
            "mine.toml:1:1: profiles: there is no 'best'; there are: matched, paper, tuned");
  EXPECT_EQ(with("set = \"paper\"\nobservers = \"none\"\nprofiles = \"paper\""), "no error");
  files.write("other.toml", "base = \"mine.toml\"\n");
  const ScenarioInfo other = scenario_info((files.directory() / "other.toml").string());
  EXPECT_EQ(other.set, ScenarioSet::kExtra);
  EXPECT_TRUE(other.observers.empty());
  EXPECT_EQ(other.summary, "s");
}

}  // namespace
}  // namespace dob::scenario_source_test
