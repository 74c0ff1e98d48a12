// The program as a user starts it: exit codes, messages, what is written.
#include "test/bench/command_line.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/store.h"

namespace {

namespace fs = std::filesystem;
using dob::test::Answer;
using dob::test::CommandLine;
using dob::test::read;

TEST_F(CommandLine, BadInputIsRefusedWithItsPlaceAndNothingIsWritten) {
  expect_refused("run nonsense", {"nonsense", "undisturbed"});
  expect_refused("run case1/nonsense", {"nonsense", "knee_lateral"});
  expect_refused("run missing.toml", {"missing.toml"});
  expect_refused("run undisturbed --observer nonsense", {"nonsense", "momentum"});
  expect_refused("run undisturbed --observer 'momentum:gains=17.5;6.28;2.25' --profile paper", {"unstable", "2.01"});
  expect_refused("run undisturbed --observer momentum:nonsense=1", {"nonsense"});
  expect_refused("run undisturbed --profile nonsense", {"nonsense", "paper"});
  expect_refused("run undisturbed --gains nonsense", {"nonsense", "swing300"});
  expect_refused("run undisturbed --planner nonsense", {"nonsense", "spline"});
  expect_refused("run undisturbed --set gait.nonsense=1", {"--set", "gait.nonsense"});
  expect_refused("run undisturbed --set gait.stance_s=-1", {"--set", "gait.stance_s", "-1"});
  expect_refused("run undisturbed --set gait.stance_s=nan", {"--set", "gait.stance_s"});
  expect_refused("run undisturbed --set robot.urdf=missing.urdf", {"missing.urdf"});
  expect_refused("run undisturbed --seeds 0", {"--seeds"});
  expect_refused("run undisturbed --seeds 5..2", {"--seeds"});
  expect_refused("run undisturbed --jobs 0", {"--jobs"});
  expect_refused("run --nonsense", {"nonsense"});
  expect_refused("table nowhere", {"nowhere"});
}

TEST_F(CommandLine, APluginThatCannotBeUsedIsRefusedInOneLine) {
  const std::string plugins = DOB_PLUGIN_DIR;
  const auto run = [&](const std::string& name) { return "run undisturbed --observer '" + plugins + "/" + name + "'"; };
  expect_refused("run undisturbed --observer missing.so", {"--observer missing.so", "there is no such file"});
  expect_refused(run("no_entry.so"), {"no_entry.so", "exports no function dob_observer_plugin()"});
  expect_refused(run("old_interface.so"), {"old_interface.so", "interface 0, this program needs 1"});
  expect_refused(run("other_layout.so"), {"other_layout.so", "ModelTerms of size"});
  expect_refused(run("throws.so"), {"throws.so", "its factory threw: out of ideas"});
  expect_refused(run("unresolved.so"), {"unresolved.so", "undefined symbol"});
  expect_refused(run("first_order.so:gian=1"), {"first_order", "gian", "gain_rad_s"});
  expect_refused("analyse '" + plugins + "/throws.so'", {"throws.so", "out of ideas"});
  expect_refused(run("first_order.so") + " --observer '" + plugins + "/first_order_twin.so'",
                 {"first_order_twin.so", "both called 'first_order'"});
}

TEST_F(CommandLine, APluginIsARowUnderItsOwnName) {
  const std::string file = std::string(DOB_PLUGIN_DIR) + "/first_order.so";
  ASSERT_EQ(dobbench("run undisturbed --set duration_s=0.3 --observer '" + file + "' --observer '" + file +
                     ":gain_rad_s=20' --jobs 2 --out run")
                .exit_code,
            0);
  const auto rows = nlohmann::json::parse(dobbench("table run --format json").out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["observer"], "first_order");
  EXPECT_EQ(rows[0]["profile"], "-");
  EXPECT_EQ(rows[1]["observer"], "first_order:gain_rad_s=20");
  for (const auto& row : rows) EXPECT_EQ(row["errors"], 0);
  // Measured from outside, it is the first-order filter that it is.
  const auto analysis = nlohmann::json::parse(dobbench("analyse --json '" + file + ":gain_rad_s=20'").out);
  ASSERT_EQ(analysis.size(), 1U);
  EXPECT_EQ(analysis[0]["method"], "measured");
  EXPECT_NEAR(analysis[0]["bandwidth_rad_s"].get<double>(), 20.0, 0.4);
  EXPECT_NEAR(analysis[0]["max_stable_dt_s"].get<double>(), 0.1, 2e-3);
}

TEST_F(CommandLine, AnalyseSaysThatThePrintedGainsAreUnstableAndWhatTheReversedOrderGives) {
  const Answer text = dobbench("analyse");
  EXPECT_EQ(text.exit_code, 0);
  for (const char* part : {"the paper's gains as printed, K = 17.5; 6.28; 2.25 rad/s, are unstable",
                           "poles +2.01 +- 5.95j", "in reversed order", "0.573 Hz"}) {
    EXPECT_NE(text.out.find(part), std::string::npos) << part;
  }
  const auto all = nlohmann::json::parse(dobbench("analyse --json").out);
  const auto& printed = all.back();
  EXPECT_EQ(printed["stable"], false);
  EXPECT_EQ(printed["discrete_stable"], false);
  EXPECT_EQ(printed["routh"]["stable"], false);
  EXPECT_NEAR(printed["poles"][0][0].get<double>(), 2.013, 1e-3);
  EXPECT_NEAR(printed["poles"][0][1].get<double>(), 5.945, 1e-3);
  EXPECT_TRUE(printed["bandwidth_rad_s"].is_null());
  const auto paper = nlohmann::json::parse(dobbench("analyse momentum --profile paper --json").out);
  ASSERT_EQ(paper.size(), 1U);
  EXPECT_NEAR(paper[0]["bandwidth_rad_s"].get<double>(), 3.6, 0.01);
  for (const char* key : {"poles", "stable", "routh", "delay_s", "overshoot", "settling_time_s", "noise_gain",
                          "discrete_stable", "max_stable_dt_s"}) {
    EXPECT_TRUE(paper[0].contains(key)) << key;
  }
  expect_refused("analyse 'momentum:gains=17.5;6.28;2.25' --profile paper", {"unstable", "allow_unstable"});
  expect_refused("analyse --tick 0", {"--tick"});
}

TEST_F(CommandLine, AScenarioFileIsRefusedWithLineAndColumn) {
  std::ofstream(dir / "mine.toml") << "summary = \"mine\"\nduration_s = 1.0\n\n[gait]\nstance_s = \"long\"\n"
                                      "\n[[path]]\nduration_s = 1.0\nspeed_m_s = 0.1\n";
  expect_refused("run mine.toml", {"mine.toml:5:", "gait.stance_s", "long"});
  std::ofstream(dir / "torn.toml") << "summary = \"mine\"\n[gait\n";
  expect_refused("run torn.toml", {"torn.toml:2:"});
}

TEST_F(CommandLine, TheTableDoesNotDependOnTheNumberOfJobs) {
  const std::string what =
      "run undisturbed case1/tip_lateral --observer none --observer momentum_com --set duration_s=1.5 --seeds 2 ";
  ASSERT_EQ(dobbench(what + "--jobs 1 --out one").exit_code, 0);
  ASSERT_EQ(dobbench(what + "--jobs 3 --out three").exit_code, 0);
  const Answer one = dobbench("table one --format json");
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(one.out, dobbench("table three --format json").out);
  const auto rows = nlohmann::json::parse(one.out);
  EXPECT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0]["runs"], 2);
  // The same state hashes, cell by cell.
  const auto hashes = [this](const char* run) {
    std::map<dob::CellKey, std::uint64_t> hash;
    for (const dob::CellResult& cell : dob::read_cells(dir / run)) hash[cell.key] = cell.state_hash;
    return hash;
  };
  EXPECT_EQ(hashes("one").size(), 12U);
  EXPECT_EQ(hashes("one"), hashes("three"));
}

TEST_F(CommandLine, ARunDirectoryHoldsWhatIsNeededToRunItAgain) {
  ASSERT_EQ(dobbench("run case1/knee_lateral --observer none --set duration_s=0.5 --log csv").exit_code, 0);
  const fs::path run = dir / "dobbench-results" / "0001";
  const dob::RunInfo info = dob::read_run_info(run);
  EXPECT_NE(info.command_line.find("case1/knee_lateral"), std::string::npos);
  for (const std::string& text : {info.version, info.commit, info.compiler, info.machine.cpu, info.date}) {
    EXPECT_NE(text, "");
  }
  EXPECT_NE(info.sources.at(0).scenario, "");
  int scenarios = 0;
  for (const auto& file : fs::directory_iterator(run / "scenarios")) {
    ++scenarios;
    const Answer again = dobbench("run '" + file.path().string() + "' --observer none --out again");
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(dob::read_cells(run).at(0).state_hash, dob::read_cells(dir / "again").at(0).state_hash);
  }
  EXPECT_EQ(scenarios, 1);
  int logs = 0;
  for (const auto& file : fs::directory_iterator(run / "logs")) {
    ++logs;
    const std::string text = read(file.path());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 501);  // header and one line a tick
  }
  EXPECT_EQ(logs, 1);
}

TEST_F(CommandLine, ListsWhatThereIs) {
  const Answer text = dobbench("list");
  EXPECT_EQ(text.exit_code, 0);
  for (const char* name : {"case1", "undisturbed", "momentum", "paper", "stiff"}) {
    EXPECT_NE(text.out.find(name), std::string::npos) << name;
  }
  const auto json = nlohmann::json::parse(dobbench("list observers --json").out);
  EXPECT_EQ(json["observers"][0]["name"], "none");
  EXPECT_EQ(dobbench("--version").exit_code, 0);
}

}  // namespace
