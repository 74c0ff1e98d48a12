// Batches that are killed and gone on with: the same table, byte for byte.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <thread>

#include <nlohmann/json.hpp>

#include "results/store.h"
#include "test/bench/command_line_children.h"

namespace dob::resume_test {
namespace {

using test::Answer;
using Clock = std::chrono::steady_clock;

constexpr const char* kWhat =
    "run undisturbed case1/tip_lateral --observer none --observer momentum_com --profile paper --profile matched "
    "--seeds 4 --set duration_s=0.4 --keep none ";

class Resume : public test::CommandLineChildren {
 protected:
  // Starts dobbench, kills it after `delay` unless it has ended by then.
  void run_and_kill(const std::string& arguments, std::chrono::duration<double> delay) const {
    const pid_t child = start(arguments);
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    wait_for(child);
  }
};

TEST_F(Resume, ABatchThatIsKilledAgainAndAgainEndsInTheSameTable) {
  const std::string what = kWhat;
  const auto start = Clock::now();
  ASSERT_EQ(dobbench(what + "--jobs 2 --out whole").exit_code, 0);
  const std::chrono::duration<double> whole = Clock::now() - start;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  int partial = 0;
  for (int i = 0; i < 8; ++i) {
    run_and_kill(what + "--jobs 2 --out killed --resume", share(random) * whole);
    if (!is_run_directory(dir / "killed")) continue;
    const auto run = read_run(dir / "killed");
    if (!run.cells.empty() && run.cells.size() < run.info.cells.size()) ++partial;
  }
  EXPECT_GT(partial, 0) << "no kill met a batch at work: this test has shown nothing";
  const Answer rest = dobbench(what + "--jobs 1 --out killed --resume");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  const Answer table = dobbench("table whole --format json");
  EXPECT_EQ(table.out, dobbench("table killed --format json").out);
  EXPECT_EQ(nlohmann::json::parse(table.out).at(0).at("runs"), 4);
  EXPECT_EQ(hashes("whole"), hashes("killed"));
}

TEST_F(Resume, WithNothingElseAskedForItGoesOnWithWhatBeganTheRun) {
  const std::string what = kWhat;
  ASSERT_EQ(dobbench(what + "--out whole").exit_code, 0);
  run_and_kill(what + "--out killed", std::chrono::milliseconds(400));
  if (!is_run_directory(dir / "killed")) {  // killed before it began: nothing to go on with
    ASSERT_EQ(dobbench(what + "--out killed").exit_code, 0);
  }
  const Answer rest = dobbench("run --resume --out killed --jobs 1");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(dobbench("table whole --format json").out, dobbench("table killed --format json").out);
}

TEST_F(Resume, AnotherPlanIsRefusedAndTheRunIsLeftAlone) {
  const std::string what = "run undisturbed --observer none --set duration_s=0.2 ";
  ASSERT_EQ(dobbench(what + "--out run").exit_code, 0);
  const std::string table = dobbench("table run --format json").out;
  expect_refused(what + "--out run", {"holds a run already"});
  expect_refused(what + "--seeds 2 --resume --out run", {"cannot be resumed", "1 of the cells asked for", "seed 2"});
  expect_refused("run undisturbed --observer none --set duration_s=0.3 --resume --out run",
                 {"cannot be resumed", "duration_s=0.2", "duration_s=0.3"});
  expect_refused(what + "--resume", {"--out"});
  EXPECT_EQ(dobbench("table run --format json").out, table);
}

TEST_F(Resume, CellsThatCouldNotBeRunStayUnlessAskedFor) {
  const std::string what = "run undisturbed --observer none --set duration_s=60 ";
  ASSERT_EQ(dobbench(what + "--timeout 0.05 --out run").exit_code, 3);
  EXPECT_EQ(dobbench(what + "--resume --out run").exit_code, 3);
  EXPECT_EQ(read_cells(dir / "run").at(0).outcome, Outcome::kError);
  EXPECT_EQ(dobbench("run --resume --retry-errors --out run").exit_code, 0);
  EXPECT_EQ(read_cells(dir / "run").at(0).outcome, Outcome::kSurvived);
}

TEST_F(Resume, ThereHasToBeARunToGoOnWith) {
  expect_refused("run --resume --out nowhere --jobs 1", {"--resume: nowhere holds no run"});
  expect_refused("run --resume", {"--resume", "--out"});
  EXPECT_FALSE(std::filesystem::exists(dir / "nowhere"));
}

TEST_F(Resume, OtherTimeSeriesMayBeKeptOfWhatIsLeft) {
  const std::string what = "run undisturbed --observer none --set duration_s=20 --keep none ";
  ASSERT_EQ(dobbench(what + "--timeout 0.05 --out run").exit_code, 3);
  expect_refused("run --resume --out run --log-rate 100", {"--log-rate", "--log csv"});
  ASSERT_EQ(dobbench("run --resume --retry-errors --keep all --log csv --log-rate 10 --out run").exit_code, 0);
  const CellResult cell = read_cells(dir / "run").at(0);
  EXPECT_TRUE(std::filesystem::exists(dir / "run" / cell.trace)) << cell.trace;
  const std::string log = test::read(std::filesystem::directory_iterator(dir / "run" / "logs")->path());
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 201);  // a header, and ten lines a second
}

// One byte behind the end of a library or a comment in a robot: what they are called is the same.
TEST_F(Resume, AnotherLibraryOrRobotOfTheSameNameIsRefused) {
  const auto change = [this](const char* file) { std::ofstream(dir / file, std::ios::app) << "<!-- -->"; };
  std::filesystem::copy_file(DOB_PLUGIN_DIR "/first_order.so", dir / "mine.so");
  std::filesystem::copy_file(DOB_SOURCE_DIR "/robot/dogbot/dogbot.urdf", dir / "robot.urdf");
  const std::string what = "run undisturbed --set 'robot.urdf=\"robot.urdf\"' --set duration_s=0.1 --observer ";
  const std::string plugin = what + "./mine.so --resume --out plugin";
  const std::string pair = what + "legs=./mine.so,com=com_wrench --profile paper --resume --out pair";
  const std::string shadow = what + "none --shadow ./mine.so --resume --out shadow";
  const std::string none = what + "none --resume --out none";
  for (const std::string& run : {plugin, pair, shadow, none}) {
    ASSERT_EQ(dobbench(run).exit_code, 0) << run;
    ASSERT_EQ(dobbench(run).exit_code, 0) << run;
  }
  change("mine.so");
  expect_refused(plugin, {"cannot be resumed", "the library of first_order"});
  expect_refused(pair, {"cannot be resumed", "the library of legs="});
  expect_refused(shadow, {"cannot be resumed", "the library of none"});
  EXPECT_EQ(dobbench(none).exit_code, 0);
  change("robot.urdf");
  expect_refused(none, {"cannot be resumed", "the scenario undisturbed_paper, or its robot"});
}

TEST_F(Resume, TimingIsKeptApartFromTheTable) {
  const std::string what = "run undisturbed --observer none --seeds 2 --set duration_s=0.4 ";
  ASSERT_EQ(dobbench(what + "--out run").exit_code, 0);
  const std::string before = dobbench("table run --format json").out;
  const Answer timing = dobbench("timing --out run --seconds 0.3");
  ASSERT_EQ(timing.exit_code, 0) << timing.err;
  EXPECT_NE(timing.out.find("undisturbed none"), std::string::npos) << timing.out;
  EXPECT_EQ(dobbench("table run --format json").out, before);
  const auto run = read_run(dir / "run");
  ASSERT_EQ(run.timings.size(), 1U);  // the first seed
  EXPECT_EQ(run.timings[0].key, run.info.cells[0]);
  EXPECT_GT(run.timings[0].qp_p50_us, 0.0);
  EXPECT_GT(run.timings[0].tick_p50_us, 0.0);  // of all ticks; most solve no QP
  EXPECT_GE(run.timings[0].tick_p99_us, run.timings[0].tick_p50_us);
  EXPECT_GE(run.timings[0].tick_max_us, run.timings[0].tick_p99_us);
  expect_refused("timing case1 --observer none --out run", {"does not belong to the run"});
}

}  // namespace
}  // namespace dob::resume_test
