// The program as a user starts it: exit codes, messages, what is written.
#include "test/bench/command_line.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/store.h"

namespace dob::command_line_test {
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
  expect_refused("run undisturbed --seeds 2147483647", {"--seeds 2147483647", "up to 1000000"});
  expect_refused("run undisturbed --seeds 2147483647..2147483647", {"--seeds 2147483647", "up to 1000000"});
  expect_refused("run undisturbed --observer none --observer momentum --seeds 1000000", {"--seeds", "cells"});
  expect_refused("run undisturbed --shadow nonsense", {"--shadow nonsense", "momentum"});
  expect_refused("run undisturbed --log-rate 10", {"--log-rate", "--log csv"});
  expect_refused("run undisturbed --jobs 0", {"--jobs"});
  expect_refused("run --nonsense", {"nonsense"});
  expect_refused("run \"--$(printf 'a\\033[31m\\nb')\"", {"--a\\x1b[31m\\x0ab"});
  expect_refused("table nowhere", {"nowhere"});
}

TEST_F(CommandLine, NumbersOutsideOfTheirRangeAreRefused) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> options{
      {"run undisturbed --seeds ",
       {"0", "-1", "1.5", "nan", "inf", "1e9", "1..1e9", "1..1000001", "99999999999999999999"}},
      {"run undisturbed --jobs ", {"0", "-1", "1025", "1.5", "nan", "inf", "99999999999999999999"}},
      {"run undisturbed --timeout ", {"-1", "nan", "-nan", "inf", "1e400", "1e10", "fast"}},
      {"run undisturbed --log csv --log-rate ", {"0", "nan", "inf", "1e7"}},
      {"analyse momentum --tick ", {"0", "-0.001", "nan", "inf", "1.1"}},
      {"timing undisturbed --seconds ", {"-1", "nan", "inf", "1e7"}},
      {"report . --max-size ", {"-1", "nan", "inf", "10001"}},
      {"tune momentum --out tuned --budget ", {"0", "nan", "inf", "100001"}},
  };
  for (const auto& [option, numbers] : options) {
    const std::string name = option.substr(option.rfind("--"), option.size() - 1 - option.rfind("--"));
    for (const std::string& number : numbers) expect_refused(option + number, {name, number});
  }
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
  EXPECT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows[0]["runs"], 2);
  // The same state hashes, cell by cell.
  const auto hashes = [this](const char* run) {
    std::map<dob::CellKey, std::uint64_t> hash;
    for (const dob::CellResult& cell : dob::read_cells(dir / run)) hash[cell.key] = cell.state_hash;
    return hash;
  };
  EXPECT_EQ(hashes("one").size(), 16U);
  EXPECT_EQ(hashes("one"), hashes("three"));
}

TEST_F(CommandLine, ARunIsAskedAboutEveryClaim) {
  ASSERT_EQ(dobbench("run order_study/standing --observer momentum:gains=6.28 --observer "
                     "'momentum:gains=6.28;6.28' --profile paper --set duration_s=0.1 --out run")
                .exit_code,
            0);
  const Answer answer = dobbench("table run --claims --format json");
  EXPECT_EQ(answer.exit_code, 0);
  const auto rows = nlohmann::json::parse(answer.out);
  EXPECT_GT(rows.size(), 50U);
  for (const auto& row : rows) EXPECT_EQ(row["holds"], nullptr) << row;  // nothing that the paper speaks of was run
  expect_refused("table run --recorded run", {"--claims"});
  for (const char* other : {"--shadow", "--timing", "--by observer", "--reference none"}) {
    expect_refused(std::string("table run --claims ") + other, {"--claims", std::string(other).substr(0, 4)});
  }
  expect_refused("table run --claims --recorded nowhere", {"nowhere"});
}

TEST_F(CommandLine, ARunDirectoryHoldsWhatIsNeededToRunItAgain) {
  ASSERT_EQ(dobbench("run case1/knee_lateral --observer none --set duration_s=0.5 --log csv").exit_code, 0);
  const fs::path run = dir / "dobbench-results" / "0001";
  const dob::RunInfo info = dob::read_run_info(run);
  EXPECT_NE(info.command_line.find("case1/knee_lateral"), std::string::npos);
  for (const std::string& text : {info.version, info.commit, info.compiler, info.machine.cpu, info.date}) {
    EXPECT_NE(text, "");
  }
  EXPECT_NE(info.sources.front().scenario, "");
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

TEST_F(CommandLine, CheckSaysWhatEveryFileIsAndWhatIsWrong) {
  const std::string project = DOB_SOURCE_DIR;
  const Answer good = dobbench("check '" + project + "/scenarios/case3.toml' '" + project +
                               "/scenarios/config/profiles/paper.toml' '" + project + "/robot/dogbot/dogbot.urdf'");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_EQ(good.err, "");
  for (const char* part : {"case3.toml: OK, scenario 'case3' of set paper, 10 to run", "paper.toml: OK, profile for ",
                           "dogbot.urdf: OK, robot description"}) {
    EXPECT_NE(good.out.find(part), std::string::npos) << part << ": " << good.out;
  }
  std::ofstream(dir / "mine.toml") << "summary = \"mine\"\nobservers = [\"none\", \"momentun\"]\n"
                                      "[[path]]\nduration_s = 1.0\nspeed_m_s = 0.1\n";
  std::ofstream(dir / "profile.toml") << "[momentum]\ngains = [2.25, 6.28, 17.5]\n[com_wrench]\nlinear_gain_rad = 3\n";
  std::ofstream(dir / "robot.urdf") << "<robot name=\"r\"></robot>";
  std::ofstream(dir / "tall.toml") << "base = \"undisturbed\"\nplanner.com_height_m = 0.9\n";
  expect_refused("check mine.toml", {"mine.toml:2:1", "momentun"});
  expect_refused("check profile.toml", {"profile.toml:4:1", "linear_gain_rad"});
  expect_refused("check robot.urdf", {"robot.urdf"});
  expect_refused("check tall.toml", {"tall", "cannot reach"});
  expect_refused("check notes.txt", {"notes.txt", ".urdf"});
  expect_refused("check missing.toml", {"missing.toml", "cannot be opened: No such file"});
  std::ofstream(dir / "named.toml") << "name = \"other\"\nbase = \"undisturbed\"\n";
  EXPECT_NE(dobbench("check named.toml").out.find("scenario 'other'"), std::string::npos);
  // The others are still checked.
  const Answer mixed = dobbench("check mine.toml '" + project + "/scenarios/case4.toml'");
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_NE(mixed.out.find("case4.toml: OK"), std::string::npos) << mixed.out;
}

TEST_F(CommandLine, ATrialWhosePushNeverComesIsARowWithItsReason) {
  const Answer answer = dobbench("run case3/left_10 --observer none --set duration_s=1.0 --out run");
  EXPECT_EQ(answer.exit_code, 3);
  const auto rows = nlohmann::json::parse(dobbench("table run --format json").out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["errors"], 1);
  EXPECT_NE(answer.out.find("waited for phase 0.1 of a swing of RF"), std::string::npos) << answer.out;
}

TEST_F(CommandLine, ADisturbanceThatNeverActsIsAnErrorOfAFileAndAWarningOfARunThatIsCutShort) {
  std::ofstream(dir / "late.toml") << "base = \"push_trunk\"\nduration_s = 3\n";
  expect_refused("check late.toml", {"push_trunk.toml:12:1: disturbance.0.start_s: 3 s", "over at 3 s"});
  const Answer run = dobbench("run push_trunk --observer none --set duration_s=0.2 --out run");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("never acts: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("push_trunk.toml:12:1"), std::string::npos) << run.err;
  EXPECT_EQ(dobbench("run undisturbed --observer none --set duration_s=0.2 --out other").err, "");
}

TEST_F(CommandLine, ListsTheScenariosWithTheirSet) {
  const auto json = nlohmann::json::parse(dobbench("list scenarios --json").out);
  for (const auto& scenario : json["scenarios"]) {
    const std::string name = scenario["name"];
    EXPECT_EQ(scenario["set"] == "paper", name == "order_study" || name.starts_with("case")) << name;
    if (name == "case2") {
      EXPECT_EQ(scenario["observers"].size(), 3U);
    }
  }
  const std::string text = dobbench("list scenarios").out;
  EXPECT_NE(text.find("case2"), std::string::npos);
  EXPECT_NE(text.find("extra"), std::string::npos);
}

TEST_F(CommandLine, ShadowsAreATableOfTheirOwnAndLeaveTheComparisonAsItIs) {
  const std::string what =
      "run case1/knee_lateral --observer momentum --observer none --profile matched "
      "--set duration_s=1 --seeds 2 ";
  ASSERT_EQ(dobbench(what + "--out plain").exit_code, 0);
  const Answer run = dobbench(what + "--shadow com_wrench,momentum:gain_scale=2 --shadow oracle_full --out watched");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("in the loop momentum (matched)"), std::string::npos);
  EXPECT_EQ(dobbench("table plain --format json").out, dobbench("table watched --format json").out);
  const auto rows = nlohmann::json::parse(dobbench("table watched --shadow --format json").out);
  ASSERT_EQ(rows.size(), 8U);  // two in the loop, each with three shadows
  EXPECT_EQ(rows[2]["shadow_observer"], "momentum:gain_scale=2");
  EXPECT_EQ(rows[2]["runs"], 2);
  EXPECT_GT(rows[2]["joint_estimate_rmse_Nm"], 0.0);
  EXPECT_EQ(rows[3]["com_force_rmse_N"], 0.0);
  expect_refused("table plain --shadow", {"--shadow"});
  expect_refused(what + "--shadow nonsense --out x", {"nonsense", "momentum"});
  expect_refused(what + "--shadow momentum, --out x", {"momentum"});
}

TEST_F(CommandLine, ComparesTwoRunsAndSaysNoWhenTheSecondIsWorse) {
  const std::string what = "run case1/tip_lateral --profile matched --set duration_s=2 --seeds 2 --observer ";
  ASSERT_EQ(dobbench(what + "none --out none").exit_code, 0);
  const Answer same = dobbench("compare none none");
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("0 of 1 rows are worse in B."), std::string::npos) << same.out;
  // A scenario file of one name with two contents makes one key with two meanings, as a changed program would.
  for (const char* speed : {"0.02", "0.3"}) {
    std::ofstream(dir / "mine.toml") << "summary = \"mine\"\n[[path]]\nduration_s = 2.0\nspeed_m_s = " << speed << "\n";
    ASSERT_EQ(dobbench("run mine.toml --observer none --seeds 2 --out " + std::string(speed)).exit_code, 0);
  }
  const Answer worse = dobbench("compare 0.02 0.3");
  EXPECT_EQ(worse.exit_code, 1) << worse.out << worse.err;
  EXPECT_NE(worse.out.find("1 of 1 rows are worse in B."), std::string::npos) << worse.out;
  EXPECT_EQ(dobbench("compare 0.3 0.02").exit_code, 0);
  ASSERT_EQ(dobbench(what + "momentum --out momentum").exit_code, 0);
  expect_refused("compare none momentum", {"share no cell"});
  expect_refused("compare none nowhere", {"nowhere"});
  expect_refused("compare none none --metric nonsense", {"--metric nonsense", "slip_max_m"});
  expect_refused("table none --reference momentum", {"momentum", "none@-"});
  const auto rows = nlohmann::json::parse(dobbench("table none --reference none --format json").out);
  EXPECT_EQ(rows[0]["rank"], 1);
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
}  // namespace dob::command_line_test
