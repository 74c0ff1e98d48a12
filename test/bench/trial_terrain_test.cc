// What a trial makes of a field of blocks: where the feet stand, what its seed does, and what is too high.
#include <gtest/gtest.h>

#include "bench/trial.h"
#include "scenarios/loader.h"

namespace dob::trial_terrain_test {
namespace {

// Case 6 over a short time, with one field of equal blocks close before the robot. Its front feet start at 0.287 m.
Scenario over_blocks(double height, double duration) {
  Scenario s = load_scenarios({.name = "case6"}).front();
  s.duration = duration;
  s.block_field = BlockField{
      .start = 0.4, .end = 3.4, .width = 2.0, .tile_x = 1.0, .tile_y = 1.0, .kinds = {{height, 0.8}, {height, 0.8}}};
  return s;
}

TEST(TrialOverBlocks, FrontFeetStandOnThemAndHindFeetStillOnTheGround) {
  const double height = 0.03;
  const Scenario scenario = over_blocks(height, 4.0);
  Trial trial(scenario, load_observer("none", "matched"), 1);
  const auto all_stand = [&trial] {
    const PerLeg<bool>& stance = trial.controller().stance();
    return stance[0] && stance[1] && stance[2] && stance[3];
  };
  while (trial.time() < 3.5 || !all_stand() || trial.controller().gait().footstep_time < 0.1) ASSERT_TRUE(trial.tick());
  ASSERT_LT(trial.time(), 4.5);
  for (const Leg leg : {Leg::kLF, Leg::kRF, Leg::kLH, Leg::kRH}) {
    const Vec3& foot = trial.model_terms().foot[static_cast<std::size_t>(leg)].p;  // centre of its sphere
    const bool front = leg == Leg::kLF || leg == Leg::kRF;
    EXPECT_NEAR(foot.z(), 0.028 + (front ? height : 0.0), 0.0005) << static_cast<int>(leg);
    EXPECT_EQ(foot.x() > 0.4, front);
  }
}

TEST(TrialOverBlocks, BlocksLieWhereTheTrialsSeedPutsThemWhateverTheObserver) {
  Scenario scenario = over_blocks(0.01, 3.0);
  BlockField& field = *scenario.block_field;
  field.tile_x = field.tile_y = 0.1;
  field.kinds[1].height = 0.02;
  Scenario boxes = scenario;
  boxes.block_field.reset();
  const auto hash = [](const Scenario& s, const char* observer) {
    return Trial(s, load_observer(observer, "matched"), 2).run().state_hash;
  };
  const std::uint64_t walked = hash(scenario, "none");
  boxes.terrain.boxes = lay_blocks(field, 2);
  EXPECT_EQ(walked, hash(boxes, "none"));
  // The oracle's truth holds no force here: it walks as without an observer.
  EXPECT_EQ(walked, hash(scenario, "oracle_full"));
  boxes.terrain.boxes = lay_blocks(field, 3);
  EXPECT_NE(walked, hash(boxes, "none"));
}

// Sections 5.8 and 6: obstacles higher than the planned step, 0.05 m, are beyond the method. The robot stays up, but it
// comes no further, which the distance from its path shows.
TEST(TrialOverBlocks, BlocksHigherThanThePlannedStepStopTheRobotWithoutAFall) {
  const auto run = [](double height) {
    return Trial(over_blocks(height, 9.0), load_observer("momentum_com", "matched"), 1).run();
  };
  const CellResult passed = run(0.02);
  EXPECT_EQ(passed.outcome, Outcome::kSurvived);
  EXPECT_LT(passed.metrics.path_error_max_m.value(), 0.1);
  const CellResult stopped = run(0.08);
  EXPECT_EQ(stopped.outcome, Outcome::kSurvived);
  EXPECT_GT(stopped.metrics.path_error_max_m.value(), 0.5);
}

}  // namespace
}  // namespace dob::trial_terrain_test
