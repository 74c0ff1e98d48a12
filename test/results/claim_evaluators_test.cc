// Every kind of claim says yes, says no, and says that it cannot tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/metric_fields.h"
#include "test/results/claim_samples.h"

namespace dob::claim_evaluators_test {
namespace {

using test::ask;
using test::cell;
using test::checkpoint;
using test::fallen;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Optional;

constexpr std::size_t kCom = metric_index("com_error_max_m");
constexpr std::size_t kFoot = metric_index("foot_error_max_m");
constexpr std::size_t kOnset = metric_index("foot_error_onset_max_m");

CellMetrics com(double metres) {
  return {.com_error_max_m = metres};
}

CellMetrics feet(double onset, double others) {
  return {.foot_error_max_m = others, .foot_error_onset_max_m = onset};
}

TEST(BoundClaimTest, WorstSeedDecides) {
  const BoundClaim claim{.observer = "momentum", .metric = kCom, .at_most = 0.01};
  const Finding yes = ask(claim, {cell("momentum", 1, com(0.006)), cell("momentum", 2, com(0.01))});
  EXPECT_EQ(yes.verdict, Verdict::kYes);
  EXPECT_EQ(yes.measured, "8 (10) mm");
  const Finding no =
      ask(claim, {cell("momentum", 1, com(0.006)), cell("momentum", 2, com(0.004)), cell("momentum", 3, com(0.0101))});
  EXPECT_EQ(no.verdict, Verdict::kNo);
  EXPECT_THAT(no.worst, Optional(0.0101));
  EXPECT_THAT(no.median, Optional(0.006));
}

TEST(BoundClaimTest, BelowIsStrictAndLowerLimitsCount) {
  const std::vector<CellResult> cells{cell("momentum", 1, com(0.01)), cell("momentum", 2, com(0.03))};
  EXPECT_EQ(ask(BoundClaim{.observer = "momentum", .metric = kCom, .below = 0.03}, cells).verdict, Verdict::kNo);
  EXPECT_EQ(ask(BoundClaim{.observer = "momentum", .metric = kCom, .at_most = 0.03}, cells).verdict, Verdict::kYes);
  const Finding low = ask(BoundClaim{.observer = "momentum", .metric = kCom, .at_least = 0.02, .at_most = 0.05}, cells);
  EXPECT_EQ(low.verdict, Verdict::kNo);
  EXPECT_THAT(low.worst, Optional(0.01));  // the one farthest out, not the largest
}

TEST(BoundClaimTest, AFallBreaksEveryBound) {
  const BoundClaim claim{.observer = "momentum", .metric = kCom, .at_most = 0.01};
  const Finding no = ask(claim, {cell("momentum", 1, com(0.002)), fallen("momentum", 2, 25.1, com(0.003))});
  EXPECT_EQ(no.verdict, Verdict::kNo);
  EXPECT_THAT(no.measured, HasSubstr("falls 1/2 (25.1 s)"));
}

TEST(BoundClaimTest, FigureIsOfTheRunsThatSurvived) {
  const BoundClaim claim{.observer = "momentum", .metric = kCom, .at_most = 0.01};
  const Finding some = ask(claim, {cell("momentum", 1, com(0.002)), fallen("momentum", 2, 25.1, com(0.3))});
  EXPECT_EQ(some.measured, "2 mm, falls 1/2 (25.1 s)");
  EXPECT_THAT(some.worst, Optional(0.002));
  EXPECT_EQ(ask(claim, {fallen("momentum", 1, 25.1, com(0.3))}).measured, "falls 1/1 (25.1 s)");
}

TEST(BoundClaimTest, AFallMayDoAsWell) {
  const BoundClaim claim{.observer = "momentum", .metric = kCom, .at_least = 0.5, .or_fall = true};
  const CellResult held_up = cell("momentum", 1, com(0.6)), walks = cell("momentum", 2, com(0.1));
  const CellResult falls = fallen("momentum", 3, 4.0, com(0.2));
  EXPECT_EQ(ask(claim, {held_up, falls}).verdict, Verdict::kYes);
  EXPECT_EQ(ask(claim, {falls}).verdict, Verdict::kYes);
  const Finding no = ask(claim, {held_up, walks, falls});
  EXPECT_EQ(no.verdict, Verdict::kNo);
  EXPECT_TRUE(no.settled);
  EXPECT_THAT(no.worst, Optional(0.1));
  EXPECT_EQ(ask(claim, {falls, cell("momentum", 1, {})}).verdict, Verdict::kNoData);
  EXPECT_EQ(ask(BoundClaim{.observer = "momentum", .metric = kCom, .at_least = 0.5}, {held_up, falls}).verdict,
            Verdict::kNo);
}

TEST(BoundClaimTest, WithoutAFigureThereIsNoVerdict) {
  const BoundClaim claim{.observer = "momentum", .metric = kFoot, .at_most = 0.01};
  EXPECT_EQ(ask(claim, {cell("momentum", 1, com(0.002))}).verdict, Verdict::kNoData);
  EXPECT_EQ(ask(claim, {cell("none", 1, com(0.002))}).verdict, Verdict::kNoData);
}

TEST(FallClaimTest, HoldsWhenMoreThanHalfOfTheRunsFall) {
  const FallClaim claim{"com_wrench"};
  const CellResult walks = cell("com_wrench", 1, {});
  const CellResult one = fallen("com_wrench", 2, 42.0, {}), two = fallen("com_wrench", 3, 40.0, {});
  const Finding yes = ask(claim, {walks, one, two});
  EXPECT_EQ(yes.verdict, Verdict::kYes);
  EXPECT_EQ(yes.measured, "falls 2/3 (41.0 s)");
  EXPECT_EQ(ask(claim, {walks, one}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {cell("momentum", 1, {})}).verdict, Verdict::kNoData);
}

TEST(SurviveClaimTest, OneFallIsANo) {
  const SurviveClaim claim{"momentum"};
  EXPECT_EQ(ask(claim, {cell("momentum", 1, {}), cell("momentum", 2, {})}).verdict, Verdict::kYes);
  EXPECT_EQ(ask(claim, {cell("momentum", 1, {}), fallen("momentum", 2, 3.0, {})}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {cell("none", 1, {})}).verdict, Verdict::kNoData);
}

TEST(OrderingClaimTest, EveryStageIsNoWorseThanTheNext) {
  const OrderingClaim claim{{{"a"}, {"b", "c"}}, kCom, 1.0};
  const auto run = [](double a, double b, double c) {
    return std::vector{cell("a", 1, com(a)), cell("b", 1, com(b)), cell("c", 1, com(c))};
  };
  EXPECT_EQ(ask(claim, run(0.01, 0.03, 0.02)).verdict, Verdict::kYes);
  EXPECT_EQ(ask(claim, run(0.025, 0.03, 0.02)).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {cell("a", 1, com(0.01)), cell("b", 1, com(0.01))}).verdict, Verdict::kNoData);
}

TEST(OrderingClaimTest, SlackForgivesThatMuch) {
  const std::vector<CellResult> run{cell("a", 1, com(0.0105)), cell("b", 1, com(0.01))};
  EXPECT_EQ(ask(OrderingClaim{{{"a"}, {"b"}}, kCom, 1.0}, run).verdict, Verdict::kNo);
  EXPECT_EQ(ask(OrderingClaim{{{"a"}, {"b"}}, kCom, 1.1}, run).verdict, Verdict::kYes);
}

TEST(OrderingClaimTest, AFallRanksBehindEverySurvivorAndAnEarlierOneBehindALater) {
  const CellResult walks_badly = cell("a", 1, com(0.5)), falls = fallen("b", 1, 10.0, com(0.001));
  EXPECT_EQ(ask(OrderingClaim{{{"a"}, {"b"}}, kCom, 1.0}, {walks_badly, falls}).verdict, Verdict::kYes);
  EXPECT_EQ(ask(OrderingClaim{{{"b"}, {"a"}}, kCom, 1.0}, {walks_badly, falls}).verdict, Verdict::kNo);
  const CellResult earlier = fallen("a", 1, 9.0, com(0.0001));
  EXPECT_EQ(ask(OrderingClaim{{{"a"}, {"b"}}, kCom, 1.0}, {earlier, falls}).verdict, Verdict::kNo);
}

// Of each observer one run walks and one falls, a's while it leads: 0.3 m and 0.1 m are errors of the falls.
TEST(OrderingClaimTest, WithEqualSharesOfFallsTheCommonTimeDecides) {
  const OrderingClaim claim{{{"a"}, {"b"}}, kCom, 1.0};
  const std::vector<CellResult> cells{
      cell("a", 1, com(0.012)), fallen("a", 2, 10.3, com(0.3), {checkpoint(8.0, 0.01), checkpoint(10.0, 0.012)}),
      cell("b", 1, com(0.020)), fallen("b", 2, 8.4, com(0.1), {checkpoint(8.0, 0.019)})};
  const Finding finding = ask(claim, cells);
  EXPECT_EQ(finding.verdict, Verdict::kYes);
  EXPECT_EQ(finding.measured,
            "a 12 mm falls 1/2 (10.3 s), b 20 mm falls 1/2 (8.4 s); on common time (from 8.0 s): a 11 (12) mm, b 19.5 "
            "(20) mm");
  EXPECT_EQ(ask(OrderingClaim{{{"b"}, {"a"}}, kCom, 1.0}, cells).verdict, Verdict::kNo);
}

TEST(OrderingClaimTest, AMetricWithoutCheckpointsIsComparedWhereBothSurvived) {
  const auto estimate = [](double newtons) { return CellMetrics{.estimate_rmse_N = newtons}; };
  const OrderingClaim claim{{{"a"}, {"b"}}, metric_index("estimate_rmse_N"), 1.0};
  const std::vector<CellResult> cells{cell("a", 1, estimate(2.0)), fallen("a", 2, 9.0, estimate(90.0)),
                                      cell("b", 1, estimate(3.0)), fallen("b", 2, 9.0, estimate(50.0))};
  EXPECT_EQ(ask(claim, cells).verdict, Verdict::kYes);
  const Finding apart = ask(claim, {cells[0], cells[1], fallen("b", 1, 9.0, estimate(3.0)), cell("b", 2, estimate(3))});
  EXPECT_EQ(apart.verdict, Verdict::kNoData);
  EXPECT_THAT(apart.remark, HasSubstr("no runs of a and b compare"));
}

TEST(OrderingClaimTest, NamesShowOnlyWhatDiffers) {
  const OrderingClaim claim{{{"momentum:family=bessel,order=1"}, {"momentum:family=bessel,order=2"}}, kCom, 1.0};
  const Finding finding = ask(claim, {cell("momentum:family=bessel,order=1", 1, com(0.001)),
                                      cell("momentum:family=bessel,order=2", 1, com(0.002))});
  EXPECT_EQ(finding.measured, "order=1 1 mm, order=2 2 mm");
}

TEST(SimilarClaimTest, TheRatioDecides) {
  const SimilarClaim claim{{"a", "b"}, kCom, 1.5};
  EXPECT_EQ(ask(claim, {cell("a", 1, com(0.010)), cell("b", 1, com(0.014))}).verdict, Verdict::kYes);
  EXPECT_EQ(ask(claim, {cell("a", 1, com(0.016)), cell("b", 1, com(0.010))}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {cell("a", 1, com(0.010))}).verdict, Verdict::kNoData);
}

// One may fall where the other one walks on: they are alike until then, or not.
TEST(SimilarClaimTest, AFallIsOfNoAccount) {
  const SimilarClaim claim{{"a", "b"}, kCom, 1.5};
  const auto falls = [](double before) { return fallen("a", 1, 4.2, com(0.3), {checkpoint(4.0, before)}); };
  const CellResult walks = cell("b", 1, com(0.5), {checkpoint(4.0, 0.012), checkpoint(4.5, 0.1)});
  const Finding yes = ask(claim, {falls(0.010), walks});
  EXPECT_EQ(yes.verdict, Verdict::kYes);
  EXPECT_EQ(yes.measured, "a falls 1/1 (4.2 s), b 500 mm; on common time (from 4.0 s): a 10 mm, b 12 mm");
  EXPECT_EQ(ask(claim, {falls(0.030), walks}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {fallen("a", 1, 0.3, com(0.010)), walks}).verdict, Verdict::kNoData);
}

CellResult offset_cell(const std::string& scenario, double offset, double rmse) {
  CellResult result = test::survived(test::key(scenario, "", "momentum", "paper", 1), 0.0);
  result.metrics = {.joint_estimate_rmse_Nm = rmse, .estimate_offset_Nm = offset};
  return result;
}

Finding ask_offset(const std::vector<CellResult>& cells) {
  const Run run = test::run_of(cells);
  const CellGroups groups(run);
  return evaluate(OffsetClaim{"momentum", "case4", 0.5}, ClaimView(groups, {"case5"}, test::kPaperSetting));
}

TEST(OffsetClaimTest, OffsetIsLargerThanWithoutItsCauseAndMostOfTheError) {
  const CellResult without = offset_cell("case4", 0.2, 1.0);
  EXPECT_EQ(ask_offset({without, offset_cell("case5", 2.0, 3.0)}).verdict, Verdict::kYes);
  EXPECT_EQ(ask_offset({without, offset_cell("case5", 2.0, 5.0)}).verdict, Verdict::kNo);  // it changes too much
  EXPECT_EQ(ask_offset({without, offset_cell("case5", 0.1, 0.1)}).verdict, Verdict::kNo);  // not the model's
  EXPECT_EQ(ask_offset({offset_cell("case5", 2.0, 3.0)}).verdict, Verdict::kNoData);
  CellResult falls = offset_cell("case5", 2.0, 3.0);
  falls.outcome = Outcome::kFell;
  EXPECT_EQ(ask_offset({without, falls}).verdict, Verdict::kNoData);
}

CellMetrics peaks(double before, double push, std::optional<double> recovery) {
  return {.com_peak_before_m = before, .com_peak_push_m = push, .com_peak_recovery_m = recovery};
}

TEST(TwoPeaksClaimTest, BothPeaksStandOut) {
  const TwoPeaksClaim claim{"momentum"};
  EXPECT_EQ(ask(claim, {cell("momentum", 1, peaks(0.002, 0.009, 0.007))}).verdict, Verdict::kYes);
  EXPECT_EQ(ask(claim, {cell("momentum", 1, peaks(0.002, 0.009, std::nullopt))}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {cell("momentum", 1, peaks(0.002, 0.009, 0.002))}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {fallen("momentum", 1, 3.5, {})}).verdict, Verdict::kNo);
  EXPECT_EQ(ask(claim, {cell("momentum", 1, com(0.01))}).verdict, Verdict::kNoData);
}

TEST(TwoPeaksClaimTest, AllRunsMustShowThem) {
  const Finding finding = ask(TwoPeaksClaim{"momentum"}, {cell("momentum", 1, peaks(0.0, 0.009, 0.007)),
                                                          cell("momentum", 2, peaks(0.0, 0.009, std::nullopt))});
  EXPECT_EQ(finding.verdict, Verdict::kNo);
  EXPECT_THAT(finding.measured, HasSubstr("1/2"));
}

TEST(LargerClaimTest, EveryRunIsComparedWithItself) {
  const LargerClaim claim{"momentum", kOnset, kFoot};
  const CellResult holds = cell("momentum", 1, feet(0.04, 0.03)), neither = cell("momentum", 2, com(0.0));
  EXPECT_EQ(ask(claim, {holds, neither}).verdict, Verdict::kYes);
  // The largest of all onsets, 0.04, is above the largest of all others, 0.03: in another run.
  const Finding no = ask(claim, {holds, cell("momentum", 2, feet(0.01, 0.02))});
  EXPECT_EQ(no.verdict, Verdict::kNo);
  EXPECT_TRUE(no.settled);
  EXPECT_EQ(no.measured, "10 mm against 20 mm, larger in 1/2");
  // And here it is not, though it is in each run.
  EXPECT_EQ(ask(claim, {holds, cell("momentum", 2, feet(0.06, 0.05))}).measured, "60 mm against 50 mm, larger in 2/2");
  EXPECT_EQ(ask(claim, {cell("momentum", 1, {.foot_error_max_m = 0.03})}).verdict, Verdict::kNoData);
}

TEST(LargerClaimTest, RunsThatFellDoNotConfirmIt) {
  const LargerClaim claim{"momentum", kOnset, kFoot};
  const CellResult falls = fallen("momentum", 2, 4.0, feet(0.5, 0.03));
  EXPECT_EQ(ask(claim, {falls}).verdict, Verdict::kNoData);
  const Finding finding = ask(claim, {cell("momentum", 1, feet(0.02, 0.03)), falls});
  EXPECT_EQ(finding.verdict, Verdict::kNo);
  EXPECT_EQ(finding.measured, "20 mm against 30 mm, falls 1/2 (4.0 s)");
}

CellResult of_sweep(CellResult cell, std::size_t i) {
  cell.key = test::key("sweep", std::to_string(i), "momentum", "paper", cell.key.seed);
  return cell;
}

// The cells of each case of a sweep.
Finding ask_growth(const std::vector<std::vector<CellResult>>& sweep, std::size_t metric = kCom) {
  std::vector<CellResult> cells;
  std::vector<std::string> cases;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    cases.push_back("sweep/" + std::to_string(i));
    for (const CellResult& cell : sweep[i]) cells.push_back(of_sweep(cell, i));
  }
  const Run run = test::run_of(cells);
  const CellGroups groups(run);
  return evaluate(GrowsClaim{"momentum", metric}, ClaimView(groups, cases, test::kPaperSetting));
}

TEST(GrowsClaimTest, EveryCaseIsAboveTheOneBefore) {
  const auto walks = [](double metres) { return std::vector{cell("momentum", 1, com(metres))}; };
  EXPECT_EQ(ask_growth({walks(0.01), walks(0.02), walks(0.04)}).verdict, Verdict::kYes);
  EXPECT_EQ(ask_growth({walks(0.01), walks(0.02), walks(0.02)}).verdict, Verdict::kNo);
  EXPECT_EQ(ask_growth({walks(0.01)}).verdict, Verdict::kNoData);
  EXPECT_EQ(ask_growth({walks(0.01), walks(0.02), walks(0.04)}).measured, "10 mm -> 20 mm -> 40 mm");
}

TEST(GrowsClaimTest, AFallConfirmsNothing) {
  const std::vector<CellResult> walks{cell("momentum", 1, com(0.02), {checkpoint(4.0, 0.01)})};
  const std::vector<CellResult> falls{fallen("momentum", 1, 4.2, com(0.3), {checkpoint(4.0, 0.009)})};
  const Finding finding = ask_growth({walks, falls});
  EXPECT_EQ(finding.verdict, Verdict::kNo);
  EXPECT_EQ(finding.measured, "10 mm -> 9 mm (on common time from 4.0 s), sweep/1 falls 1/1 (4.2 s)");
  EXPECT_EQ(ask_growth({falls, walks}).verdict, Verdict::kYes);
}

TEST(GrowsClaimTest, WithoutCommonTimeThereIsNoVerdict) {
  const std::vector<CellResult> walks{cell("momentum", 1, com(0.02), {checkpoint(0.5, 0.001)})};
  const auto falls = [](double t) { return std::vector{fallen("momentum", 1, t, com(0.3), {checkpoint(0.5, 0.002)})}; };
  EXPECT_EQ(ask_growth({walks, falls(2.2)}).verdict, Verdict::kYes);
  const Finding at_once = ask_growth({walks, falls(1.9)});
  EXPECT_EQ(at_once.verdict, Verdict::kNoData);
  EXPECT_THAT(at_once.remark, HasSubstr("sweep/1"));
  EXPECT_EQ(ask_growth({walks, {cell("momentum", 2, com(0.3))}}).verdict, Verdict::kNoData);  // seeds apart
  // A metric without checkpoints is that of the whole run, the fall included.
  const auto slip = [](double metres) { return CellMetrics{.slip_max_m = metres}; };
  EXPECT_EQ(ask_growth({{cell("momentum", 1, slip(0.01))}, {fallen("momentum", 1, 4.0, slip(0.3))}},
                       metric_index("slip_max_m"))
                .verdict,
            Verdict::kNoData);
}

}  // namespace
}  // namespace dob::claim_evaluators_test
