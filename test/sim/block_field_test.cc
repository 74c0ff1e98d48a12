// Where the blocks lie, how seeds shuffle them, and what a foot on one of them feels.
#include "sim/block_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/simulator.h"
#include "test/sim/hand_built_robot.h"

namespace dob::block_field_test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// 8 columns by 4 rows. 1.2 / 0.15 is a little less or more than 8 in floating point.
BlockField field() {
  return {.start = 1.2,
          .end = 2.4,
          .width = 0.8,
          .tile_x = 0.15,
          .tile_y = 0.2,
          .kinds = {{0.015, 0.4}, {0.04, 0.6}, {0.02, 0.8}}};
}

using Sort = std::tuple<double, double>;  // height, friction

Sort sort_of(const TerrainBox& block) {
  return {block.size.z(), block.friction};
}

std::vector<Sort> sorts_of(const std::vector<TerrainBox>& blocks) {
  std::vector<Sort> sorts;
  for (const TerrainBox& block : blocks) sorts.push_back(sort_of(block));
  return sorts;
}

TEST(BlockField, FillsItsRectangleWithBlocksThatStandOnThePlaneAndDoNotOverlap) {
  const std::vector<TerrainBox> blocks = lay_blocks(field(), 1);
  ASSERT_EQ(blocks.size(), 32u);
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  double area = 0.0;
  for (const TerrainBox& block : blocks) {
    EXPECT_EQ(block.size.head<2>(), Eigen::Vector2d(0.15, 0.2));
    EXPECT_EQ(block.yaw_rad, 0.0);
    EXPECT_EQ(block.center.z(), 0.5 * block.size.z());
    low = low.cwiseMin(block.center - 0.5 * block.size);
    high = high.cwiseMax(block.center + 0.5 * block.size);
    area += block.size.x() * block.size.y();
  }
  EXPECT_LT((low - Vec3(1.2, -0.4, 0.0)).norm(), 1e-12);
  EXPECT_LT((high - Vec3(2.4, 0.4, 0.04)).norm(), 1e-12);
  EXPECT_NEAR(area, 1.2 * 0.8, 1e-12);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 apart = (blocks[i].center - blocks[j].center).cwiseAbs();
      EXPECT_TRUE(apart.x() > 0.15 - 1e-12 || apart.y() > 0.2 - 1e-12);
    }
  }
}

TEST(BlockField, KindsAlternateInSeedOneSoThatBlocksSharingAnEdgeDiffer) {
  const std::vector<TerrainBox> blocks = lay_blocks(field(), 1);
  const std::vector<Sort> kinds{{0.015, 0.4}, {0.04, 0.6}, {0.02, 0.8}};
  // The first column from the right to the left, then the first block of the next column.
  EXPECT_THAT(sorts_of(blocks), testing::Contains(kinds[0]).Times(11));
  EXPECT_EQ(sort_of(blocks[0]), kinds[0]);
  EXPECT_EQ(sort_of(blocks[1]), kinds[1]);
  EXPECT_EQ(sort_of(blocks[2]), kinds[2]);
  EXPECT_EQ(sort_of(blocks[3]), kinds[0]);
  EXPECT_EQ(sort_of(blocks[4]), kinds[1]);
  EXPECT_LT((blocks[0].center - Vec3(1.275, -0.3, 0.0075)).norm(), 1e-12);
  EXPECT_LT((blocks[4].center - Vec3(1.425, -0.3, 0.02)).norm(), 1e-12);
  int edges = 0;
  for (const TerrainBox& a : blocks) {
    for (const TerrainBox& b : blocks) {
      const Vec3 step = b.center - a.center;
      const bool ahead = std::abs(step.x() - 0.15) < 1e-9 && std::abs(step.y()) < 1e-9;
      const bool beside = std::abs(step.x()) < 1e-9 && std::abs(step.y() - 0.2) < 1e-9;
      if (!ahead && !beside) continue;
      ++edges;
      EXPECT_NE(sort_of(a), sort_of(b));
    }
  }
  EXPECT_EQ(edges, 7 * 4 + 8 * 3);
}

TEST(BlockField, OtherSeedsShuffleTheSameBlocks) {
  const std::vector<Sort> regular = sorts_of(lay_blocks(field(), 1));
  std::set<std::vector<Sort>> layouts{regular};
  for (std::uint64_t seed = 2; seed <= 20; ++seed) {
    const std::vector<TerrainBox> blocks = lay_blocks(field(), seed);
    const std::vector<Sort> sorts = sorts_of(blocks);
    EXPECT_TRUE(std::is_permutation(sorts.begin(), sorts.end(), regular.begin(), regular.end())) << seed;
    EXPECT_EQ(sorts, sorts_of(lay_blocks(field(), seed))) << seed;
    for (const TerrainBox& block : blocks) EXPECT_EQ(block.center.z(), 0.5 * block.size.z());
    layouts.insert(sorts);
  }
  EXPECT_EQ(layouts.size(), 20u);
}

// 4000 shuffles of 4 blocks: each block comes to each place in a quarter of them, with a deviation of 27.
TEST(BlockField, EveryPlaceIsEquallyProbableForEveryBlock) {
  BlockField four = field();
  four.end = four.start + 4.0 * four.tile_x;
  four.width = four.tile_y;
  four.kinds = {{0.01, 0.1}, {0.02, 0.2}, {0.03, 0.3}, {0.04, 0.4}};
  std::array<std::array<int, 4>, 4> counts{};
  constexpr int kShuffles = 4000;
  for (std::uint64_t seed = 2; seed < 2 + kShuffles; ++seed) {
    const std::vector<TerrainBox> blocks = lay_blocks(four, seed);
    for (std::size_t place = 0; place < 4; ++place) {
      const auto kind = static_cast<std::size_t>(std::lround(100.0 * blocks[place].size.z())) - 1;
      ++counts[place][kind];
    }
  }
  for (const auto& of_place : counts) {
    for (const int count : of_place) EXPECT_NEAR(count, kShuffles / 4, 5 * 27);
  }
}

TEST(BlockField, HoldsWholeTilesOnlyAndCentresTheRows) {
  BlockField odd = field();
  odd.end = 1.2 + 2.9 * 0.15;
  odd.width = 0.5;
  const std::vector<TerrainBox> blocks = lay_blocks(odd, 1);
  ASSERT_EQ(blocks.size(), 4u);
  EXPECT_NEAR(blocks[0].center.y(), -0.1, 1e-12);
  EXPECT_NEAR(blocks[1].center.y(), 0.1, 1e-12);
  EXPECT_NEAR(blocks[3].center.x(), 1.2 + 1.5 * 0.15, 1e-12);
}

TEST(BlockField, RefusesWhatIsNoField) {
  const auto refused = [](auto change, const char* says) {
    BlockField wrong = field();
    change(wrong);
    EXPECT_THAT([&] { lay_blocks(wrong, 1); }, ThrowsMessage<std::invalid_argument>(HasSubstr(says)));
  };
  refused([](BlockField& f) { f.end = f.start; }, "end = 1.2, must be finite and at least a tile past start");
  refused([](BlockField& f) { f.width = 0.1; }, "width = 0.1, must be finite and at least that of a tile");
  refused([](BlockField& f) { f.tile_x = 0.0; }, "tile_x = 0, must be finite and > 0");
  refused([](BlockField& f) { f.tile_y = std::nan(""); }, "tile_y = nan");
  refused([](BlockField& f) { f.tile_x = f.tile_y = 1e-5; }, "number of blocks = 9600000000, must be <= 10000");
  refused([](BlockField& f) { f.kinds.clear(); }, "number of kinds = 0, must be at least 1");
  refused([](BlockField& f) { f.kinds[1].height = -0.01; }, "height = -0.01, must be finite and > 0");
  refused([](BlockField& f) { f.kinds[2].friction = -1.0; }, "friction = -1, must be finite and >= 0");
}

class OnAField : public ::testing::Test {
 protected:
  RobotDescription robot = test::hand_built_robot();

  // One tile of this kind below the whole robot; none of the others is reached.
  Terrain tile_below(BlockField::Kind kind) const {
    Terrain terrain;
    const BlockField below{.start = -2.0, .end = 2.0, .width = 4.0, .tile_x = 4.0, .tile_y = 4.0, .kinds = {kind}};
    terrain.boxes = lay_blocks(below, 1);
    return terrain;
  }
};

TEST_F(OnAField, AFootStandsAtTheHeightOfItsBlock) {
  const double height = 0.04;
  RobotState start = test::standing_state(robot, height);
  Simulator simulator(robot, tile_below({height, 0.6}));
  simulator.reset(start);
  StepResult step;
  for (int k = 0; k < 3000; ++k) step = simulator.step(test::hold(start.q, simulator.state()));
  for (int leg = 0; leg < kLegs; ++leg) {
    EXPECT_TRUE(step.foot_contact[static_cast<std::size_t>(leg)]);
    EXPECT_NEAR(test::foot_center(robot, simulator.state(), leg).z(), height + 0.028, 1e-5);
  }
}

// A sled, its joints locked by stops, pushed at the height of its feet with 0.1 + 0.05 of its weight.
TEST_F(OnAField, AFootHasTheFrictionOfItsBlock) {
  const double height = 0.02;
  const RobotState start = test::standing_state(robot, height);
  for (int joint = 0; joint < kJoints; ++joint) {
    auto& stop = robot.legs[static_cast<std::size_t>(joint / 3)].joints[static_cast<std::size_t>(joint % 3)];
    stop.lower = stop.upper = start.q[joint];
  }
  SimOptions locked;
  locked.joint_stops = true;
  const double push = 0.15 * test::mass_of(robot) * kGravity;
  const auto acceleration_on = [&](double friction) {
    Simulator simulator(robot, tile_below({height, friction}), locked);
    simulator.reset(start);
    for (int k = 0; k < 500; ++k) simulator.step(Vec12::Zero());
    const double before = simulator.state().v_WB.x();
    for (int k = 0; k < 100; ++k) {
      const double down = height - simulator.state().p_WB.z();
      const AppliedForce force{.p_L = {0.0, 0.0, down}, .force_W = {push, 0.0, 0.0}};
      simulator.step(Vec12::Zero(), {&force, 1});
    }
    return (simulator.state().v_WB.x() - before) / 0.1;
  };
  EXPECT_LT(acceleration_on(0.2), 1e-4);
  EXPECT_NEAR(acceleration_on(0.1), 0.05 * kGravity, 0.05 * 0.05 * kGravity);
}

}  // namespace
}  // namespace dob::block_field_test
