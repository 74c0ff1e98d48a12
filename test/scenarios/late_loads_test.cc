#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::late_loads_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Ten seconds of walking, a seed may shift what happens by up to 0.5 s.
class LateLoads : public testing::Test {
 protected:
  ScratchFiles files;

  std::vector<std::string> of(const std::string& text, bool shifted, const std::string& override = "sim.dt_s=0.001") {
    const std::string head = kSmallest + "[seeds]\ndisturbance_onset_s = 0.5\n";
    return late_loads({.name = files.write("mine.toml", head + text), .overrides = {override}}, "", shifted);
  }

  static std::string push(const std::string& when) {
    return "[[disturbance]]\nprofile = \"constant\"\namplitude_N = 5\nleg = \"trunk\"\npoint = \"origin\"\n"
           "direction = [0, 1, 0]\n" +
           when;
  }
};

TEST_F(LateLoads, BeginWhenTheTrialIsOver) {
  EXPECT_THAT(of(push("start_s = 9.9\n"), false), IsEmpty());
  EXPECT_THAT(of(push("start_s = 10\n"), false),
              ElementsAre(HasSubstr("mine.toml:13:1: disturbance.0.start_s: 10 s; the trial is over at 10 s")));
  EXPECT_THAT(of("[[payload]]\nat_s = 12\nmass_kg = 1\npoint_m = [0, 0, 0]\n", false),
              ElementsAre(HasSubstr("mine.toml:8:1: payload.0.at_s: 12 s")));
  EXPECT_THAT(of("[[disturbance]]\nprofile = \"random\"\nmin_N = 1\nmax_N = 2\nhold_s = 1\nstart_s = 11\nlegs = "
                 "\"any\"\n",
                 false),
              ElementsAre(HasSubstr("disturbance.0.start_s: 11 s")));
}

TEST_F(LateLoads, AreThoseThatASeedMayShiftBeyondTheEnd) {
  EXPECT_THAT(of(push("start_s = 9.4\n"), true), IsEmpty());
  EXPECT_THAT(of(push("start_s = 9.5\n"), false), IsEmpty());
  EXPECT_THAT(of(push("start_s = 9.5\n"), true), ElementsAre(HasSubstr("a seed shifts it by up to 0.5 s")));
}

TEST_F(LateLoads, AreThoseOfATrialThatWasCutShort) {
  EXPECT_THAT(of(push("start_s = 4\n"), false, "duration_s=3"), ElementsAre(HasSubstr("the trial is over at 3 s")));
  EXPECT_THAT(of(push(""), false, "duration_s=0.1"), IsEmpty());  // from the start
}

TEST_F(LateLoads, AreNotThoseThatWaitForTheGait) {
  EXPECT_THAT(of(push("trigger = \"gait_phase\"\ntrigger_leg = \"LF\"\nphase = 0.1\n"), true, "duration_s=0.1"),
              IsEmpty());
  EXPECT_THAT(of(push("trigger = \"time\"\nstart_s = 4\n"), true, "duration_s=3"), ElementsAre(HasSubstr("4 s")));
}

TEST(ShippedScenarios, HaveNoDisturbanceThatNeverActs) {
  for (const ScenarioInfo& info : list_scenarios()) {
    for (const Scenario& scenario : load_scenarios({.name = info.name})) {
      EXPECT_THAT(late_loads({.name = info.name}, scenario.variant, true), IsEmpty()) << info.name;
    }
  }
}

}  // namespace
}  // namespace dob::late_loads_test
