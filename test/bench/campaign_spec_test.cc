#include "bench/campaign_spec.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/campaign_plan.h"
#include "bench/campaign_search.h"
#include "test/results/run_samples.h"

namespace dob::campaign_spec_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kLimit = R"(kind = "limit"
summary = "a push"
scenarios = ["case3/left_10"]
observers = ["none", "momentum"]
profiles = ["tuned"]
set = ["duration_s=4"]
seeds = 3

[axis.amplitude]
set = "disturbance.0.amplitude_N={}"
unit = "N"
from = 20
to = 160
levels = 7
spacing = "log"
)";

class CampaignSpecTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path file = temporary.path() / "push.toml";

  std::string path(const std::string& text) const {
    std::ofstream(file) << text;
    return file.string();
  }

  static std::string with(std::string text, const std::string& before, const std::string& after) {
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return text.replace(at, before.size(), after);
  }

  // What is said of the file with a line changed.
  std::string refusal(const std::string& before, const std::string& after, long trials = 0) const {
    try {
      plan_campaign(read_campaign_spec(path(with(kLimit, before, after)), {}, trials));
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  std::string at(int line, int column) const {
    return file.string() + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
  }
};

TEST_F(CampaignSpecTest, IsReadAndPlanned) {
  const CampaignSpec spec = read_campaign_spec(path(kLimit), {"gait.stance_s=0.16"}, 0);
  EXPECT_EQ(spec.name, "push");
  ASSERT_EQ(spec.axes.size(), 1U);
  EXPECT_THAT(spec.axes[0].axis.levels, ElementsAre(20.0, 28.3, 40.0, 56.6, 80.0, 113.0, 160.0));
  const CampaignPlan plan = plan_campaign(spec);
  const Campaign& campaign = *plan.batch.campaign;
  ASSERT_EQ(campaign.curves.size(), 2U);
  EXPECT_EQ(plan.batch.cells.size(), 2U * 7U * 3U);
  EXPECT_EQ(campaign.cells.size(), plan.batch.cells.size());
  EXPECT_EQ(campaign.curves[1].key.observer, "momentum");
  EXPECT_EQ(campaign.curves[1].key.overrides, "duration_s=4; gait.stance_s=0.16");
  EXPECT_EQ(plan.trials_per_curve, kDefaultTrials);
  const PlannedCell& last = plan.batch.cells.back();
  EXPECT_EQ(last.key.overrides, "duration_s=4; gait.stance_s=0.16; disturbance.0.amplitude_N=160");
  EXPECT_EQ(last.key.seed, 3);
  EXPECT_EQ(campaign.cells.back().curve, 1U);
  EXPECT_EQ(campaign.cells.back().level[0], 6);
  EXPECT_EQ(plan.batch.scenarios[last.scenario].disturbances.at(0).profile.amplitude_N, 160.0);
  EXPECT_EQ(plan.batch.scenarios[last.scenario].duration, 4.0);
}

TEST_F(CampaignSpecTest, AGridMakesACurveOfEachCombination) {
  const CampaignPlan plan = plan_campaign(read_campaign_spec(
      path(with(kLimit, "seeds = 3\n",
                "seeds = 1\n[grid]\nphase = [\"disturbance.0.phase=0.1\", \"disturbance.0.phase=0.9\"]\n"
                "direction = [\"disturbance.0.direction=[0,1,0]\", \"disturbance.0.direction=[1,0,0]\"]\n")),
      {}, 0));
  ASSERT_EQ(plan.batch.campaign->curves.size(), 8U);
  EXPECT_EQ(plan.batch.campaign->curves[2].key.overrides,
            "duration_s=4; disturbance.0.phase=0.1; disturbance.0.direction=[1,0,0]");
}

TEST_F(CampaignSpecTest, AnAxisOfObserversScalesTheirOwnGains) {
  const std::string text = with(with(kLimit, "kind = \"limit\"", "kind = \"breakdown\""),
                                "set = \"disturbance.0.amplitude_N={}\"\nunit = \"N\"\nfrom = 20\nto = 160\nlevels = 7",
                                "observer_scale = \"gain_scale\"\nfrom = 1\nto = 0.25\nlevels = 3");
  const CampaignPlan plan = plan_campaign(read_campaign_spec(path(text), {}, 0));
  ASSERT_EQ(plan.batch.campaign->curves.size(), 1U);  // none has no such option
  EXPECT_EQ(plan.batch.campaign->curves[0].key.observer, "momentum");
  EXPECT_EQ(plan.batch.cells[0].key.observer, "momentum:gain_scale=24");
  EXPECT_EQ(plan.batch.cells.back().key.observer, "momentum:gain_scale=6");
}

TEST_F(CampaignSpecTest, AFactorialIsEveryPairOfEstimators) {
  const CampaignPlan plan = plan_campaign(read_campaign_spec(
      path("kind = \"factorial\"\nsummary = \"s\"\nscenarios = \"case3/left_10\"\nlegs = [\"none\", \"momentum\"]\n"
           "com = [\"none\", \"com_kalman\"]\nprofile = \"tuned\"\ngains = [\"paper\", \"stiff\"]\nseeds = 2\n"),
      {}, 0));
  const Campaign& campaign = *plan.batch.campaign;
  ASSERT_EQ(campaign.curves.size(), 8U);
  EXPECT_THAT(campaign.factors, ElementsAre("scenario", "leg estimator", "CoM estimator", "gains", "planner"));
  EXPECT_THAT(campaign.curves[0].factors, ElementsAre("case3/left_10", "none", "none", "paper", "zmp"));
  EXPECT_EQ(campaign.curves[0].key.observer, "none");
  EXPECT_THAT(campaign.curves[7].factors, ElementsAre("case3/left_10", "momentum", "com_kalman", "stiff", "zmp"));
  EXPECT_EQ(plan.batch.cells.size(), 16U);
  EXPECT_EQ(campaign_choice(plan).next(std::vector<std::optional<Outcome>>(16)).size(), 16U);
}

TEST_F(CampaignSpecTest, TheBudgetIsDividedAmongTheCurves) {
  const CampaignPlan plan = plan_campaign(read_campaign_spec(path(kLimit), {}, 50));
  EXPECT_EQ(plan.trials_per_curve, 25);
  EXPECT_THAT(read_campaign_spec(file.string(), {}, 50).document, HasSubstr("# --budget 50"));
}

TEST_F(CampaignSpecTest, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_THAT(refusal("kind = \"limit\"", "kind = \"limits\""), HasSubstr(at(1, 1) + "kind: \"limits\""));
  EXPECT_THAT(refusal("seeds = 3", "seeds = 0"), HasSubstr(at(7, 1) + "seeds: 0"));
  EXPECT_THAT(refusal("seeds = 3", "sedes = 3"), AllOf(HasSubstr(at(7, 1)), HasSubstr("did you mean 'seeds'")));
  EXPECT_THAT(refusal("amplitude_N={}", "amplitude={}"),
              AllOf(HasSubstr(at(9, 7)), HasSubstr("axis.amplitude"), HasSubstr("amplitude_N")));
  EXPECT_THAT(refusal("amplitude_N={}", "amplitude_N"), AllOf(HasSubstr(at(10, 1)), HasSubstr("KEY={}, or")));
  EXPECT_THAT(refusal("levels = 7", "levels = 1"), HasSubstr(at(14, 1) + "axis.amplitude.levels: 1"));
  EXPECT_THAT(refusal("to = 160", "to = 20"), HasSubstr("no two levels"));
  EXPECT_THAT(refusal("from = 20", "from = -20"), HasSubstr(at(12, 1)));
  EXPECT_THAT(refusal("\"momentum\"]", "\"momentum\", \"none\"]"), HasSubstr("'none' is there twice"));
  EXPECT_THAT(refusal("\"momentum\"]", "\"momentus\"]"), HasSubstr("momentus"));
  EXPECT_THAT(refusal("case3/left_10", "case9"), AllOf(HasSubstr(at(3, 1)), HasSubstr("case9")));
  EXPECT_THAT(refusal("observers = [\"none\", \"momentum\"]", "observers = []"), HasSubstr(at(4, 1)));
  EXPECT_THAT(refusal("from = 20", "values = []"), HasSubstr(at(12, 1)));
  EXPECT_THAT(refusal("duration_s=4", "duration=4"), AllOf(HasSubstr(at(6, 1)), HasSubstr("duration")));
  EXPECT_THAT(
      refusal("[axis.amplitude]", "[axis.b]\nset = \"gait.stance_s={}\"\nvalues = [0.1, 0.2]\n[axis.amplitude]"),
      HasSubstr("2 axes; allowed: one"));
}

TEST_F(CampaignSpecTest, ATrialThatTwoAxesShareIsRefused) {
  const std::string text = with(with(kLimit, "kind = \"limit\"", "kind = \"breakdown\""), "[axis.amplitude]",
                                "[axis.weak]\nset = \"disturbance.0.amplitude_N={}\"\nvalues = [10, 20]\n"
                                "[axis.amplitude]");
  try {
    plan_campaign(read_campaign_spec(path(text), {}, 0));
    FAIL() << "planned";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(at(12, 7) + "axis.amplitude"), HasSubstr("is there already")));
  }
}

TEST_F(CampaignSpecTest, ABudgetThatCannotBeKeptIsRefused) {
  EXPECT_THAT(refusal("seeds = 3", "seeds = 3", 10), AllOf(HasSubstr("--budget"), HasSubstr("at least 12 for each")));
  EXPECT_THAT(refusal("[axis.amplitude]", "[budget]\ntrials = 100\ntrials_per_curve = 50\n[axis.amplitude]"),
              AllOf(HasSubstr(at(10, 1)), HasSubstr("contradict")));
}

TEST_F(CampaignSpecTest, ABudgetBelowOneTrialACurveIsNotNone) {
  EXPECT_THAT(refusal("seeds = 3", "seeds = 3", 1), AllOf(HasSubstr("1 trials for 2 curves"), HasSubstr("24 in all")));
}

TEST_F(CampaignSpecTest, NamesOfAxesAreWords) {
  EXPECT_THAT(refusal("[axis.amplitude]", "[axis.\"a\\u001b[31m\"]"), HasSubstr("a name of letters"));
  EXPECT_THAT(refusal("[axis.amplitude]", "[axis.\"\"]"), HasSubstr("a name of letters"));
}

TEST_F(CampaignSpecTest, AxesOfAMapSetDifferentKeys) {
  const std::string text = with(with(kLimit, "kind = \"limit\"", "kind = \"map\""), "[axis.amplitude]",
                                "[axis.weak]\nset = \"disturbance.0.amplitude_N={}\"\nvalues = [10, 20]\n"
                                "[axis.amplitude]");
  EXPECT_THROW(read_campaign_spec(path(text), {}, 0), InputError);
}

TEST_F(CampaignSpecTest, EstimatorsOfAFactorialStandOnTheirSide) {
  const auto refused = [&](const std::string& legs, const std::string& com) {
    const std::string text = "kind = \"factorial\"\nsummary = \"s\"\nscenarios = \"case3/left_10\"\nlegs = [" + legs +
                             "]\ncom = [" + com + "]\nprofile = \"tuned\"\nseeds = 2\n";
    try {
      plan_campaign(read_campaign_spec(path(text), {}, 0));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_THAT(refused("\"none\", \"com_wrench\"", "\"none\""), HasSubstr(at(4, 1) + "legs: 'com_wrench'"));
  EXPECT_THAT(refused("\"none\"", "\"none\", \"momentum\""), HasSubstr(at(5, 1) + "com: 'momentum'"));
  EXPECT_THAT(refused("\"none\", \"legs=momentum,com=com_wrench\"", "\"none\""), HasSubstr(at(4, 1) + "legs: "));
  EXPECT_EQ(refused("\"none\", \"eso\"", "\"none\", \"com_eso\""), "nothing");
}

TEST_F(CampaignSpecTest, ShippedCampaignsCanBePlanned) {
  const auto campaigns = list_campaigns();
  ASSERT_FALSE(campaigns.empty());
  for (const auto& [name, summary] : campaigns) {
    EXPECT_FALSE(plan_campaign(read_campaign_spec(name, {}, 0)).batch.cells.empty()) << name;
    EXPECT_FALSE(summary.empty());
  }
}

}  // namespace
}  // namespace dob::campaign_spec_test
