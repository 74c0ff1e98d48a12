#include "results/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::compare_test {
namespace {

using test::checkpoint;
using test::failed;
using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Optional;

constexpr MetricField kCom = kMetricFields[metric_index("com_error_max_m")];
constexpr MetricField kSlip = kMetricFields[metric_index("slip_max_m")];

CellResult walked(int seed, double com) {
  CellResult cell = survived(key("s", "", "o", "-", seed), com);
  cell.checkpoints = {checkpoint(1.0, 0.5 * com), checkpoint(2.0, com)};
  cell.metrics.slip_max_m = com;
  return cell;
}

CellResult fallen(int seed, double com_before) {
  CellResult cell = fell(key("s", "", "o", "-", seed), 1.4, 0.9);
  cell.checkpoints = {checkpoint(1.0, com_before), checkpoint(1.399, 0.9)};
  return cell;
}

dob::Run run_with(const std::vector<double>& com) {
  std::vector<CellResult> cells;
  for (std::size_t i = 0; i < com.size(); ++i) cells.push_back(walked(static_cast<int>(i) + 1, com[i]));
  return run_of(cells);
}

ComparedRow only_row(const dob::Run& a, const dob::Run& b, const MetricField& metric = kCom) {
  const Comparison comparison = compare_runs(a, b, metric);
  EXPECT_EQ(comparison.rows.size(), 1U);
  EXPECT_EQ(comparison.regression(), !comparison.rows.at(0).regression.empty());
  return comparison.rows.at(0);
}

TEST(CompareTest, ARunEqualsItself) {
  const dob::Run run = run_of({walked(1, 0.01), fallen(2, 0.02), failed(key("s", "", "o", "-", 3), "crash")});
  const ComparedRow row = only_row(run, run);
  EXPECT_EQ(row.regression, "");
  EXPECT_EQ(row.cells, 3);
  EXPECT_EQ(row.falls_a, 1);
  EXPECT_EQ(row.errors_b, 1);
  EXPECT_EQ(row.difference.pairs, 2);
  EXPECT_THAT(row.difference.median, Optional(0.0));
}

TEST(CompareTest, DifferenceIsBMinusASeedBySeed) {
  EXPECT_THAT(only_row(run_with({0.01, 0.05, 0.09}), run_with({0.02, 0.01, 0.06})).difference.median,
              Optional(DoubleNear(-0.03, 1e-15)));
}

TEST(CompareTest, MoreFallsAreARegressionWhateverTheErrors) {
  const ComparedRow row = only_row(run_with({0.01, 0.01}), run_of({walked(1, 0.001), fallen(2, 0.001)}));
  EXPECT_EQ(row.regression, "more falls");
  EXPECT_THAT(row.difference.median, Optional(DoubleNear((-0.009 - 0.004) / 2.0, 1e-15)));  // seed 2 up to 1 s
  EXPECT_EQ(only_row(run_of({walked(1, 0.001), fallen(2, 0.001)}), run_with({0.001, 0.002})).regression, "");
}

TEST(CompareTest, MoreErrorsAreARegression) {
  EXPECT_EQ(only_row(run_with({0.01}), run_of({failed(key("s", "", "o", "-", 1), "crash")})).regression,
            "more cells could not be run");
}

TEST(CompareTest, AFewPairsAreARegressionWhenEveryOneIsWorseByMoreThanFivePercent) {
  EXPECT_THAT(only_row(run_with({0.010, 0.020}), run_with({0.0106, 0.0212})).regression, HasSubstr("every run"));
  EXPECT_EQ(only_row(run_with({0.010, 0.020}), run_with({0.0104, 0.9})).regression, "");
  EXPECT_EQ(only_row(run_with({0.010, 0.020}), run_with({0.009, 0.9})).regression, "");
}

TEST(CompareTest, ManyPairsAreARegressionWhenTheIntervalLiesAboveZero) {
  const std::vector<double> ones(8, 0.010);
  EXPECT_THAT(only_row(run_with(ones), run_with(std::vector<double>(8, 0.0101))).regression, HasSubstr("interval"));
  EXPECT_EQ(only_row(run_with(ones), run_with(std::vector<double>(8, 0.0099))).regression, "");
  // Half of them better, half of them worse: the interval holds zero.
  EXPECT_EQ(only_row(run_with(ones), run_with({0.02, 0.02, 0.02, 0.02, 0.001, 0.001, 0.001, 0.001})).regression, "");
}

TEST(CompareTest, AMetricWithoutCheckpointsIsComparedOverPairsThatSurvived) {
  const dob::Run a = run_with({0.010, 0.020});
  const dob::Run b = run_of({walked(1, 0.030), fallen(2, 0.5)});
  EXPECT_EQ(only_row(a, b, kSlip).difference.pairs, 1);
  EXPECT_THAT(only_row(a, b, kSlip).difference.median, Optional(DoubleNear(0.020, 1e-15)));
  EXPECT_EQ(only_row(a, b, kCom).difference.pairs, 2);
}

TEST(CompareTest, RowsOfOneRunOnlyAreNamedAndNoRegression) {
  dob::Run a = run_with({0.01}), b = run_with({0.01});
  a.cells.push_back(survived(key("gone", "knee", "o", "-", 1), 0.01));
  a.info.cells.push_back(a.cells.back().key);
  b.cells.push_back(survived(key("s", "", "new", "-", 1), 0.01));
  b.info.cells.push_back(b.cells.back().key);
  const Comparison comparison = compare_runs(a, b, kCom);
  ASSERT_EQ(comparison.only_a.size(), 1U);
  ASSERT_EQ(comparison.only_b.size(), 1U);
  EXPECT_FALSE(comparison.regression());
  const std::string text = comparison_text(comparison);
  EXPECT_THAT(text, HasSubstr("! only in A: gone / knee, o (-): gains paper, planner spline\n"));
  EXPECT_THAT(text, HasSubstr("! only in B: s, new (-): gains paper, planner spline\n"));
  EXPECT_THAT(text, HasSubstr("0 of 1 rows are worse in B."));
}

TEST(CompareTest, RunsWithNothingInCommonCannotBeCompared) {
  dob::Run other = run_with({0.01});
  other.cells[0].key.gains = "stiff";
  other.info.cells = {other.cells[0].key};
  EXPECT_THROW(compare_runs(run_with({0.01}), other, kCom), std::invalid_argument);
}

TEST(CompareTest, TextSaysWhatIsWorseAndWhy) {
  const std::string text = comparison_text(compare_runs(run_with({0.010}), run_with({0.020}), kCom));
  EXPECT_THAT(text, HasSubstr("B - A, com_error_max_m\n"));
  EXPECT_THAT(text, HasSubstr("0/1      0/1      1    +10  worse: every run is worse by more than 5 %\n"));
  EXPECT_THAT(text, HasSubstr("1 of 1 rows are worse in B."));
}

}  // namespace
}  // namespace dob::compare_test
