#include "bench/batch_plan.h"

#include <set>

#include <gtest/gtest.h>

#include "scenarios/input_error.h"

namespace dob {
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

}  // namespace
}  // namespace dob
