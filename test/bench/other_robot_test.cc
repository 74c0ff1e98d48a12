// A robot of another make, by the keys of its scenarios alone: nothing here or below knows anything about it.
#include <algorithm>

#include <gtest/gtest.h>

#include "bench/trial.h"
#include "scenarios/loader.h"

namespace dob::other_robot_test {
namespace {

Scenario load(const std::string& name, double duration) {
  Scenario s = load_scenarios({.name = name}).front();
  s.duration = duration;
  return s;
}

// The bounds of DogBot's undisturbed trot (trial_test.cc).
TEST(OtherRobot, TrotsWithItsOwnGainsAsDogBotDoes) {
  const Scenario scenario = load("quad12_undisturbed", 5.0);
  EXPECT_EQ(scenario.controller.torque_limit, 33.5);
  Trial trial(scenario, load_observer("none", "paper"), 1);
  EXPECT_NEAR(trial.model_terms().mass, 12.776, 1e-9);
  const CellResult result = trial.run();
  EXPECT_EQ(result.outcome, Outcome::kSurvived) << result.reason;
  EXPECT_LE(result.metrics.com_error_max_m.value(), 0.002);
  EXPECT_LE(result.metrics.foot_error_max_m.value(), 0.003);
  EXPECT_EQ(result.metrics.qp_failures, 0);
}

// Without a force an observer of the right model has nothing to see.
TEST(OtherRobot, ItsModelAgreesWithItsSimulation) {
  Trial trial(load("quad12_undisturbed", 2.0), load_observer("momentum", "matched"), 1);
  double largest = 0.0;  // [N m]
  const CellResult result = trial.run([&](const TickRecord& record) {
    if (record.t > 0.5) largest = std::max(largest, trial.estimate().leg_torque.cwiseAbs().maxCoeff());
  });
  EXPECT_EQ(result.outcome, Outcome::kSurvived);
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(largest, 0.3);  // of the 12.8 N m that its weight puts on a knee at 0.1 m
}

TEST(OtherRobot, FallsUnderAForceOnItsKneeThatItsObserverLetsItWalkUnder) {
  const Scenario scenario = load("quad12_case1/knee_sagittal", 6.0);
  EXPECT_EQ(Trial(scenario, load_observer("none", "matched"), 1).run().outcome, Outcome::kFell);
  const CellResult seen = Trial(scenario, load_observer("momentum_com", "tuned"), 1).run();
  EXPECT_EQ(seen.outcome, Outcome::kSurvived) << seen.reason;
  EXPECT_LE(seen.metrics.com_error_max_m.value(), 0.005);
}

}  // namespace
}  // namespace dob::other_robot_test
