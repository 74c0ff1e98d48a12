#include "results/store.h"

#include <bit>
#include <limits>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/metric_fields.h"
#include "test/results/run_samples.h"

namespace dob {
namespace {

using test::key;
using test::read_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class StoreTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path dir = temporary.path() / "run";

  static RunInfo info_of(std::vector<CellKey> cells) {
    return {"dobbench run case1 --set 'a=\"b\"'",
            "0.1.0",
            "0123abc",
            "Release",
            "g++ 12.2.0",
            "-O3",
            {"Some CPU @ 3 GHz", 2, "Debian 12"},
            "2026-01-02T03:04:05Z",
            std::move(cells)};
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

TEST_F(StoreTest, LineOfACellIsPlainJsonWithTheHashInHexAndNoWallTime) {
  CellResult cell = test::survived(key("case1", "knee", "none", "-", 3), 0.0125);
  cell.state_hash = 0xABCDEF;
  cell.wall_s = 2.5;
  RunStore store = RunStore::create(dir, test::run_of({cell}).info, {});
  store.append(cell);
  EXPECT_EQ(read_text(dir / "cells.jsonl"),
            R"({"scenario":"case1","variant":"knee","observer":"none","profile":"-","gains":"paper",)"
            R"("planner":"spline","seed":3,"overrides":"","outcome":"survived","reason":"","simulated_s":46.0,)"
            R"("state_hash":"0000000000abcdef","com_error_max_m":0.0125,"com_error_rms_m":null,)"
            R"("com_error_p99_m":null,"path_error_max_m":null,"foot_error_max_m":null,"foot_error_p99_m":null,)"
            R"("foot_error_onset_max_m":null,"foot_error_stance_max_m":null,"foothold_error_max_m":null,)"
            R"("grf_error_mean_N":null,"estimate_rmse_N":null,"joint_estimate_rmse_Nm":null,)"
            R"("orientation_error_max_rad":null,"torque_saturation_ratio":null,"slip_max_m":null,)"
            R"("estimate_offset_Nm":null,"estimate_overshoot":null,"estimate_settling_s":null,)"
            R"("com_error_swing_max_m":null,"com_error_stance_max_m":null,"com_peak_before_m":null,)"
            R"("com_peak_push_m":null,"com_peak_recovery_m":null,)"
            R"("foot_peak_push_m":null,"foot_peak_rest_m":null,)"
            R"("qp_solves":0,"qp_failures":0,"planner_failures":0})"
            "\n");
  EXPECT_THAT(read_text(dir / "timing.jsonl"), HasSubstr(R"("seed":3,"overrides":"","wall_s":2.5})"));
}

TEST_F(StoreTest, WhatIsNotFiniteIsNull) {
  CellResult cell = test::survived(key("s", "", "o", "-", 1), std::numeric_limits<double>::infinity());
  cell.metrics.slip_max_m = std::numeric_limits<double>::quiet_NaN();
  RunStore store = RunStore::create(dir, test::run_of({cell}).info, {});
  store.append(cell);
  EXPECT_THAT(read_text(dir / "cells.jsonl"), HasSubstr(R"("com_error_max_m":null)"));
  EXPECT_EQ(read_cells(dir).at(0).metrics.com_error_max_m, std::nullopt);
  EXPECT_EQ(read_cells(dir).at(0).metrics.slip_max_m, std::nullopt);
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

TEST_F(StoreTest, LaterLineOfTheSameCellCounts) {
  const CellKey k = key("s", "", "a", "-", 1);
  RunStore store = RunStore::create(dir, info_of({k}), {});
  store.append(test::failed(k, "timeout"));
  store.append(test::survived(k, 0.5));
  const auto cells = read_cells(dir);
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].outcome, Outcome::kSurvived);
}

TEST_F(StoreTest, ThreadsAppendWholeLines) {
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
  RunStore::open(dir).append(b);
  EXPECT_EQ(read_cells(dir).size(), 2U);
}

}  // namespace
}  // namespace dob
