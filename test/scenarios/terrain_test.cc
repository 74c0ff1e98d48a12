// The terrain in a scenario's file: the field of blocks of case study 6, and how a wrong one is refused.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::terrain_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kSpan = "[terrain.field]\nstart_m = 1.0\nend_m = 2.0\nwidth_m = 0.6\n";
const std::string kTile = "tile_m = [0.1, 0.2]\n";
const std::string kHeights = "heights_m = [0.01, 0.02]\n";
const std::string kFrictions = "frictions = [0.5, 0.7]\n";

TEST(TerrainField, IsReadWithItsKindsInPairs) {
  const ScratchFiles files;
  const std::string file = files.write("mine.toml", kSmallest + kSpan + kTile + kHeights + kFrictions);
  const BlockField field = load_scenarios({.name = file}).at(0).block_field.value();
  EXPECT_EQ(field.start, 1.0);
  EXPECT_EQ(field.end, 2.0);
  EXPECT_EQ(field.width, 0.6);
  EXPECT_EQ(field.tile_x, 0.1);
  EXPECT_EQ(field.tile_y, 0.2);
  ASSERT_EQ(field.kinds.size(), 2u);
  EXPECT_EQ(field.kinds[1].height, 0.02);
  EXPECT_EQ(field.kinds[1].friction, 0.7);
}

TEST(TerrainField, MayBeMissingAndIsThenNotThere) {
  EXPECT_FALSE(load_scenarios({.name = "undisturbed"}).at(0).block_field.has_value());
}

TEST(TerrainField, OfAThousandMillionTilesIsRefusedWhereItIsWritten) {
  EXPECT_EQ(error_with(kSpan + "tile_m = [2e-5, 3e-5]\n" + kHeights + kFrictions),
            "mine.toml:9:1: terrain.field.tile_m: [2e-05, 3e-05]; "
            "allowed: at most 10000 blocks in the field, these are 1e+09");
  EXPECT_THAT(error_with(kSpan + "tile_m = [1e-300, 1e-300]\n" + kHeights + kFrictions),
              HasSubstr("mine.toml:9:1: terrain.field.tile_m: [1e-300, 1e-300]; allowed: at most 10000 blocks"));
}

TEST(TerrainField, OfExactlyTheMostBlocksIsAllowed) {
  EXPECT_EQ(error_with(kSpan + "tile_m = [0.01, 0.006]\n" + kHeights + kFrictions), "no error");
}

TEST(TerrainField, HasAsManyFrictionsAsHeights) {
  EXPECT_EQ(error_with(kSpan + kTile + kHeights + "frictions = [0.5]\n"),
            "mine.toml:11:1: terrain.field.frictions: [0.5]; allowed: as many numbers as heights_m has, 2");
  EXPECT_EQ(error_with(kSpan + kTile + "heights_m = []\n" + kFrictions),
            "mine.toml:10:1: terrain.field.heights_m: []; allowed: a list of numbers, each above 0 to 1");
  EXPECT_EQ(error_with(kSpan + kTile + "heights_m = [0.01, -0.02]\n" + kFrictions),
            "mine.toml:10:1: terrain.field.heights_m: [0.01, -0.02]; allowed: a list of numbers, each above 0 to 1");
  EXPECT_EQ(error_with(kSpan + kTile + kHeights + "frictions = [0.5, nan]\n"),
            "mine.toml:11:1: terrain.field.frictions: [0.5, nan]; allowed: a list of numbers, each from 0 to 10");
}

TEST(TerrainField, HoldsAtLeastOneTile) {
  EXPECT_EQ(error_with(kSpan + "tile_m = [1.5, 0.2]\n" + kHeights + kFrictions),
            "mine.toml:9:1: terrain.field.tile_m: [1.5, 0.2]; allowed: at most the field's 1 by 0.6");
  EXPECT_EQ(error_with(kSpan + "tile_m = [0.1, 0.2, 0.3]\n" + kHeights + kFrictions),
            "mine.toml:9:1: terrain.field.tile_m: [0.1, 0.2, 0.3]; allowed: two numbers, along x and along y");
  EXPECT_EQ(error_with("[terrain.field]\nstart_m = 1.0\nend_m = 1.0\nwidth_m = 0.6\n" + kTile + kHeights + kFrictions),
            "mine.toml:7:1: terrain.field.end_m: 1; allowed: a number above start_m, 1");
}

TEST(TerrainField, NeedsEveryKeyAndKnowsNoOthers) {
  EXPECT_EQ(error_with(kSpan + kHeights + kFrictions),
            "mine.toml:5:10: terrain.field.tile_m: missing; the key is needed here");
  EXPECT_EQ(error_with(kSpan + kTile + "heights = [0.01]\n" + kFrictions),
            "mine.toml:10:1: terrain.field.heights: unknown key 'heights'; did you mean 'heights_m'?");
  EXPECT_THAT(error_with("[terrain.fields]\nstart_m = 1.0\n"), HasSubstr("did you mean 'field'?"));
}

TEST(Case6, WalksStraightOverThePapersBlocksUntilOneMetrePastThem) {
  const Scenario s = load_scenarios({.name = "case6"}).at(0);
  ASSERT_EQ(s.path.size(), 1u);
  EXPECT_EQ(s.path[0].speed, 0.12);
  EXPECT_EQ(s.path[0].yaw_rate, 0.0);
  const BlockField field = s.block_field.value();
  EXPECT_EQ(field.start, 1.2);
  EXPECT_EQ(field.end, 2.4);
  // The start ramp of 0.5 s costs half of what it would have walked meanwhile.
  EXPECT_NEAR(s.path[0].speed * (s.duration - 0.25), field.end + 1.0, 0.01);
  EXPECT_EQ(field.columns() * field.rows(), 32);
  std::vector<double> heights, frictions;
  for (const BlockField::Kind& kind : field.kinds) {
    heights.push_back(kind.height);
    frictions.push_back(kind.friction);
  }
  EXPECT_THAT(heights, ElementsAre(0.015, 0.04, 0.02));
  EXPECT_THAT(frictions, ElementsAre(0.4, 0.6, 0.8));
  EXPECT_EQ(s.terrain.ground_friction, 1.0);
  EXPECT_EQ(s.controller.friction, 0.4);
  EXPECT_EQ(s.planner.swing.step_height, 0.05);
  EXPECT_TRUE(s.disturbances.empty() && s.random_pushes.empty());
}

TEST(BlockHeightSweep, IsCase6WithBlocksOfOneHeight) {
  const Scenario case6 = load_scenarios({.name = "case6"}).at(0);
  std::vector<std::string> names;
  for (const Scenario& s : load_scenarios({.name = "block_height_sweep"})) {
    names.push_back(s.variant);
    const double height = 0.01 * std::stoi(s.variant.substr(2));
    const BlockField field = s.block_field.value();
    ASSERT_EQ(field.kinds.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(field.kinds[k].height, height, 1e-12) << s.variant;
      EXPECT_EQ(field.kinds[k].friction, case6.block_field->kinds[k].friction);
    }
    EXPECT_EQ(field.end, case6.block_field->end);
    EXPECT_EQ(s.duration, case6.duration);
    EXPECT_EQ(s.controller.friction, case6.controller.friction);
  }
  EXPECT_THAT(names, ElementsAre("h_01", "h_02", "h_03", "h_04", "h_05", "h_06", "h_08"));
}

TEST(FrictionSweep, IsCase4OnGroundThatTheControllerKnowsOrTakesFor04) {
  const Scenario case4 = load_scenarios({.name = "case4"}).at(0);
  std::vector<std::string> names;
  for (const Scenario& s : load_scenarios({.name = "friction_sweep"})) {
    names.push_back(s.variant);
    const double friction = 0.1 * std::stoi(s.variant.substr(3));
    EXPECT_NEAR(s.terrain.ground_friction, friction, 1e-12);
    EXPECT_EQ(s.controller.friction, s.variant.ends_with("_unknown") ? 0.4 : s.terrain.ground_friction);
    ASSERT_EQ(s.random_pushes.size(), 1u);
    EXPECT_EQ(s.random_pushes[0].max_N, case4.random_pushes[0].max_N);
    EXPECT_EQ(s.duration, case4.duration);
    EXPECT_FALSE(s.block_field.has_value());
  }
  EXPECT_THAT(names,
              ElementsAre("mu_02", "mu_03", "mu_04", "mu_06", "mu_08", "mu_10", "mu_02_unknown", "mu_03_unknown"));
}

}  // namespace
}  // namespace dob::terrain_test
