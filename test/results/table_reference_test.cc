#include "results/table_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::table_reference_test {
namespace {

using test::checkpoint;
using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Optional;

CellResult with(CellResult cell, std::vector<MetricsCheckpoint> checkpoints) {
  cell.checkpoints = std::move(checkpoints);
  return cell;
}

CellResult a_survivor(std::vector<MetricsCheckpoint> checkpoints) {
  return with(survived(key("s", "", "o", "-", 1), 0.0), std::move(checkpoints));
}

double time_of(const CellResult& a, const CellResult& b) {
  const auto both = on_common_time(a, b);
  if (!both) return -1.0;
  EXPECT_EQ(both->first.t, both->second.t);
  return both->first.t;
}

TEST(CommonTimeTest, OfTwoSurvivorsIsTheEnd) {
  const auto run = a_survivor({checkpoint(0.5, 0.1), checkpoint(1.0, 0.2), checkpoint(1.2, 0.3)});
  EXPECT_EQ(time_of(run, run), 1.2);
}

TEST(CommonTimeTest, OfARunThatFellIsItsLastMomentThatTheOtherHasToo) {
  const auto whole =
      a_survivor({checkpoint(0.5, 0.1), checkpoint(1.0, 0.2), checkpoint(1.5, 0.3), checkpoint(2.0, 0.3)});
  const auto fallen = with(fell(key("s", "", "o", "-", 1), 1.34, 0.9),
                           {checkpoint(0.5, 0.4), checkpoint(1.0, 0.5), checkpoint(1.339, 0.9)});
  EXPECT_EQ(time_of(whole, fallen), 1.0);
  EXPECT_EQ(time_of(fallen, whole), 1.0);
  EXPECT_THAT(on_common_time(whole, fallen)->second.com_error_max_m, Optional(0.5));
}

TEST(CommonTimeTest, ThereIsNoneBeforeTheFirstCheckpointAndWithAnError) {
  const auto whole = a_survivor({checkpoint(0.5, 0.1)});
  EXPECT_EQ(time_of(whole, with(fell(key("s", "", "o", "-", 1), 0.3, 0.9), {checkpoint(0.299, 0.9)})), -1.0);
  EXPECT_EQ(time_of(whole, with(test::failed(key("s", "", "o", "-", 1), "crash"), {checkpoint(0.5, 0.1)})), -1.0);
  EXPECT_EQ(time_of(whole, a_survivor({})), -1.0);
}

// Of each observer and seed a run of 1 s with these CoM errors.
struct Errors {
  const char *observer, *profile;
  std::vector<double> com;
};

dob::Run paired_run(const std::vector<Errors>& observers) {
  std::vector<CellResult> cells;
  for (const Errors& errors : observers) {
    for (std::size_t i = 0; i < errors.com.size(); ++i) {
      const CellKey k = key("s", "", errors.observer, errors.profile, static_cast<int>(i) + 1);
      cells.push_back(with(survived(k, errors.com[i]), {checkpoint(1.0, errors.com[i])}));
    }
  }
  return run_of(cells);
}

std::vector<TableRow> compared(const dob::Run& run, const std::string& reference) {
  std::vector<TableRow> rows = build_rows(run, TableOrder::kByScenario);
  compare_with_reference(rows, run, reference);
  return rows;
}

TEST(TableReferenceTest, DifferencesArePairedBySeedBeforeTheirMedian) {
  // Medians of each alone would differ by 1 - 2; pair by pair it is -3.
  const auto rows = compared(paired_run({{"none", "-", {1.0, 5.0, 9.0}}, {"o", "paper", {2.0, 1.0, 6.0}}}), "");
  EXPECT_EQ(rows[1].reference, "none@-");
  EXPECT_EQ(rows[1].paired[0].pairs, 3);
  EXPECT_THAT(rows[1].paired[0].median, Optional(DoubleNear(-3.0, 1e-15)));
  EXPECT_THAT(rows[1].paired[3].median, Optional(DoubleNear(-30.0, 1e-14)));  // foot
  EXPECT_EQ(rows[1].paired[4].median, std::nullopt);                          // no figure of the ground reaction force
  EXPECT_FALSE(rows[1].paired[0].ci95);
  EXPECT_EQ(rows[0].reference, "");
  EXPECT_EQ(rows[0].paired[0].pairs, 0);
}

TEST(TableReferenceTest, IntervalsAppearFromEightPairsOn) {
  const std::vector<double> ones(8, 1.0), halves(8, 0.5);
  const auto eight = compared(paired_run({{"none", "-", ones}, {"o", "-", halves}}), "");
  ASSERT_TRUE(eight[1].paired[0].ci95);
  EXPECT_EQ(eight[1].paired[0].ci95->low, -0.5);
  EXPECT_EQ(eight[1].paired[0].ci95->high, -0.5);
  const auto seven = compared(paired_run({{"none", "-", std::vector<double>(7, 1.0)}, {"o", "-", halves}}), "");
  EXPECT_EQ(seven[1].paired[0].pairs, 7);  // seed 8 has no partner
  EXPECT_FALSE(seven[1].paired[0].ci95);
}

TEST(TableReferenceTest, IsTheRowsOwnProfileUnlessOneIsNamed) {
  const dob::Run run =
      paired_run({{"m", "matched", {1.0}}, {"m", "paper", {2.0}}, {"o", "paper", {7.0}}, {"o", "tuned", {7.0}}});
  const auto own = compared(run, "m");
  EXPECT_EQ(own[2].reference, "m@paper");
  EXPECT_THAT(own[2].paired[0].median, Optional(5.0));
  EXPECT_EQ(own[3].reference, "m@matched");  // the first one: there is none of its profile
  const auto named = compared(run, "m@matched");
  EXPECT_EQ(named[2].reference, "m@matched");
  EXPECT_EQ(named[1].reference, "m@matched");
  EXPECT_THAT(named[1].paired[0].median, Optional(1.0));
  EXPECT_EQ(named[0].reference, "");
}

TEST(TableReferenceTest, ARunWithoutNoneHasNoReferenceUnlessOneIsAskedFor) {
  const dob::Run run = paired_run({{"a", "-", {1.0}}, {"b", "paper", {2.0}}});
  EXPECT_EQ(compared(run, "")[1].reference, "");
  for (const char* wrong : {"none", "c", "b@matched"}) {
    try {
      compared(run, wrong);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr(wrong));
      EXPECT_THAT(error.what(), HasSubstr("a@-, b@paper"));
    }
  }
}

}  // namespace
}  // namespace dob::table_reference_test
