#include "results/table_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob {
namespace {

using test::failed;
using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::ElementsAre;
using ::testing::Optional;

constexpr std::size_t kCom = metric_index("com_error_max_m");

CellKey seed(int n) {
  return key("case1", "knee", "momentum", "paper", n);
}

TableRow only_row(const Run& run) {
  const std::vector<TableRow> rows = build_rows(run, TableOrder::kByScenario);
  EXPECT_EQ(rows.size(), 1U);
  return rows.at(0);
}

std::vector<std::string> labels(const Run& run, TableOrder order) {
  std::vector<std::string> names;
  for (const TableRow& row : build_rows(run, order)) {
    names.push_back(row.key.scenario + row.key.variant + ":" + row.key.observer + row.key.profile);
  }
  return names;
}

TEST(TableRowsTest, MetricIsMedianAndWorstOverTheSeeds) {
  const TableRow row = only_row(run_of({survived(seed(1), 0.010), survived(seed(2), 0.030), survived(seed(3), 0.014)}));
  EXPECT_THAT(row.metrics[kCom].median, Optional(0.014));
  EXPECT_THAT(row.metrics[kCom].worst, Optional(0.030));
  EXPECT_FALSE(row.metrics[kCom].ci95);
  EXPECT_EQ(row.seeds, 3);
  EXPECT_EQ(row.runs, 3);
  EXPECT_EQ(row.falls, 0);
  EXPECT_EQ(row.fall_time_median_s, std::nullopt);
}

TEST(TableRowsTest, MetricIsOverTheSeedsThatHaveIt) {
  CellResult with = survived(seed(1), 0.01);
  with.metrics.estimate_rmse_N = 2.0;
  const TableRow row = only_row(run_of({with, survived(seed(2), 0.02)}));
  EXPECT_THAT(row.metrics[metric_index("estimate_rmse_N")].median, Optional(2.0));
  EXPECT_EQ(row.metrics[metric_index("slip_max_m")].median, std::nullopt);
  EXPECT_EQ(row.metrics[metric_index("slip_max_m")].worst, std::nullopt);
}

TEST(TableRowsTest, FallenRunsCountAndStayOutOfTheMetricsOfSurvivors) {
  const TableRow row = only_row(
      run_of({survived(seed(1), 0.010), fell(seed(2), 11.5, 0.9), fell(seed(3), 20.5, 0.8), survived(seed(4), 0.012)}));
  EXPECT_EQ(row.runs, 4);
  EXPECT_EQ(row.falls, 2);
  EXPECT_THAT(row.fall_time_median_s, Optional(16.0));
  EXPECT_THAT(row.metrics[kCom].worst, Optional(0.012));
  EXPECT_FALSE(row.until_fall);
  EXPECT_EQ(row.fall_reason, "trunk tilted");
}

TEST(TableRowsTest, WhenAllFellTheMetricsAreThoseUpToTheFallAndSaySo) {
  const TableRow row = only_row(run_of({fell(seed(1), 10.0, 0.2), fell(seed(2), 12.0, 0.4), failed(seed(3), "crash")}));
  EXPECT_TRUE(row.until_fall);
  EXPECT_THAT(row.metrics[kCom].median, Optional(::testing::DoubleNear(0.3, 1e-15)));
  EXPECT_EQ(row.errors, 1);
}

TEST(TableRowsTest, ErrorsAreCountedWithTheirReasonsAndAreNoRuns) {
  const TableRow row = only_row(
      run_of({failed(seed(3), "timeout"), failed(seed(1), "crash"), failed(seed(2), "crash"), survived(seed(4), 0.5)}));
  EXPECT_EQ(row.errors, 3);
  EXPECT_EQ(row.runs, 1);
  EXPECT_EQ(row.seeds, 4);
  EXPECT_EQ(row.error_reason, "crash; timeout");
  EXPECT_FALSE(row.until_fall);
  EXPECT_THAT(row.metrics[kCom].median, Optional(0.5));
}

TEST(TableRowsTest, CellsThatHaveNotRunAreARowAllTheSame) {
  dob::Run run = run_of({survived(seed(1), 0.5), survived(seed(2), 0.5)});
  run.cells.clear();
  const TableRow row = only_row(run);
  EXPECT_EQ(row.seeds, 2);
  EXPECT_EQ(row.runs, 0);
  EXPECT_FALSE(row.until_fall);
  EXPECT_EQ(row.metrics[metric_index("qp_failures")].median, std::nullopt);
}

TEST(TableRowsTest, IntervalsAppearFromEightSeedsOn) {
  std::vector<CellResult> cells;
  for (int i = 1; i <= 8; ++i) cells.push_back(survived(seed(i), 0.001 * i));
  const TableRow row = only_row(run_of(cells));
  ASSERT_TRUE(row.metrics[kCom].ci95);
  EXPECT_LE(row.metrics[kCom].ci95->low, 0.0045);
  EXPECT_GE(row.metrics[kCom].ci95->high, 0.0045);
  ASSERT_TRUE(row.falls_ci95);
  EXPECT_NEAR(row.falls_ci95->high, 3.841458820694124 / (8.0 + 3.841458820694124), 1e-14);

  cells.pop_back();
  EXPECT_FALSE(only_row(run_of(cells)).falls_ci95);
}

TEST(TableRowsTest, QpFailuresAreAMetricToo) {
  CellResult one = survived(seed(1), 0.5);
  one.metrics.qp_failures = 3;
  const TableRow row = only_row(run_of({one, survived(seed(2), 0.5)}));
  EXPECT_THAT(row.metrics[metric_index("qp_failures")].median, Optional(1.5));
  EXPECT_THAT(row.metrics[metric_index("qp_failures")].worst, Optional(3.0));
}

TEST(TableRowsTest, RealTimeFactorIsSimulatedOverWallTime) {
  CellResult cell = survived(seed(1), 0.5);
  cell.wall_s = 2.0;
  EXPECT_THAT(only_row(run_of({cell, survived(seed(2), 0.5)})).real_time_factor, Optional(23.0));
  EXPECT_EQ(only_row(run_of({survived(seed(2), 0.5)})).real_time_factor, std::nullopt);
}

TEST(TableRowsTest, EveryPartOfTheKeyButTheSeedMakesARow) {
  std::vector<CellResult> cells{survived(seed(1), 1.0), survived(seed(2), 1.0)};
  for (auto field : {&CellKey::scenario, &CellKey::variant, &CellKey::observer, &CellKey::profile, &CellKey::gains,
                     &CellKey::planner, &CellKey::overrides}) {
    cells.push_back(survived(seed(1), 1.0));
    cells.back().key.*field = "other";
  }
  EXPECT_EQ(build_rows(run_of(cells), TableOrder::kByScenario).size(), 8U);
}

TEST(TableRowsTest, OrderIsThatOfTheRun) {
  dob::Run run;
  for (const int n : {1, 2}) {  // seeds outside: rows are ordered by scenario and observer all the same
    for (const char* scenario : {"zebra", "ant"}) {
      for (const char* observer : {"none", "momentum"}) run.info.cells.push_back(key(scenario, "", observer, "-", n));
    }
  }
  EXPECT_THAT(labels(run, TableOrder::kByScenario),
              ElementsAre("zebra:none-", "zebra:momentum-", "ant:none-", "ant:momentum-"));
  EXPECT_THAT(labels(run, TableOrder::kByObserver),
              ElementsAre("zebra:none-", "ant:none-", "zebra:momentum-", "ant:momentum-"));
}

}  // namespace
}  // namespace dob
