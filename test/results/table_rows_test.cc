#include "results/table_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::table_rows_test {
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

TEST(TableRowsTest, TimingIsOfTheSerialPassOnly) {
  CellResult cell = survived(seed(1), 0.5);
  cell.wall_s = 2.0;  // next to whatever else ran: no measure
  dob::Run run = run_of({cell, survived(seed(2), 0.5), survived(seed(3), 0.5)});
  EXPECT_FALSE(only_row(run).timing);
  run.timings = {{seed(1), 10.0, 20.0, 300.0, 5.0, 8.0, 9.0, 30.0},
                 {seed(2), 11.0, 24.0, 100.0, 6.0, 9.0, 40.0, 20.0},
                 {seed(3), 15.0, 22.0, 200.0, 7.0, 7.0, 7.5, 25.0}};
  const std::optional<TimingSummary> timing = only_row(run).timing;
  ASSERT_TRUE(timing);
  EXPECT_EQ(timing->tick_p50_us, 11.0);
  EXPECT_EQ(timing->tick_p99_us, 22.0);
  EXPECT_EQ(timing->tick_max_us, 300.0);  // the longest of all
  EXPECT_EQ(timing->qp_p50_us, 6.0);
  EXPECT_EQ(timing->qp_p99_us, 8.0);
  EXPECT_EQ(timing->qp_max_us, 40.0);
  EXPECT_EQ(timing->real_time_factor, 25.0);
}

std::vector<std::string> ranking(const dob::Run& run) {
  std::vector<std::string> ranks;
  for (const TableRow& row : build_rows(run, TableOrder::kByScenario)) {
    ranks.push_back(row.key.observer + ":" + (row.rank ? std::to_string(*row.rank) : "-"));
  }
  return ranks;
}

CellKey of(const char* observer, int n = 1) {
  return key("case1", "knee", observer, "paper", n);
}

TEST(TableRanksTest, FewerFallsComeFirstThenTheSmallerComError) {
  EXPECT_THAT(ranking(run_of({survived(of("a"), 0.030), survived(of("b"), 0.010), fell(of("c"), 20.0, 0.001),
                              survived(of("d"), 0.020)})),
              ElementsAre("a:3", "b:1", "c:4", "d:2"));
}

TEST(TableRanksTest, ARowThatLostOneRunOfTwoIsBetweenTheOthersWhateverItsErrors) {
  EXPECT_THAT(ranking(run_of({fell(of("a", 1), 9.0, 0.5), survived(of("a", 2), 0.001), fell(of("b", 1), 9.0, 0.5),
                              fell(of("b", 2), 9.0, 0.5), survived(of("c", 1), 0.9), survived(of("c", 2), 0.9)})),
              ElementsAre("a:2", "b:3", "c:1"));
}

TEST(TableRanksTest, WhereEveryRunFellTheLaterFallIsBetter) {
  EXPECT_THAT(ranking(run_of({fell(of("a"), 5.0, 0.01), fell(of("b"), 25.0, 0.3)})), ElementsAre("a:2", "b:1"));
}

TEST(TableRanksTest, ARunThatCouldNotBeRunCountsAsLost) {
  EXPECT_THAT(ranking(run_of({survived(of("a", 1), 0.001), failed(of("a", 2), "crashed"), survived(of("b", 1), 0.5),
                              survived(of("b", 2), 0.5), failed(of("c", 1), "crashed")})),
              ElementsAre("a:2", "b:1", "c:-"));
}

TEST(TableRanksTest, ASurvivorWithoutACoMErrorHasNoRankAndTakesNone) {
  std::vector<CellResult> cells{survived(of("a"), 0.01), survived(of("b"), 0.0), fell(of("c"), 5.0, 0.01)};
  cells[1].metrics.com_error_max_m = std::nullopt;
  EXPECT_THAT(ranking(run_of(cells)), ElementsAre("a:1", "b:-", "c:2"));
}

TEST(TableRanksTest, OraclesAreBoundsAndTakeNoRank) {
  const dob::Run run = run_of({survived(of("oracle_full"), 0.001), survived(of("momentum"), 0.010),
                               survived(of("oracle_legs"), 0.002), survived(of("none"), 0.020)});
  EXPECT_THAT(ranking(run), ElementsAre("oracle_full:-", "momentum:1", "oracle_legs:-", "none:2"));
  EXPECT_TRUE(build_rows(run, TableOrder::kByScenario)[0].oracle);
  EXPECT_FALSE(build_rows(run, TableOrder::kByScenario)[1].oracle);
}

TEST(TableRanksTest, EqualsShareARankAndEveryBlockHasItsOwn) {
  std::vector<CellResult> cells{survived(of("a"), 0.01), survived(of("b"), 0.01), survived(of("c"), 0.02)};
  cells.push_back(survived(key("case1", "knee", "c", "matched", 1), 0.005));  // profiles compete
  for (auto field : {&CellKey::scenario, &CellKey::variant, &CellKey::gains, &CellKey::planner, &CellKey::overrides}) {
    cells.push_back(survived(of("d"), 0.001));
    cells.back().key.*field = "other";
  }
  EXPECT_THAT(ranking(run_of(cells)),
              ::testing::UnorderedElementsAre("a:2", "b:2", "c:4", "c:1", "d:1", "d:1", "d:1", "d:1", "d:1"));
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
}  // namespace dob::table_rows_test
