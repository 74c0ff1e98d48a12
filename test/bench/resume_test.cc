// Batches that are killed and gone on with: the same table, byte for byte.
#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include <nlohmann/json.hpp>

#include "results/store.h"
#include "test/bench/command_line.h"

namespace dob {
namespace {

using test::Answer;
using Clock = std::chrono::steady_clock;

constexpr const char* kWhat =
    "run undisturbed case1/tip_lateral --observer none --observer momentum_com --profile paper --profile matched "
    "--seeds 4 --set duration_s=0.4 --keep none ";

class Resume : public test::CommandLine {
 protected:
  // Starts dobbench, kills it after `delay` unless it has ended by then.
  void run_and_kill(const std::string& arguments, std::chrono::duration<double> delay) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const std::string command = "cd '" + dir.string() + "' && exec '" DOBBENCH "' " + arguments + " >/dev/null 2>&1";
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }

  std::map<CellKey, std::uint64_t> hashes(const char* run) const {
    std::map<CellKey, std::uint64_t> hash;
    for (const CellResult& cell : read_cells(dir / run)) hash[cell.key] = cell.state_hash;
    return hash;
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
  EXPECT_GT(run.timings[0].tick_p50_us, run.timings[0].qp_p50_us);
  EXPECT_GE(run.timings[0].tick_p99_us, run.timings[0].tick_p50_us);
  EXPECT_GE(run.timings[0].tick_max_us, run.timings[0].tick_p99_us);
  expect_refused("timing case1 --observer none --out run", {"does not belong to the run"});
}

}  // namespace
}  // namespace dob
