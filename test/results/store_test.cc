#include "results/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/fingerprint.h"
#include "results/metric_fields.h"
#include "test/results/run_samples.h"

namespace dob::store_test {
namespace {

using test::key;
using test::read_text;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class StoreTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path dir = temporary.path() / "run";

  static RunInfo info_of(const std::vector<CellKey>& cells) {
    return {"dobbench run case1 --set 'a=\"b\"'",
            "0.1.0",
            "0123abc",
            "Release",
            "g++ 12.2.0",
            "-O3",
            {"Some CPU @ 3 GHz", 2, "Debian 12"},
            "2026-01-02T03:04:05Z",
            CellKeys(cells),
            {},
            {"portable", "glibc 2.36, libm.so.6 0123", "avx2 fma"}};
  }
};

TEST_F(StoreTest, RunInformationReadsBack) {
  const RunInfo info = info_of({key("case1", "knee", "none", "-", 1), key("case1", "", "a,b", "x", 7)});
  { const RunStore store = RunStore::create(dir, info, {}); }
  const RunInfo back = read_run(dir).info;
  EXPECT_EQ(back.command_line, info.command_line);
  EXPECT_EQ(back.version, info.version);
  EXPECT_EQ(back.commit, info.commit);
  EXPECT_EQ(back.build, info.build);
  EXPECT_EQ(back.compiler, info.compiler);
  EXPECT_EQ(back.flags, info.flags);
  EXPECT_EQ(back.machine.cpu, info.machine.cpu);
  EXPECT_EQ(back.machine.cores, info.machine.cores);
  EXPECT_EQ(back.machine.os, info.machine.os);
  EXPECT_EQ(back.date, info.date);
  EXPECT_EQ(back.cells, info.cells);
  EXPECT_EQ(back.code_path, info.code_path);
}

TEST_F(StoreTest, EveryCellKnowsTheProgramAndTheCodePathThatComputedIt) {
  const CellResult a = test::survived(key("s", "", "a", "-", 1), 1.0),
                   b = test::survived(key("s", "", "b", "-", 1), 2.0);
  const CellResult c = test::survived(key("s", "", "c", "-", 1), 3.0);
  RunInfo info = info_of({a.key, b.key, c.key});
  RunStore::create(dir, info, {}).append(a);
  RunStore::open(dir, info).append(c);
  info.code_path.cpu_flags = "sse4.1";
  RunStore::open(dir, info).append(b);
  const auto run = read_run(dir);
  ASSERT_EQ(run.programs.size(), 2U);
  ASSERT_EQ(run.program_of.size(), run.cells.size());
  const auto flags = [&](std::size_t cell) { return run.programs[run.program_of[cell]].path.cpu_flags; };
  EXPECT_EQ(flags(0), "avx2 fma");
  EXPECT_EQ(flags(1), "sse4.1");
  EXPECT_EQ(flags(2), "avx2 fma");
  EXPECT_EQ(run.programs[0].commit, "0123abc");
  EXPECT_THAT(run.notes, ElementsAre(AllOf(HasSubstr("several code paths"), HasSubstr("CPU flags: 'avx2 fma' there"))));
}

TEST_F(StoreTest, ARunFromBeforeTheCodePathWasKeptIsReadWithoutOne) {
  const CellResult a = test::survived(key("s", "", "a", "-", 1), 1.0);
  RunStore::create(dir, info_of({a.key}), {}).append(a);
  SQLite::Database database((dir / "run.sqlite").string(), SQLite::OPEN_READWRITE);
  database.exec("DROP VIEW overview; ALTER TABLE batch DROP COLUMN cpu_flags; ALTER TABLE batch DROP COLUMN libraries");
  const auto run = read_run(dir);
  EXPECT_EQ(run.programs.at(0).path, (CodePath{"portable", "", ""}));
  EXPECT_EQ(run.info.compiler, "g++ 12.2.0");
}

TEST_F(StoreTest, ScenariosAreWrittenAsGiven) {
  const RunStore store = RunStore::create(dir, info_of({}), {{"case1_knee", "a = 1\n"}, {"undisturbed", ""}});
  EXPECT_EQ(read_text(dir / "scenarios/case1_knee.toml"), "a = 1\n");
  EXPECT_TRUE(std::filesystem::exists(dir / "scenarios/undisturbed.toml"));
}

TEST_F(StoreTest, CellsReadBackBitForBit) {
  std::mt19937_64 random(7);
  const auto any_double = [&] {
    for (;;) {
      if (const double x = std::bit_cast<double>(random()); std::isfinite(x)) return x;
    }
  };
  std::vector<CellResult> cells;
  for (int seed = 1; seed <= 200; ++seed) {
    CellResult cell = test::survived(key("case1", "knee", "momentum", "paper", seed), 0.0);
    cell.outcome = static_cast<Outcome>(seed % 3);
    cell.reason = "line\nwith \"quotes\" and \t tab \xC3\xBC";
    cell.simulated_s = any_double();
    cell.wall_s = any_double();
    cell.state_hash = random();
    for (const MetricField& field : kMetricFields) {
      if (field.value != nullptr && random() % 4 != 0) cell.metrics.*field.value = any_double();
    }
    cell.metrics.qp_solves = static_cast<long>(random() >> 2);
    cell.metrics.qp_failures = seed;
    cells.push_back(cell);
  }
  cells[0].metrics.com_error_max_m = -0.0;
  cells[1].metrics.com_error_max_m = std::numeric_limits<double>::denorm_min();
  cells[2].metrics.com_error_max_m = 0.1 + 0.2;
  RunStore store = RunStore::create(dir, test::run_of(cells).info, {});
  for (const CellResult& cell : cells) store.append(cell);

  const std::vector<CellResult> back = read_cells(dir);
  ASSERT_EQ(back.size(), cells.size());
  const auto bits = [](std::optional<double> x) {
    return x ? std::optional(std::bit_cast<std::uint64_t>(*x)) : std::nullopt;
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(back[i].key, cells[i].key);
    EXPECT_EQ(back[i].outcome, cells[i].outcome);
    EXPECT_EQ(back[i].reason, cells[i].reason);
    EXPECT_EQ(bits(back[i].simulated_s), bits(cells[i].simulated_s));
    EXPECT_EQ(bits(back[i].wall_s), bits(cells[i].wall_s));
    EXPECT_EQ(back[i].state_hash, cells[i].state_hash);
    EXPECT_EQ(back[i].metrics.qp_solves, cells[i].metrics.qp_solves);
    EXPECT_EQ(back[i].metrics.qp_failures, cells[i].metrics.qp_failures);
    for (const MetricField& field : kMetricFields) {
      if (field.value == nullptr) continue;
      EXPECT_EQ(bits(back[i].metrics.*field.value), bits(cells[i].metrics.*field.value)) << field.name;
    }
  }
}

TEST_F(StoreTest, WhatIsNotFiniteIsNull) {
  CellResult cell = test::survived(key("s", "", "o", "-", 1), std::numeric_limits<double>::infinity());
  cell.metrics.slip_max_m = std::numeric_limits<double>::quiet_NaN();
  RunStore store = RunStore::create(dir, test::run_of({cell}).info, {});
  store.append(cell);
  EXPECT_EQ(read_cells(dir).at(0).metrics.com_error_max_m, std::nullopt);
  EXPECT_EQ(read_cells(dir).at(0).metrics.slip_max_m, std::nullopt);
}

// Checkpoints and shadow observers with some fields set and some not.
CellResult cell_with_lists() {
  CellResult cell = test::survived(key("case1", "knee", "momentum", "paper", 1), 0.1);
  cell.trace = "traces/0001.dobtrace";
  for (int i = 1; i <= 50; ++i) {
    cell.checkpoints.push_back({.t = 0.1 * i, .com_error_max_m = 1.0 / i, .grf_error_mean_N = -0.0});
  }
  cell.shadows.push_back({.observer = "com_wrench", .profile = "tuned", .com_force_rmse_N = 0.1 + 0.2});
  cell.shadows.push_back({.observer = "none", .profile = "-"});
  return cell;
}

void expect_same_lists(const CellResult& back, const CellResult& cell) {
  EXPECT_EQ(back.trace, cell.trace);
  ASSERT_EQ(back.checkpoints.size(), cell.checkpoints.size());
  for (std::size_t i = 0; i < cell.checkpoints.size(); ++i) {
    EXPECT_EQ(back.checkpoints[i].t, cell.checkpoints[i].t);
    EXPECT_EQ(back.checkpoints[i].com_error_max_m, cell.checkpoints[i].com_error_max_m);
    EXPECT_EQ(back.checkpoints[i].com_error_rms_m, std::nullopt);
    EXPECT_TRUE(std::signbit(*back.checkpoints[i].grf_error_mean_N));
  }
  ASSERT_EQ(back.shadows.size(), cell.shadows.size());
  EXPECT_EQ(back.shadows[0].observer, "com_wrench");
  EXPECT_EQ(back.shadows[0].profile, "tuned");
  EXPECT_EQ(back.shadows[0].com_force_rmse_N, 0.1 + 0.2);
  EXPECT_EQ(back.shadows[0].estimate_rmse_N, std::nullopt);
  EXPECT_EQ(back.shadows[1].observer, "none");
}

TEST_F(StoreTest, CheckpointsAndShadowObserversReadBack) {
  const CellResult cell = cell_with_lists();
  RunStore store = RunStore::create(dir, test::run_of({cell}).info, {});
  store.append(cell);
  expect_same_lists(read_cells(dir).at(0), cell);
  store.append(cell);  // again: replaced, not added to
  expect_same_lists(read_cells(dir).at(0), cell);
}

TEST_F(StoreTest, AWorkersLineReadsBack) {
  CellResult cell = cell_with_lists();
  cell.outcome = Outcome::kFell;
  cell.reason = "trunk \"low\"";
  cell.state_hash = 0xFEDCBA9876543210ULL;
  cell.wall_s = 0.1;
  cell.metrics.qp_failures = 3;
  const std::string line = cell_to_line(cell);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const CellResult back = cell_from_line(line);
  expect_same_lists(back, cell);
  EXPECT_EQ(back.key, cell.key);
  EXPECT_EQ(back.outcome, cell.outcome);
  EXPECT_EQ(back.reason, cell.reason);
  EXPECT_EQ(back.state_hash, cell.state_hash);
  EXPECT_EQ(back.wall_s, cell.wall_s);
  EXPECT_EQ(back.metrics.com_error_max_m, cell.metrics.com_error_max_m);
  EXPECT_EQ(back.metrics.qp_failures, 3);
  EXPECT_THAT(test::store_error([&] { cell_from_line(line.substr(1)); }), HasSubstr("cannot be read"));
}

TEST_F(StoreTest, TimingsReadBackInTheOrderOfTheRunAndTheLastOneCounts) {
  const CellKey a = key("s", "", "a", "-", 1), b = key("s", "", "b", "-", 1);
  RunStore store = RunStore::create(dir, info_of({a, b}), {});
  store.append(CellTiming{b, 1.0, 2.0, 3.0, 4.0, 5.0, 5.5, 6.0});
  store.append(CellTiming{a, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0});
  store.append(timing_from_line(timing_to_line({a, 0.1, 0.2, 0.3, 0.4, 0.5, 0.55, 0.6})));
  const std::vector<CellTiming> timings = read_run(dir).timings;
  ASSERT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings[0].key, a);
  EXPECT_EQ(timings[0].tick_p50_us, 0.1);
  EXPECT_EQ(timings[0].real_time_factor, 0.6);
  EXPECT_EQ(timings[1].key, b);
  EXPECT_EQ(timings[1].tick_max_us, 3.0);
  EXPECT_EQ(timings[1].qp_p99_us, 5.0);
  EXPECT_EQ(timings[1].qp_max_us, 5.5);
  EXPECT_EQ(timings[1].tick_histogram, TimeHistogram()) << "none was given";
  EXPECT_TRUE(read_cells(dir).empty());
}

TEST_F(StoreTest, HistogramsReadBackAndAreReplacedWithTheirTiming) {
  const CellKey a = key("s", "", "a", "-", 1), b = key("s", "", "b", "-", 1);
  const TimeHistogram tick{{1.0, 2.0, 4.0, 8.0}, {3, 0, 7}}, qp{{0.1, 0.3}, {12}}, later{{5.0, 6.0}, {1}};
  RunStore store = RunStore::create(dir, info_of({a, b}), {});
  store.append(CellTiming{.key = a, .tick_histogram = later, .qp_histogram = later});
  store.append(CellTiming{.key = b, .qp_histogram = later});
  store.append(timing_from_line(timing_to_line({.key = a, .tick_histogram = tick, .qp_histogram = qp})));
  const std::vector<CellTiming> timings = read_run(dir).timings;
  ASSERT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings[0].tick_histogram, tick);
  EXPECT_EQ(timings[0].qp_histogram, qp);
  EXPECT_EQ(timings[1].tick_histogram, TimeHistogram());
  EXPECT_EQ(timings[1].qp_histogram, later);
}

TEST_F(StoreTest, ARunFromBeforeHistogramsWereKeptHasNoneUntilItIsTimedAgain) {
  const CellKey a = key("s", "", "a", "-", 1);
  RunStore store = RunStore::create(dir, info_of({a}), {});
  store.append(CellTiming{.key = a, .tick_p50_us = 1.0, .tick_histogram = {{1.0, 2.0}, {5}}});
  SQLite::Database(dir / "run.sqlite", SQLite::OPEN_READWRITE).exec("DROP TABLE timing_histogram");
  const std::vector<CellTiming> before = read_run(dir).timings;
  ASSERT_EQ(before.size(), 1U);
  EXPECT_EQ(before[0].tick_p50_us, 1.0);
  EXPECT_TRUE(before[0].tick_histogram.counts.empty());
  store.append(CellTiming{.key = a, .tick_histogram = {{1.0, 2.0}, {6}}});
  EXPECT_EQ(read_run(dir).timings.at(0).tick_histogram.counts, std::vector<long>{6});
}

TEST_F(StoreTest, SourcesOfTheCellsReadBack) {
  RunInfo info = info_of({key("case1", "knee", "a", "x", 1), key("case1", "knee", "b", "x", 1)});
  info.sources = {{"case1_knee", "[a]\ngain = 1\n"}, {"case1_knee", "[b]\n"}};
  { const RunStore store = RunStore::create(dir, info, {{"case1_knee", "duration_s = 1\n"}}); }
  const RunInfo back = read_run(dir).info;
  ASSERT_EQ(back.sources.size(), 2U);
  EXPECT_EQ(back.sources[0].scenario, "case1_knee");
  EXPECT_EQ(back.sources[0].observer, "[a]\ngain = 1\n");
  EXPECT_EQ(back.sources[1].observer, "[b]\n");
}

TEST_F(StoreTest, EveryResultNamesItsScenarioOptionsProgramAndMachine) {
  const CellResult cell = test::survived(key("case1", "knee", "a", "x", 1), 0.5);
  RunInfo info = info_of({cell.key});
  info.sources = {{"case1_knee", "[a]\n"}};
  RunStore::create(dir, info, {{"case1_knee", "duration_s = 1\n"}}).append(cell);
  SQLite::Database database((dir / "run.sqlite").string());
  SQLite::Statement row(database,
                        "SELECT scenario_hash, observer_options, version, commit_id, compiler, cpu, "
                        "com_error_max_m FROM overview");
  ASSERT_TRUE(row.executeStep());
  EXPECT_EQ(row.getColumn(0).getString(), fingerprint("duration_s = 1\n"));
  EXPECT_EQ(row.getColumn(1).getString(), "[a]\n");
  EXPECT_EQ(row.getColumn(2).getString(), info.version);
  EXPECT_EQ(row.getColumn(3).getString(), info.commit);
  EXPECT_EQ(row.getColumn(4).getString(), info.compiler);
  EXPECT_EQ(row.getColumn(5).getString(), info.machine.cpu);
  EXPECT_EQ(row.getColumn(6).getDouble(), 0.5);
}

TEST_F(StoreTest, CellsComeInTheOrderOfTheRunNotOfTheirEnds) {
  const CellResult a = test::survived(key("s", "", "a", "-", 1), 1.0);
  const CellResult b = test::survived(key("s", "", "b", "-", 1), 2.0);
  const CellResult c = test::survived(key("s", "", "a", "-", 2), 3.0);
  RunStore store = RunStore::create(dir, test::run_of({b, c, a}).info, {});
  for (const CellResult& cell : {a, b, c}) store.append(cell);
  std::vector<CellKey> keys;
  for (const CellResult& cell : read_cells(dir)) keys.push_back(cell.key);
  EXPECT_THAT(keys, ElementsAre(b.key, c.key, a.key));
}

TEST_F(StoreTest, LaterResultOfTheSameCellCounts) {
  const CellKey k = key("s", "", "a", "-", 1);
  RunStore store = RunStore::create(dir, info_of({k}), {});
  store.append(test::failed(k, "timeout"));
  store.append(test::survived(k, 0.5));
  const auto cells = read_cells(dir);
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].outcome, Outcome::kSurvived);
}

TEST_F(StoreTest, ThreadsAppendWholeCells) {
  std::vector<CellResult> cells;
  for (int seed = 1; seed <= 400; ++seed) cells.push_back(test::survived(key("s", "", "a", "-", seed), seed));
  RunStore store = RunStore::create(dir, test::run_of(cells).info, {});
  const auto append_every_fourth = [&](std::size_t first) {
    for (std::size_t i = first; i < cells.size(); i += 4) store.append(cells[i]);
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t first = 0; first < 4; ++first) threads.emplace_back(append_every_fourth, first);
  }
  const auto run = read_run(dir);
  EXPECT_EQ(run.cells.size(), cells.size());
  EXPECT_TRUE(run.notes.empty());
}

TEST_F(StoreTest, NumberedDirectoriesCountUpwards) {
  const std::filesystem::path root = temporary.path() / "results";
  EXPECT_EQ(RunStore::create_numbered(root, info_of({}), {}).dir(), root / "0001");
  EXPECT_EQ(RunStore::create_numbered(root, info_of({}), {}).dir(), root / "0002");
  std::filesystem::create_directory(root / "0041");
  std::filesystem::create_directory(root / "99-notes");
  EXPECT_EQ(RunStore::create_numbered(root, info_of({}), {}).dir(), root / "0042");
}

TEST_F(StoreTest, EmptyDirectoryIsTaken) {
  std::filesystem::create_directory(dir);
  { const RunStore store = RunStore::create(dir, info_of({}), {}); }
  EXPECT_TRUE(read_run(dir).cells.empty());
}

TEST_F(StoreTest, OpenedRunGoesOn) {
  const CellResult a = test::survived(key("s", "", "a", "-", 1), 1.0);
  const CellResult b = test::survived(key("s", "", "b", "-", 1), 2.0);
  {
    RunStore store = RunStore::create(dir, test::run_of({a, b}).info, {});
    store.append(a);
  }
  RunStore::open(dir, {}).append(b);
  EXPECT_EQ(read_cells(dir).size(), 2U);
}

}  // namespace
}  // namespace dob::store_test
