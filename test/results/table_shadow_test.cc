#include "results/table_shadow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "test/results/run_samples.h"

namespace dob::table_shadow_test {
namespace {

using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::HasSubstr;
using ::testing::Optional;
using ::testing::StartsWith;

CellResult watched(CellResult cell, double own, double shadow) {
  cell.metrics.estimate_rmse_N = own;
  cell.metrics.com_force_rmse_N = 2.0 * own;
  cell.shadows = {{"kalman", "tuned", shadow, {}, {}, {}}, {"none", "-", {}, {}, {}, {}}};
  return cell;
}

dob::Run batch() {
  return run_of({watched(survived(key("case1", "knee", "momentum", "paper", 1), 0.01), 4.0, 1.5),
                 watched(fell(key("case1", "knee", "momentum", "paper", 2), 5.0, 0.01), 6.0, 2.5),
                 survived(key("case1", "knee", "none", "-", 1), 0.01)});
}

TEST(TableShadowTest, ObserverInTheLoopAndItsShadowsAreJudgedOverTheSameRunsFallenOnesIncluded) {
  const std::vector<ShadowRow> rows = build_shadow_rows(batch(), TableOrder::kByScenario);
  ASSERT_EQ(rows.size(), 3U);  // `none` in the loop was not watched
  EXPECT_EQ(rows[0].observer, "momentum");
  EXPECT_TRUE(rows[0].in_loop);
  EXPECT_EQ(rows[0].runs, 2);
  EXPECT_THAT(rows[0].metrics[0].median, Optional(5.0));
  EXPECT_THAT(rows[0].metrics[0].worst, Optional(6.0));
  EXPECT_THAT(rows[0].metrics[2].median, Optional(10.0));
  EXPECT_EQ(rows[1].observer, "kalman");
  EXPECT_EQ(rows[1].profile, "tuned");
  EXPECT_FALSE(rows[1].in_loop);
  EXPECT_EQ(rows[1].runs, 2);
  EXPECT_THAT(rows[1].metrics[0].median, Optional(2.0));
  EXPECT_EQ(rows[1].metrics[1].median, std::nullopt);
  EXPECT_EQ(rows[2].observer, "none");
}

TEST(TableShadowTest, TextNamesTheLoopAndDrawsARuleBelowItsObserver) {
  EXPECT_THAT(render_table(batch(), {.shadow = true}),
              StartsWith(R"(case1 / knee, in the loop momentum (paper): gains paper, planner spline
  observer  profile  runs     force  joints  CoM force  CoM moment
                                [N]   [N m]        [N]       [N m]
  momentum  paper       2     5 / 6       -    10 / 12           -
  ----------------------------------------------------------------
  kalman    tuned       2  2 / 2.50       -          -           -
)"));
}

TEST(TableShadowTest, JsonAndCsvHoldLoopAndShadow) {
  const auto table = nlohmann::json::parse(render_table(batch(), {.format = TableFormat::kJson, .shadow = true}));
  ASSERT_EQ(table.size(), 3U);
  EXPECT_EQ(table[1]["observer"], "momentum");
  EXPECT_EQ(table[1]["profile"], "paper");
  EXPECT_EQ(table[1]["shadow_observer"], "kalman");
  EXPECT_EQ(table[1]["shadow_profile"], "tuned");
  EXPECT_EQ(table[1]["in_loop"], false);
  EXPECT_EQ(table[0]["in_loop"], true);
  EXPECT_EQ(table[1]["runs"], 2);
  EXPECT_EQ(table[1]["estimate_rmse_N"], 2.0);
  EXPECT_EQ(table[1]["estimate_rmse_N_worst"], 2.5);
  EXPECT_EQ(table[1]["estimate_rmse_N_ci95"], nullptr);
  EXPECT_EQ(table[0]["com_force_rmse_N"], 10.0);
  EXPECT_EQ(table[1]["com_moment_rmse_Nm"], nullptr);
  const std::string csv = render_table(batch(), {.format = TableFormat::kCsv, .shadow = true});
  EXPECT_THAT(csv, HasSubstr("\ncase1,knee,momentum,paper,paper,spline,,kalman,tuned,false,2,2.0,2.5,,,"));
}

TEST(TableShadowTest, MarkdownAndLatexAreTablesToo) {
  EXPECT_THAT(render_table(batch(), {.format = TableFormat::kMarkdown, .shadow = true}),
              HasSubstr("| kalman | tuned | 2 | 2 / 2.50 | - | - | - |"));
  EXPECT_THAT(render_table(batch(), {.format = TableFormat::kLatex, .shadow = true}),
              HasSubstr("\\midrule\n{}kalman & tuned & 2 & 2 / 2.50 & - & - & - \\\\\n"));
}

TEST(TableShadowTest, ARunWithoutShadowsSaysSo) {
  try {
    render_table(run_of({survived(key("s", "", "o", "-", 1), 0.1)}), {.shadow = true});
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("--shadow"));
  }
}

}  // namespace
}  // namespace dob::table_shadow_test
