#include "results/report_traces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/report_samples.h"

namespace dob::report_traces_test {
namespace {

using test::key;
using test::survived;
using test::with_trace;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

CellKey with_gains(CellKey cell, const std::string& gains) {
  cell.gains = gains;
  return cell;
}

std::vector<std::string> order_of(const std::vector<CellKey>& keys) {
  std::vector<CellResult> cells;
  for (const CellKey& k : keys) cells.push_back(with_trace(survived(k, 0.01), "x"));
  const Run run = test::run_of(cells);
  std::vector<std::string> names;
  for (const CellResult* cell : traces_in_order(run, ReportIndex(run.info.cells))) {
    const CellKey& k = cell->key;
    names.push_back(fmt::format("{}/{} {}@{} {} {}", k.scenario, k.variant, k.observer, k.profile, k.gains, k.seed));
  }
  return names;
}

TEST(ReportTraces, VariantsThenProfilesThenGainsThenSeedsComeLast) {
  EXPECT_THAT(order_of({with_gains(key("case1", "a", "none", "-", 1), "stiff"),  //
                        key("case1", "a", "none", "-", 1),                       //
                        key("case1", "a", "none", "-", 2),                       //
                        key("case1", "a", "momentum", "paper", 1),               //
                        key("case1", "a", "momentum", "tuned", 1),               //
                        key("case1", "b", "none", "-", 1),                       //
                        key("case1", "b", "momentum", "tuned", 1),               //
                        key("case4", "", "none", "-", 1)}),
              ElementsAre("case1/a none@- paper 1",          //
                          "case1/a momentum@tuned paper 1",  //
                          "case4/ none@- paper 1",           //
                          "case1/b none@- paper 1",          //
                          "case1/b momentum@tuned paper 1",  //
                          "case1/a momentum@paper paper 1",  //
                          "case1/a none@- stiff 1",          //
                          "case1/a none@- paper 2"));
}

TEST(ReportTraces, WithoutTunedOnesTheRunsFirstProfileComesFirst) {
  EXPECT_THAT(order_of({key("case1", "a", "momentum", "matched", 1), key("case1", "a", "momentum", "paper", 1),
                        key("case1", "b", "momentum", "matched", 1)}),
              ElementsAre("case1/a momentum@matched paper 1", "case1/b momentum@matched paper 1",
                          "case1/a momentum@paper paper 1"));
}

TEST(ReportTraces, AScenarioThatIsNotRunTunedIsThereInItsFirstProfile) {
  EXPECT_THAT(order_of({key("case1", "a", "momentum", "tuned", 1), key("case1", "b", "momentum", "tuned", 1),
                        key("orders", "", "momentum", "paper", 1)}),
              ElementsAre("case1/a momentum@tuned paper 1", "orders/ momentum@paper paper 1",
                          "case1/b momentum@tuned paper 1"));
}

// Five cells of one scenario whose traces take about as much room as one another.
class ReportTracesInRoom : public test::ReportFixture {
 protected:
  std::vector<CellResult> cells;

  void SetUp() override {
    test::ReportFixture::SetUp();
    for (int seed = 1; seed <= 5; ++seed) {
      cells.push_back(with_trace(survived(key("case1", "a", "none", "-", seed), 0.01), std::to_string(seed)));
    }
    std::vector<CellKey> keys;
    for (const CellResult& cell : cells) keys.push_back(cell.key);
    test::make_run(dir, keys, cells);
    for (const CellResult& cell : cells) write_trace(dir / cell.trace, test::walking_trace(3000, 0.05));
  }

  ReportTraces take(std::size_t room) const {
    const dob::Run run = read_run(dir);
    return take_traces(dir, run, ReportIndex(run.info.cells), room, "size limit");
  }
};

TEST_F(ReportTracesInRoom, AllAreTakenWhereThereIsRoom) {
  const ReportTraces all = take(1'000'000'000);
  EXPECT_EQ(all.payloads.size(), 5U);
  EXPECT_TRUE(all.left_out.empty());
  EXPECT_TRUE(all.missing.empty()) << all.missing.front();
}

TEST_F(ReportTracesInRoom, EveryTraceIsEitherTakenOrNamedAsLeftOut) {
  const std::size_t one = take(1'000'000'000).payloads.front().size();
  for (const std::size_t room : {std::size_t{0}, one / 2, 2 * one, 3 * one, 4 * one}) {
    const ReportTraces some = take(room);
    EXPECT_EQ(some.payloads.size() + some.left_out.size(), 5U) << room;
    EXPECT_LT(some.payloads.size(), 5U);
    std::size_t bytes = 0;
    for (const std::string& payload : some.payloads) bytes += payload.size();
    EXPECT_LE(bytes, room);
    for (std::size_t i = 0; i < some.left_out.size(); ++i) {
      const int seed = static_cast<int>(some.payloads.size() + i) + 1;
      EXPECT_EQ(some.left_out[i]["what"],
                fmt::format("traces of case1/a (gains paper, planner spline), seed {}: none", seed));
      EXPECT_EQ(some.left_out[i]["why"], "size limit");
    }
  }
  EXPECT_GE(take(3 * one).payloads.size(), 1U);
}

TEST_F(ReportTracesInRoom, DamagedAndLostTracesAreNamedAndTheOthersTaken) {
  test::append_text(dir / cells[1].trace, "x");
  std::filesystem::resize_file(dir / cells[2].trace, 300);
  std::ofstream(dir / cells[3].trace) << "no trace";
  std::filesystem::remove(dir / cells[4].trace);
  const ReportTraces some = take(1'000'000'000);
  EXPECT_EQ(some.payloads.size() + some.missing.size(), 5U);
  EXPECT_TRUE(some.left_out.empty());
  const std::string missing = fmt::format("{}", fmt::join(some.missing, "\n"));
  EXPECT_THAT(missing, HasSubstr("case1/a, none, seed 3 cannot be shown: traces/3.dobtrace: its data are damaged"));
  EXPECT_THAT(missing, HasSubstr("seed 4 cannot be shown: traces/4.dobtrace: is not a trace"));
  EXPECT_THAT(missing, HasSubstr("seed 5 cannot be shown: traces/5.dobtrace: cannot be read"));
  EXPECT_EQ(missing.find(dir.string()), std::string::npos) << "where the run lies is nobody's business";
}

TEST_F(ReportTracesInRoom, WhatOlderTracesLackIsSaid) {
  write_trace(dir / cells[0].trace, test::trace_of(10, {{"com_error_m", [](double) { return 0.0; }}}));
  const std::string missing = fmt::format("{}", fmt::join(take(1'000'000'000).missing, "\n"));
  EXPECT_THAT(missing, HasSubstr("No replay in 1 of 5 traces"));
  EXPECT_THAT(missing, HasSubstr("No planned footholds in the replay in 1 of 5 traces"));
  EXPECT_THAT(missing, HasSubstr("No path error over time in 1 of 5 traces"));
}

}  // namespace
}  // namespace dob::report_traces_test
