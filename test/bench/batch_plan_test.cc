#include "bench/batch_plan.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "scenarios/input_error.h"

namespace dob::batch_plan_test {
namespace {

TEST(BatchPlan, AnObserverWithoutGainsIsRunOnceWhateverTheProfiles) {
  const BatchPlan plan = plan_batch({.scenarios = {"undisturbed"}, .observers = {"none", "momentum"}});
  ASSERT_EQ(plan.cells.size(), 4U);
  EXPECT_EQ(plan.cells[0].key.profile, "-");
  EXPECT_EQ(plan.cells[1].key.profile, "matched");
  EXPECT_EQ(plan.cells[2].key.profile, "paper");
  EXPECT_EQ(plan.cells[3].key.profile, "tuned");
}

TEST(BatchPlan, CellsAreTheProductOfTheAxesAndUnique) {
  BatchRequest request{.scenarios = {"case1", "case1/knee_lateral"}, .observers = {"momentum"}};
  request.profiles = {"paper"};
  request.gains = {"paper", "stiff"};
  request.last_seed = 3;
  const BatchPlan plan = plan_batch(request);
  EXPECT_EQ(plan.cells.size(), 4U * 2U * 3U);
  std::set<CellKey> keys;
  for (const PlannedCell& cell : plan.cells) keys.insert(cell.key);
  EXPECT_EQ(keys.size(), plan.cells.size());
}

TEST(BatchPlan, AScenariosOwnGainsAreRunWithUnlessASetIsAskedFor) {
  BatchRequest request{.scenarios = {"quad12_case1/tip_lateral", "case1/tip_lateral"}, .observers = {"none"}};
  const BatchPlan own = plan_batch(request);
  ASSERT_EQ(own.cells.size(), 2U);
  EXPECT_EQ(own.cells[0].key.gains, "own");
  EXPECT_EQ(own.scenarios[0].controller.wrench_kp[0], 150.0);
  EXPECT_EQ(own.resolved[0].name, "quad12_case1_tip_lateral_own");
  EXPECT_EQ(own.cells[1].key.gains, "paper");
  EXPECT_EQ(own.scenarios[1].controller.wrench_kp[0], 250.0);
  request.gains = {"own", "paper"};  // of case 1 both are the same cell
  const BatchPlan both = plan_batch(request);
  ASSERT_EQ(both.cells.size(), 3U);
  EXPECT_EQ(both.cells[0].key.gains, "own");
  EXPECT_EQ(both.cells[1].key.gains, "paper");
  EXPECT_EQ(both.scenarios[both.cells[1].scenario].controller.wrench_kp[0], 250.0);
  EXPECT_EQ(both.scenarios[both.cells[1].scenario].robot.urdf.filename(), "quad12.urdf");
}

TEST(BatchPlan, ASpecificationsOptionsMakeARowOfTheirOwn) {
  BatchRequest request{.scenarios = {"undisturbed"}, .observers = {"momentum", "momentum:gain_scale=5"}};
  request.profiles = {"paper"};
  const BatchPlan plan = plan_batch(request);
  ASSERT_EQ(plan.cells.size(), 2U);
  EXPECT_EQ(plan.cells[1].key.observer, "momentum:gain_scale=5");
  EXPECT_EQ(plan.observers[plan.cells[1].observer].observer.observer, "momentum");
}

TEST(BatchPlan, TheLargestSeedIsASeedAndTooManyCellsAreRefusedBeforeTheyAreMade) {
  BatchRequest request{.scenarios = {"undisturbed"}, .observers = {"none", "momentum"}, .profiles = {"paper"}};
  request.first_seed = request.last_seed = std::numeric_limits<int>::max();
  EXPECT_EQ(plan_batch(request).cells.size(), 2U);
  for (const int seeds : {500'001, std::numeric_limits<int>::max()}) {
    request.first_seed = 1;
    request.last_seed = seeds;
    try {
      plan_batch(request);
      FAIL() << "accepted";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("--seeds: ")) << error.what();
      EXPECT_NE(std::string(error.what()).find("allowed: 1000000 cells"), std::string::npos) << error.what();
    }
  }
}

TEST(BatchPlan, WarnsOnceOfADisturbanceThatNeverActs) {
  BatchRequest request{.scenarios = {"push_trunk"}, .observers = {"none"}};
  request.gains = {"paper", "stiff"};
  EXPECT_TRUE(plan_batch(request).warnings.empty());
  request.overrides = {"duration_s=3.1"};  // the push begins at 3 s
  EXPECT_TRUE(plan_batch(request).warnings.empty());
  request.last_seed = 2;  // and 0.265 s later in the worst case
  const std::vector<std::string> warnings = plan_batch(request).warnings;
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("push_trunk.toml:12:1: disturbance.0.start_s"), std::string::npos) << warnings[0];
  EXPECT_EQ(std::set<std::string>(warnings.begin(), warnings.end()).size(), warnings.size());
}

std::set<std::string> scenarios_of(const BatchPlan& plan) {
  std::set<std::string> names;
  for (const PlannedCell& cell : plan.cells) names.insert(cell.key.scenario);
  return names;
}

std::set<std::string> observers_of(const BatchPlan& plan, const std::string& scenario) {
  std::set<std::string> names;
  for (const PlannedCell& cell : plan.cells) {
    if (cell.key.scenario == scenario) names.insert(cell.key.observer);
  }
  return names;
}

std::size_t cells_of(const BatchPlan& plan, const std::string& scenario) {
  return static_cast<std::size_t>(std::count_if(plan.cells.begin(), plan.cells.end(),
                                                [&](const PlannedCell& c) { return c.key.scenario == scenario; }));
}

TEST(BatchPlan, WithoutAScenarioIsThePapersSetAndNothingElse) {
  const BatchPlan plan = plan_batch({.observers = {"none"}, .profiles = {"paper"}});
  const std::set<std::string> names = scenarios_of(plan);
  for (const char* name : {"order_study", "case1", "case1_no_swing", "case3", "case4", "case4_noise", "case5", "case6"})
    EXPECT_TRUE(names.contains(name));
  for (const char* name : {"case2", "undisturbed", "crawl", "push_trunk", "chirp_knee"})
    EXPECT_FALSE(names.contains(name)) << name;
  // Case 2 brings its three observers into case 1, whose cells it shares; the others run what was asked for.
  EXPECT_EQ(observers_of(plan, "case1"), (std::set<std::string>{"none", "momentum", "com_wrench", "nonlinear_dob"}));
  EXPECT_EQ(observers_of(plan, "case3"), std::set<std::string>{"none"});
  std::set<CellKey> keys;
  for (const PlannedCell& cell : plan.cells) keys.insert(cell.key);
  EXPECT_EQ(keys.size(), plan.cells.size());
  std::set<std::string> files;
  for (const ResolvedScenario& file : plan.resolved) files.insert(file.name);
  EXPECT_EQ(files.size(), plan.resolved.size());
}

// Two variants, eleven observers, one profile that they are meant for.
TEST(BatchPlan, AScenarioAboutCertainObserversRunsWithThoseAndOncePerObserver) {
  EXPECT_EQ(cells_of(plan_batch({.observers = {"none"}}), "order_study"), 2U * 11U);
  EXPECT_EQ(plan_batch({.scenarios = {"order_study"}}).cells.size(), 2U * 11U);
  const BatchPlan asked =
      plan_batch({.scenarios = {"order_study"}, .observers = {"momentum"}, .profiles = {"matched"}});
  ASSERT_EQ(asked.cells.size(), 2U);
  EXPECT_EQ(asked.cells[0].key.observer, "momentum");
  EXPECT_EQ(asked.cells[0].key.profile, "matched");
}

TEST(BatchPlan, CellsOfCase2AreThoseOfCase1) {
  const BatchPlan plan = plan_batch({.scenarios = {"case2"}, .profiles = {"paper"}});
  EXPECT_EQ(scenarios_of(plan), std::set<std::string>{"case1"});
  EXPECT_EQ(plan.cells.size(), 4U * 3U);
  const BatchPlan both = plan_batch({.scenarios = {"case1", "case2/knee_lateral"}, .observers = {"none"}});
  EXPECT_EQ(both.cells.size(), 4U);
}

TEST(BatchPlan, APoseThatTheLegsCannotReachIsRefusedBeforeAnythingRuns) {
  BatchRequest request{.scenarios = {"undisturbed"}, .observers = {"none"}};
  request.overrides = {"planner.com_height_m=0.9"};
  try {
    plan_batch(request);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("LF"), std::string::npos) << error.what();
  }
}

TEST(BatchPlan, AListOfSpecificationsIsSplitBetweenObserversNotBetweenTheirOptions) {
  using List = std::vector<std::string>;
  EXPECT_EQ(split_specifications("momentum,com_wrench"), (List{"momentum", "com_wrench"}));
  EXPECT_EQ(split_specifications("momentum:gain_scale=5,routing.swing_31=off,direct"),
            (List{"momentum:gain_scale=5,routing.swing_31=off", "direct"}));
  EXPECT_EQ(split_specifications("none,legs=momentum,com=com_wrench,legs.gain_scale=5,eso:a=1"),
            (List{"none", "legs=momentum,com=com_wrench,legs.gain_scale=5", "eso:a=1"}));
  EXPECT_EQ(split_specifications("momentum,"), (List{"momentum", ""}));
}

TEST(BatchPlan, ShadowsWatchEveryCellInTheFirstProfileAskedForButNeverThemselves) {
  BatchRequest request{.scenarios = {"undisturbed"}, .observers = {"none", "momentum"}};
  request.shadows = {"momentum", "com_wrench", "momentum"};
  request.profiles = {"paper", "matched"};
  const BatchPlan plan = plan_batch(request);
  ASSERT_EQ(plan.cells.size(), 3U);
  const auto labels = [&plan](const PlannedCell& cell) {
    std::vector<std::string> names;
    for (const ObserverConfig& shadow : plan.observers[cell.observer].shadows)
      names.push_back(shadow.label + "/" + shadow.profile);
    return names;
  };
  using List = std::vector<std::string>;
  EXPECT_EQ(labels(plan.cells[0]), (List{"momentum/paper", "com_wrench/paper"}));
  EXPECT_EQ(labels(plan.cells[1]), (List{"com_wrench/paper"}));                    // momentum (paper)
  EXPECT_EQ(labels(plan.cells[2]), (List{"momentum/paper", "com_wrench/paper"}));  // momentum (matched)
  request.shadows = {"nonsense"};
  EXPECT_THROW(plan_batch(request), InputError);
}

}  // namespace
}  // namespace dob::batch_plan_test
