#include "bench/batch_plan.h"

#include <set>

#include <gtest/gtest.h>

#include "scenarios/input_error.h"

namespace dob {
namespace {

TEST(BatchPlan, AnObserverWithoutGainsIsRunOnceWhateverTheProfiles) {
  const BatchPlan plan = plan_batch({.scenarios = {"undisturbed"}, .observers = {"none", "momentum"}});
  ASSERT_EQ(plan.cells.size(), 3U);
  EXPECT_EQ(plan.cells[0].key.profile, "-");
  EXPECT_EQ(plan.cells[1].key.profile, "matched");
  EXPECT_EQ(plan.cells[2].key.profile, "paper");
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

TEST(BatchPlan, ASpecificationsOptionsMakeARowOfTheirOwn) {
  BatchRequest request{.scenarios = {"undisturbed"}, .observers = {"momentum", "momentum:gain_scale=5"}};
  request.profiles = {"paper"};
  const BatchPlan plan = plan_batch(request);
  ASSERT_EQ(plan.cells.size(), 2U);
  EXPECT_EQ(plan.cells[1].key.observer, "momentum:gain_scale=5");
  EXPECT_EQ(plan.cells[1].observer.observer, "momentum");
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
  const auto labels = [](const PlannedCell& cell) {
    std::vector<std::string> names;
    for (const ObserverConfig& shadow : cell.shadows) names.push_back(shadow.label + "/" + shadow.profile);
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
}  // namespace dob
