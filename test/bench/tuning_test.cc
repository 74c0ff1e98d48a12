#include "bench/tuning.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "observers/factory.h"
#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::tuning_test {
namespace {

const std::vector<TuningParameter> kSpace{{"gain_scale", TuningRange{4.0, 60.0}},
                                          {"routing.swing_31", std::vector<std::string>{"projected", "direct"}}};

TEST(Tuning, CandidatesStartWithTheProfileAndAreTheSameForALargerBudget) {
  const auto few = tuning_candidates("momentum", kSpace, 5);
  const auto many = tuning_candidates("momentum", kSpace, 50);
  ASSERT_EQ(few.size(), 5U);
  EXPECT_EQ(few[0], "momentum");
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i], many[i]);
  int direct = 0;
  for (std::size_t i = 1; i < many.size(); ++i) {
    const ObserverConfig config = load_observer(many[i], "matched");  // every candidate is a valid observer
    const double scale = std::get<double>(config.options.at("gain_scale"));
    EXPECT_GE(scale, 4.0);
    EXPECT_LE(scale, 60.0);
    direct += config.routing.swing_31 == Routing::Swing::kDirect ? 1 : 0;
  }
  EXPECT_GT(direct, 10);
  EXPECT_LT(direct, 40);
}

TEST(Tuning, EveryObserverHasASpaceThatDrawsObserversThatCanBeMade) {
  int spaces = 0;
  for (const ObserverInfo& info : built_in_observers()) {
    if (info.oracle || !(info.estimates_legs || info.estimates_com)) continue;
    const std::string observer(info.name);
    for (const std::string& candidate : tuning_candidates(observer, load_tuning_space(observer), 30)) {
      EXPECT_NO_THROW(load_observer(candidate, load_tuning_procedure().profile)) << candidate;
    }
    ++spaces;
  }
  EXPECT_EQ(spaces, 14);
  EXPECT_THROW(load_tuning_space("none"), InputError);
}

CellResult cell(const std::string& observer, Outcome outcome, double com, double seconds = 20.0) {
  CellResult c;
  c.key.observer = observer;
  c.outcome = outcome;
  c.simulated_s = seconds;
  c.metrics.com_error_max_m = com;
  c.metrics.foot_error_max_m = 0.035;
  return c;
}

TEST(Tuning, OneFallRanksBehindEverySurvivorHoweverLargeItsErrors) {
  const TuningProcedure p = load_tuning_procedure();
  const std::vector<CellResult> cells{cell("a", Outcome::kSurvived, 0.9),   cell("a", Outcome::kSurvived, 0.9),
                                      cell("b", Outcome::kSurvived, 0.001), cell("b", Outcome::kFell, 0.001, 19.9),
                                      cell("c", Outcome::kSurvived, 0.001), cell("c", Outcome::kError, 0.0, 0.0)};
  const TuningResult a = judge("a", cells, p), b = judge("b", cells, p), c = judge("c", cells, p);
  EXPECT_EQ(a.falls, 0);
  EXPECT_EQ(b.falls, 1);
  EXPECT_EQ(c.falls, 1);
  EXPECT_TRUE(a.better_than(b));
  EXPECT_FALSE(b.better_than(a));
  EXPECT_TRUE(b.better_than(c));  // lasted longer
  EXPECT_NEAR(a.score, 0.9 / 0.010 + 1.0, 1e-12);
}

TEST(Tuning, ATunedProfileReadsBackAsTheObserversItWasMadeOf) {
  const ObserverConfig one = load_observer("momentum_com:legs.gain_scale=7.5,routing.swing_31=direct", "matched");
  const ScratchFiles files;
  const std::filesystem::path profiles = files.directory() / "config" / "profiles";
  std::filesystem::create_directories(profiles);
  std::ofstream(profiles / "tuned.toml") << profile_toml({one}, "matched");
  ::setenv("DOBBENCH_SCENARIOS", files.directory().c_str(), 1);
  const ObserverConfig back = load_observer("momentum_com", "tuned");
  const ObserverConfig pair = load_observer("legs=kalman,com=com_eso", "tuned");
  ::unsetenv("DOBBENCH_SCENARIOS");
  const Routing of_pairs = load_observer("legs=kalman,com=com_eso", "matched").routing;
  EXPECT_EQ(pair.routing.dynamics_18, of_pairs.dynamics_18);
  EXPECT_EQ(pair.routing.swing_31, of_pairs.swing_31);
  EXPECT_EQ(back.options, one.options);
  EXPECT_EQ(back.routing.swing_31, Routing::Swing::kDirect);
  EXPECT_EQ(back.routing.dynamics_18, one.routing.dynamics_18);
  EXPECT_EQ(back.routing.wrench_source, one.routing.wrench_source);
}

}  // namespace
}  // namespace dob::tuning_test
