// An observer plugin that does its worst in a batch: its row says what it did, and the others are what they are without
// it, byte for byte.
#include <csignal>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/store.h"
#include "test/bench/command_line.h"

namespace dob::plugin_faults_test {
namespace {

using test::Answer;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kPlugin = DOB_PLUGIN_DIR "/misbehaves.so";

// All of a cell but how long it took, by observer.
std::map<std::string, std::string> cells_of(const std::filesystem::path& run) {
  std::map<std::string, std::string> cells;
  for (CellResult cell : read_cells(run)) {
    cell.wall_s = 0.0;
    cells[cell.key.observer] = cell_to_line(cell);
  }
  return cells;
}

class PluginFaults : public test::CommandLine {
 protected:
  // In `dir`, where the program ran: what a plugin has left behind on purpose.
  void TearDown() override {
    pid_t left_behind = 0;
    if (std::ifstream(dir / "LEFT_BEHIND") >> left_behind && left_behind > 0) ::kill(left_behind, SIGKILL);
    CommandLine::TearDown();
  }

  static std::string with(const std::vector<std::string>& ways) {
    std::string options;
    for (const std::string& how : ways) options += " --observer '" + (kPlugin + (":how=" + how)) + "'";
    return options;
  }

  // Runs the plugin in each of these ways, with good observers before and after it, and expects its rows to have these
  // reasons (empty: it is a result like any other).
  void expect_reasons(const std::map<std::string, std::string>& reasons, const std::string& more = "") const {
    std::vector<std::string> ways;
    int errors = 0;
    for (const auto& [how, reason] : reasons) {
      ways.push_back(how);
      if (!reason.empty()) ++errors;
    }
    const std::string what = "run undisturbed --profile matched --set duration_s=0.2 --keep all --observer momentum ";
    ASSERT_EQ(dobbench(what + "--observer none --out good").exit_code, 0);
    const Answer answer = dobbench(what + with(ways) + " --observer none --out bad " + more);
    EXPECT_EQ(answer.exit_code, errors > 0 ? 3 : 0) << answer.err;
    EXPECT_THAT(answer.out, AllOf(HasSubstr("run directory: bad"), Not(HasSubstr("printed"))));
    std::map<std::string, CellResult> cells;
    for (const CellResult& cell : read_cells(dir / "bad")) cells[cell.key.observer] = cell;
    for (const auto& [how, reason] : reasons) {
      const CellResult& cell = cells.at("misbehaves:how=" + how);
      EXPECT_EQ(cell.outcome == Outcome::kError, !reason.empty()) << how << ": " << cell.reason;
      EXPECT_THAT(cell.reason, HasSubstr(reason)) << how;
      EXPECT_THAT(in_one_line(answer.out), HasSubstr(reason)) << how;
    }
    const auto good = cells_of(dir / "good");
    auto others = cells_of(dir / "bad");
    ASSERT_EQ(good.size(), 2U);
    for (const auto& [observer, cell] : good) EXPECT_EQ(cell, without_place(others.at(observer))) << observer;
  }

 private:
  // The table breaks long lines.
  static std::string in_one_line(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    for (std::string word; in >> word;) line += word + ' ';
    return line;
  }

  // The name of a trace begins with the cell's place in its run, and there the plugin's rows stand before "none".
  static std::string without_place(std::string cell) {
    const std::string place = "traces/";
    const std::size_t at = cell.find(place);
    return at == std::string::npos
               ? cell
               : cell.replace(at + place.size(), 5, cell.find("_none_") == std::string::npos ? "00001" : "00002");
  }
};

TEST_F(PluginFaults, EveryOneOfThemIsARowWithTheReasonAndTheOthersStayAsTheyAre) {
  std::map<std::string, std::string> reasons{
      {"abort", "crashed: Aborted"},
      {"exit", "ended without a result, exit code 0"},
      {"flood", "sent home more than 64 MB"},
      {"fork_and_exit", "ended without a result, exit code 0"},
      {"garbage", "bytes that are no result"},
      {"nan_com", "the estimate of misbehaves:how=nan_com is not finite at 0.1"},
      {"nan_legs", "the estimate of misbehaves:how=nan_legs is not finite at 0.1"},
      {"segfault", "crashed: Segmentation fault"},
      {"throw", "threw where nothing may be thrown: out of ideas"},
      {"truncate", "sent home 21 bytes that are no result"},
      // What these do harms nobody: their rows are results.
      {"fork", ""},
      {"not", ""},
      {"print", ""},
  };
#if !defined(DOB_SANITIZED)
  reasons["allocate"] = "out of memory: the limit is 4000 MB (--memory-limit)";
#endif
  expect_reasons(reasons);
}

// Nobody waits for a process that has made itself independent.
TEST_F(PluginFaults, OneThatLeavesAProcessInASessionOfItsOwnKeepsNobodyWaiting) {
  expect_reasons({{"daemon", ""}});
}

TEST_F(PluginFaults, OnesThatHangEndAtTheirTimeout) {
  const Answer answer = dobbench("run undisturbed --set duration_s=0.2 --timeout 0.5 --out hung" +
                                 with({"sleep", "close", "stop", "leave_group"}));
  EXPECT_EQ(answer.exit_code, 3) << answer.err;
  const auto cells = read_cells(dir / "hung");
  ASSERT_EQ(cells.size(), 4U);
  for (const CellResult& cell : cells) EXPECT_EQ(cell.reason, "timeout after 0.5 s") << cell.key.observer;
}

TEST_F(PluginFaults, OneThatCrashesOrHangsWhileItIsAnalysedIsALineAndTheOthersAreAnalysed) {
  const std::string plugin(kPlugin);
  const Answer answer = dobbench("analyse --json --profile paper --timeout 5 '" + plugin + ":how=segfault' momentum '" +
                                 plugin + ":how=sleep'");
  EXPECT_EQ(answer.exit_code, 3);
  EXPECT_THAT(answer.err, HasSubstr("misbehaves:how=segfault, profile -: crashed: Segmentation fault\n"));
  EXPECT_THAT(answer.err, HasSubstr("misbehaves:how=sleep, profile -: timeout after 5 s\n"));
  const auto rows = nlohmann::json::parse(answer.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows.at(0).at("observer"), "momentum");
}

// Finite itself, but nothing that can be measured by it is; and no path takes it to the controller.
TEST_F(PluginFaults, ACellOfWhichAMetricIsNotFiniteIsNoSurvivor) {
  const Answer answer = dobbench("run undisturbed --set duration_s=0.2 --out run --observer '" + std::string(kPlugin) +
                                 ":how=huge,routing.wrench_17=false,routing.dynamics_18=false' --observer none");
  EXPECT_EQ(answer.exit_code, 3) << answer.err;
  EXPECT_EQ(read_cells(dir / "run").at(0).outcome, Outcome::kError);
  EXPECT_EQ(read_cells(dir / "run").at(0).reason, "com_moment_rmse_Nm is not finite");
  const auto rows = nlohmann::json::parse(dobbench("table run --format json").out);
  EXPECT_EQ(rows.at(0).at("rank"), nullptr);
  EXPECT_EQ(rows.at(1).at("rank"), 1);
}

// The estimate of a shadow goes nowhere: that it is none is its own affair.
TEST_F(PluginFaults, AShadowWithoutAFiniteEstimateHasNoErrorAndTheCellStaysAsItIs) {
  const std::string what = "run undisturbed --observer momentum --profile matched --set duration_s=0.2 --keep none ";
  ASSERT_EQ(dobbench(what + "--out alone").exit_code, 0);
  ASSERT_EQ(dobbench(what + "--shadow '" + std::string(kPlugin) + ":how=nan_com' --out watched").exit_code, 0);
  const CellResult alone = read_cells(dir / "alone").at(0), watched = read_cells(dir / "watched").at(0);
  EXPECT_EQ(alone.state_hash, watched.state_hash);
  ASSERT_EQ(watched.shadows.size(), 1U);
  EXPECT_EQ(watched.shadows[0].com_force_rmse_N, 0.0);  // it was right about that
  EXPECT_EQ(watched.shadows[0].com_moment_rmse_Nm, std::nullopt);
}

}  // namespace
}  // namespace dob::plugin_faults_test
