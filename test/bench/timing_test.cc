#include "bench/timing.h"

#include <gtest/gtest.h>

#include "bench/trial.h"
#include "scenarios/loader.h"

namespace dob::timing_test {
namespace {

TEST(Timing, MeasuringTheTicksChangesNoState) {
  const Scenario scenario = load_scenarios({.name = "case1/tip_lateral", .gains = "paper"}).front();
  const ObserverConfig observer = load_observer("momentum_com", "matched");
  Trial plain(scenario, observer, 2), timed(scenario, observer, 2);
  TickClock clock(1000);
  timed.time_ticks(clock);
  int solved = 0;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_TRUE(plain.tick());
    ASSERT_TRUE(timed.tick());
    solved += timed.record().qp_solved ? 1 : 0;
  }
  EXPECT_EQ(plain.model_terms().state.q, timed.model_terms().state.q);
  EXPECT_EQ(plain.model_terms().state.p_WB, timed.model_terms().state.p_WB);
  EXPECT_EQ(clock.tick_us().size(), 1000U);
  EXPECT_EQ(clock.qp_us().size(), static_cast<std::size_t>(solved));
}

TEST(Timing, OnlyTheFirstSeedOfEveryRowIsTimed) {
  BatchRequest request{.scenarios = {"undisturbed"}, .observers = {"none", "momentum"}};
  request.profiles = {"paper"};
  request.first_seed = 3;
  request.last_seed = 5;
  const std::vector<PlannedCell> cells = first_seeds(plan_batch(request));
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].key.seed, 3);
  EXPECT_EQ(cells[1].key.observer, "momentum");
}

}  // namespace
}  // namespace dob::timing_test
