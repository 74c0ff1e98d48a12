#include "results/campaign_blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/campaign_samples.h"

namespace dob::campaign_blocks_test {
namespace {

using test::curve_result;
using test::key;

TEST(CampaignBlocks, ObserversAndProfilesAreComparedAndNothingElse) {
  CellKey stiff = key("case1", "", "momentum", "tuned", 0);
  stiff.gains = "stiff";
  const CampaignResult result =
      test::campaign_of(CampaignKind::kBreakdown, {test::amplitude(), {"delay", "", {0.0, 1.0}, false}},
                        {curve_result(key("case1", "", "momentum", "tuned", 0), {0}, {}),
                         curve_result(key("case1", "", "momentum", "tuned", 0), {1}, {}), curve_result(stiff, {0}, {}),
                         curve_result(key("case1", "", "momentum", "paper", 0), {0}, {}),
                         curve_result(key("case1", "", "none", "-", 0), {0}, {})});
  const std::vector<CampaignBlock> blocks = campaign_blocks(result);
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[0].curves.size(), 3U);
  EXPECT_EQ(blocks[0].curves[1], &result.curves[3]);
  EXPECT_EQ(block_name(blocks[0], result.campaign), "case1, gains paper, planner spline; amplitude [N]");
  EXPECT_EQ(block_name(blocks[1], result.campaign), "case1, gains paper, planner spline; delay");
  EXPECT_EQ(block_name(blocks[2], result.campaign), "case1, gains stiff, planner spline; amplitude [N]");
}

TEST(CampaignBlocks, AMapIsNamedAfterBothAxesAndWhatAllItsCellsHave) {
  CampaignResult result = test::map_result();
  result.curves[0].curve.key.overrides = "duration_s=4";
  const CampaignBlock block = campaign_blocks(result).front();
  EXPECT_EQ(block_name(block, result.campaign),
            "case1/tip_lateral, gains paper, planner spline, set duration_s=4; delay [ms] and bandwidth [rad/s]");
}

}  // namespace
}  // namespace dob::campaign_blocks_test
