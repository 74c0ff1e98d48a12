#include "bench/shard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/input_error.h"

namespace dob::shard_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

BatchPlan plan_of(int cells) {
  BatchPlan plan;
  plan.resolved = {{"s", "duration_s = 1\n"}};
  plan.observers.push_back({{.observer = "none", .profile = "-", .options = {}, .routing = {}}});
  for (int i = 0; i < cells; ++i) {
    CellKey key;
    key.scenario = "s";
    key.seed = i + 1;
    plan.cells.push_back({key, 0, 0, 1});
  }
  return plan;
}

std::vector<int> seeds(const BatchPlan& plan) {
  std::vector<int> seeds;
  for (const PlannedCell& cell : plan.cells) seeds.push_back(cell.key.seed);
  return seeds;
}

TEST(Shard, EveryCellIsInExactlyOne) {
  std::vector<int> all;
  for (int number = 1; number <= 3; ++number) {
    BatchPlan plan = plan_of(8);
    take_shard(plan, {number, 3});
    ASSERT_EQ(plan.ids.size(), plan.cells.size());
    for (std::size_t i = 0; i < plan.ids.size(); ++i) EXPECT_EQ(plan.ids[i], plan.cells[i].key.seed);
    const std::vector<int> part = seeds(plan);
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_THAT(all, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(Shard, KnowsTheWholePlan) {
  BatchPlan one = plan_of(8), two = plan_of(8), whole = plan_of(8), other = plan_of(9);
  take_shard(one, {1, 2});
  take_shard(two, {2, 2});
  take_shard(whole, {1, 1});
  take_shard(other, {1, 2});
  EXPECT_EQ(one.shard.plan, two.shard.plan);
  EXPECT_EQ(one.shard.plan, whole.shard.plan);
  EXPECT_NE(one.shard.plan, other.shard.plan);
  EXPECT_EQ(two.shard.planned, 8U);
  BatchPlan scenario = plan_of(8);
  scenario.resolved[0].toml = "duration_s = 2\n";
  take_shard(scenario, {1, 2});
  EXPECT_NE(one.shard.plan, scenario.shard.plan);
}

TEST(Shard, MoreShardsThanCellsLeaveSomeEmpty) {
  BatchPlan plan = plan_of(2);
  take_shard(plan, {3, 3});
  EXPECT_THAT(plan.cells, IsEmpty());
  EXPECT_EQ(plan.shard.planned, 2U);
}

TEST(Shard, ACurveOfACampaignIsNotDivided) {
  BatchPlan plan = plan_of(6);
  plan.campaign.emplace();
  for (std::size_t i = 0; i < 6; ++i) plan.campaign->cells.push_back({i / 2, {static_cast<int>(i % 2), 0}});
  take_shard(plan, {2, 2});
  EXPECT_THAT(seeds(plan), ElementsAre(3, 4));
  ASSERT_EQ(plan.campaign->cells.size(), 2U);
  EXPECT_EQ(plan.campaign->cells[1].curve, 1U);
  EXPECT_EQ(plan.campaign->cells[1].level[0], 1);
}

TEST(Shard, WhatIsNoShardIsRefused) {
  for (const char* text : {"", "1", "/", "0/4", "5/4", "1/0", "-1/4", "1/4x", "1.5/4", "1/1000000", " 1/4"}) {
    EXPECT_THROW(parse_shard(text), InputError) << text;
  }
  EXPECT_EQ(parse_shard("3/4").number, 3);
  EXPECT_EQ(parse_shard("3/4").count, 4);
}

}  // namespace
}  // namespace dob::shard_test
