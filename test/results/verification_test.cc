#include "results/verification.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::verification_test {
namespace {

using test::failed;
using test::fell;
using test::key;
using test::survived;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

CellResult sample() {
  CellResult cell = survived(key("case1", "knee", "momentum", "paper", 3), 0.1);
  cell.state_hash = 0x0123456789abcdefULL;
  cell.metrics.qp_failures = 2;
  cell.checkpoints.push_back(test::checkpoint(1.0, 0.05));
  cell.shadows.push_back({.observer = "none", .profile = "-", .estimate_rmse_N = 1.5});
  return cell;
}

TEST(Verification, OnlyWallTimeAndTheNameOfATraceMayDiffer) {
  CellResult again = sample();
  again.wall_s = 99.0;
  again.trace = "traces/a.dobtrace";
  EXPECT_EQ(verified(sample(), again).verdict, Reproduced::kEqual);
  EXPECT_EQ(verified(sample(), again).detail, "");
}

TEST(Verification, EverythingElseThatDiffersInOneBitIsFound) {
  const auto found = [](auto change) {
    CellResult again = sample();
    change(again);
    return verified(sample(), again);
  };
  const double bit = std::numeric_limits<double>::epsilon();
  const VerifiedCell hash = found([](CellResult& c) { c.state_hash ^= 1U; });
  EXPECT_EQ(hash.verdict, Reproduced::kDifferent);
  EXPECT_THAT(hash.detail, HasSubstr("state hash 0123456789abcdef stored, 0123456789abcdee now"));
  EXPECT_EQ(hash.key, sample().key);
  const VerifiedCell metric = found([&](CellResult& c) { *c.metrics.com_error_max_m *= 1.0 + bit; });
  EXPECT_EQ(metric.verdict, Reproduced::kDifferent);
  EXPECT_THAT(metric.detail, AllOf(HasSubstr("same trajectory"), HasSubstr("com_error_max_m 0.1 stored, 0.1000")));
  EXPECT_THAT(found([](CellResult& c) { c.metrics.qp_failures = 3; }).detail, HasSubstr("qp_failures 2 stored, 3 now"));
  EXPECT_THAT(found([](CellResult& c) { c.metrics.slip_max_m = 0.0; }).detail, HasSubstr("slip_max_m null stored"));
  EXPECT_THAT(found([](CellResult& c) { c.simulated_s = 45.0; }).detail, HasSubstr("survived 46 s stored"));
  for (const VerifiedCell& cell :
       {found([](CellResult& c) { c.checkpoints[0].t = 2.0; }),
        found([](CellResult& c) { c.shadows[0].estimate_rmse_N = -1.5; }),
        found([](CellResult& c) { c.shadows.clear(); }), found([](CellResult& c) { c.metrics.qp_solves = 1; })}) {
    EXPECT_EQ(cell.verdict, Reproduced::kDifferent);
    EXPECT_NE(cell.detail, "");
  }
}

TEST(Verification, FallsAreComparedByTimeAndReason) {
  const CellKey k = key("s", "", "a", "-", 1);
  EXPECT_EQ(verified(fell(k, 1.5, 0.1), fell(k, 1.5, 0.1)).verdict, Reproduced::kEqual);
  EXPECT_THAT(verified(fell(k, 1.5, 0.1), fell(k, 1.501, 0.1)).detail,
              HasSubstr("fell at 1.5 s (trunk tilted) stored, fell at 1.501 s (trunk tilted) now"));
  CellResult low = fell(k, 1.5, 0.1);
  low.reason = "trunk low";
  EXPECT_EQ(verified(fell(k, 1.5, 0.1), low).verdict, Reproduced::kDifferent);
  const VerifiedCell flipped = verified(fell(k, 1.5, 0.1), survived(k, 0.1));
  EXPECT_EQ(flipped.verdict, Reproduced::kFlipped);
  EXPECT_EQ(flipped.detail, "fell at 1.5 s (trunk tilted) stored, survived 46 s now");
}

TEST(Verification, ErrorsAreComparedByReasonButAClockProvesNothing) {
  const CellKey k = key("s", "", "a", "-", 1);
  EXPECT_EQ(verified(failed(k, "crashed: Aborted"), failed(k, "crashed: Aborted")).verdict, Reproduced::kEqual);
  EXPECT_EQ(verified(failed(k, "crashed: Aborted"), failed(k, "other")).verdict, Reproduced::kDifferent);
  EXPECT_EQ(verified(failed(k, "crashed: Aborted"), survived(k, 0.1)).verdict, Reproduced::kFlipped);
  const VerifiedCell timeout = verified(failed(k, "timeout after 5 s"), survived(k, 0.1));
  EXPECT_EQ(timeout.verdict, Reproduced::kNotVerified);
  EXPECT_THAT(timeout.detail, HasSubstr("timeout after 5 s"));
  const VerifiedCell not_again = verified(survived(k, 0.1), failed(k, "timeout after 1 s"));
  EXPECT_EQ(not_again.verdict, Reproduced::kNotVerified);
  EXPECT_THAT(not_again.detail, HasSubstr("could not be run again: timeout after 1 s"));
}

const MetricSpread& spread_of(const std::vector<MetricSpread>& spreads, std::string_view metric) {
  for (const MetricSpread& spread : spreads) {
    if (spread.metric == metric) return spread;
  }
  throw std::out_of_range(std::string(metric));
}

TEST(Verification, SpreadsAreTheLargestRelativeDifferencesOfWhatEndedAlike) {
  const CellKey a = key("s", "", "a", "-", 1), b = key("s", "", "b", "-", 1), c = key("s", "", "c", "-", 1);
  CellResult slipped = survived(b, 0.2);
  slipped.metrics.slip_max_m = 1.0;
  const std::vector<CellPair> pairs{{survived(a, 1.0), survived(a, 1.0)},   {survived(b, 0.2), slipped},
                                    {survived(c, 0.4), survived(c, 0.5)},   {survived(a, 1.0), fell(a, 1.0, 9.0)},
                                    {fell(a, 2.0, 1.0), fell(a, 2.0, 4.0)}, {failed(a, "x"), failed(a, "x")}};
  const std::vector<MetricSpread> spreads = metric_spreads(pairs);
  const MetricSpread& com = spread_of(spreads, "com_error_max_m");
  EXPECT_EQ(com.cells, 4);
  EXPECT_EQ(com.different, 2);
  EXPECT_DOUBLE_EQ(com.largest, 0.1 / 0.5);
  EXPECT_DOUBLE_EQ(com.largest_fell, 0.75);
  EXPECT_EQ(com.where, a);
  EXPECT_EQ(metric_spreads({pairs.begin(), pairs.begin() + 3}).at(1).where, c);
  EXPECT_EQ(spread_of(spreads, "slip_max_m").one_sided, 1);
  EXPECT_EQ(spread_of(spreads, "simulated_s").different, 0);
  for (const MetricSpread& spread : spreads) EXPECT_NE(spread.metric, "foot_error_max_m");
}

Verification some_verification() {
  return {.dir = "runs/1",
          .planned = 10,
          .finished = 8,
          .seed = 7,
          .cells = {{key("case1", "knee", "a", "paper", 1), Reproduced::kEqual, ""},
                    {key("case1", "knee", "b,c", "paper", 2), Reproduced::kDifferent, "state hash 1 stored, 2 now"},
                    {key("case1", "knee", "d", "paper", 3), Reproduced::kNotVerified, "plugin: x.so"}},
          .across = "",
          .spreads = {}};
}

TEST(VerificationText, CountsTheVerdictsAndNamesWhatIsNotEqual) {
  const std::string text = verification_text(some_verification(), TableFormat::kText);
  EXPECT_THAT(text, AllOf(HasSubstr("runs/1: 3 of 8 finished cells computed again (a sample, seed 7)"),
                          HasSubstr("2 of 10 planned cells are not finished"), HasSubstr("state hash 1 stored, 2 now"),
                          HasSubstr("plugin: x.so"), HasSubstr("b,c (paper)"), Not(HasSubstr("a (paper)"))));
  EXPECT_THAT(verification_text(some_verification(), TableFormat::kMarkdown),
              AllOf(HasSubstr("| equal | 1 |"), HasSubstr("| outcome flipped | 0 |")));
}

TEST(VerificationText, CsvHasEveryCell) {
  EXPECT_EQ(verification_text(some_verification(), TableFormat::kCsv),
            "scenario,variant,observer,profile,gains,planner,overrides,seed,verdict,detail\n"
            "case1,knee,a,paper,paper,spline,,1,equal,\n"
            "case1,knee,\"b,c\",paper,paper,spline,,2,different,\"state hash 1 stored, 2 now\"\n"
            "case1,knee,d,paper,paper,spline,,3,not verified,plugin: x.so\n");
}

TEST(VerificationText, AcrossSaysWhatDiffersAndHowFarTheMetricsLieApart) {
  Verification v = some_verification();
  v.across = "flags: '-O3' there, '-O2' here";
  v.spreads = {{"com_error_max_m", 3, 2, 1.24e-11, 2e-3, key("case1", "knee", "a", "paper", 1), 0}};
  EXPECT_THAT(verification_text(v, TableFormat::kText),
              AllOf(HasSubstr("flags: '-O3' there, '-O2' here"), HasSubstr("com_error_max_m"), HasSubstr("1.2e-11  "),
                    HasSubstr("2.0e-03"), HasSubstr("case1 / knee, a (paper), seed 1"), HasSubstr("plugin: x.so"),
                    Not(HasSubstr("state hash 1 stored"))));
}

}  // namespace
}  // namespace dob::verification_test
