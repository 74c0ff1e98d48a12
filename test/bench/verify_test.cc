// `dobbench verify`: what is the same says so, whatever way it was computed; what is not is named.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sys/stat.h>
#include <thread>

#include <gmock/gmock.h>

#include "results/store.h"
#include "test/bench/command_line.h"

namespace dob::verify_test {
namespace {

namespace fs = std::filesystem;
using test::Answer;
using ::testing::AllOf;
using ::testing::HasSubstr;

// Six short cells: a pair, options, shadows, two seeds.
constexpr const char* kWhat =
    "run case1/tip_lateral --observer none --observer momentum:gain_scale=2 --observer legs=momentum,com=com_wrench "
    "--shadow eso,com_kalman:linear_process=0.5 --profile paper --seeds 2 --set duration_s=0.3 ";
constexpr const char* kTwo = "run undisturbed --observer none --seeds 2 --set duration_s=0.2 ";

class VerifyCommand : public test::CommandLine {
 protected:
  // The one row that `change` was applied to, appended again by the program that `now` says.
  void rewrite(const char* run, std::size_t cell, const std::function<void(CellResult&, RunInfo&)>& change) const {
    RunInfo now = read_run_info(dir / run);
    CellResult row = read_cells(dir / run).at(cell);
    change(row, now);
    RunStore::open(dir / run, now).append(row);
  }

  // A run of the same plan and program as `run`, of which the first `finished` cells are there.
  void copy_part(const char* run, const char* part, std::size_t finished) const {
    const dob::Run whole = read_run(dir / run);
    std::vector<ResolvedScenario> scenarios;
    for (const auto& file : fs::directory_iterator(dir / run / "scenarios")) {
      scenarios.push_back(read_resolved(dir / run, file.path().stem().string()));
    }
    RunStore store = RunStore::create(dir / part, whole.info, scenarios);
    for (std::size_t i = 0; i < finished; ++i) store.append(whole.cells.at(i));
  }

  void expect_all_equal(const std::string& arguments, std::size_t cells) const {
    const Answer answer = dobbench("verify " + arguments + " --sample 0 --format csv");
    EXPECT_EQ(answer.exit_code, 0) << answer.out << answer.err;
    EXPECT_EQ(std::count(answer.out.begin(), answer.out.end(), '\n'), static_cast<long>(cells) + 1) << answer.out;
    std::size_t equal = 0;
    for (std::size_t at = 0; (at = answer.out.find(",equal,\n", at)) != std::string::npos; ++at) ++equal;
    EXPECT_EQ(equal, cells) << answer.out;
  }
};

TEST_F(VerifyCommand, RunsOfAnyNumberOfJobsAreEqualWithPairsOptionsShadowsAndSeeds) {
  const std::string what = kWhat;
  ASSERT_EQ(dobbench(what + "--gains paper --gains stiff --jobs 2 --out two").exit_code, 0);
  expect_all_equal("two --jobs 1", 12);
  ASSERT_EQ(dobbench(what + "--jobs 1 --keep all --out one").exit_code, 0);
  expect_all_equal("one --jobs 2", 6);
  const Answer text = dobbench("verify one --sample 4 --seed 9");
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr("one: 4 of 6 finished cells computed again (a sample, seed 9)"));
}

TEST_F(VerifyCommand, FallsAndErrorsAreRowsLikeOthers) {
  ASSERT_EQ(dobbench("run undisturbed --observer none --set duration_s=3 --set controller.printed_sign_21=true "
                     "--keep none --out fell")
                .exit_code,
            0);
  ASSERT_EQ(read_cells(dir / "fell").at(0).outcome, Outcome::kFell);
  expect_all_equal("fell", 1);
  ASSERT_EQ(dobbench("run case3/left_30 --observer none --set duration_s=0.05 --keep none --out error").exit_code, 3);
  ASSERT_THAT(read_cells(dir / "error").at(0).reason, HasSubstr("a disturbance waited"));
  expect_all_equal("error", 1);
}

TEST_F(VerifyCommand, ARunThatWasKilledAndGoneOnWithIsEqual) {
  const std::string what = kWhat;
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string command =
        "cd '" + dir.string() + "' && exec '" DOBBENCH "' " + what + "--jobs 1 --out run >/dev/null 2>&1";
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  for (int i = 0; i < 3000; ++i) {  // until a cell is there
    if (is_run_directory(dir / "run") && !read_cells(dir / "run").empty()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ASSERT_FALSE(read_cells(dir / "run").empty());
  ASSERT_EQ(dobbench(what + "--jobs 2 --out run --resume").exit_code, 0);
  expect_all_equal("run", 6);
}

TEST_F(VerifyCommand, AnAlteredHashIsADifferenceAndItsCellIsNamed) {
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  rewrite("run", 1, [](CellResult& cell, RunInfo&) { cell.state_hash ^= 0x10U; });
  const Answer answer = dobbench("verify run");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_THAT(answer.out, AllOf(HasSubstr("undisturbed"), HasSubstr("state hash"), HasSubstr("different")));
  EXPECT_THAT(dobbench("verify run --format csv").out,
              AllOf(HasSubstr("none,-,paper,zmp,duration_s=0.2,1,equal,"), HasSubstr(",2,different,\"state hash")));
}

TEST_F(VerifyCommand, AMetricOrAnOutcomeThatTheCellDoesNotHaveIsFound) {
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  rewrite("run", 0, [](CellResult& cell, RunInfo&) { *cell.metrics.com_error_max_m *= 0.5; });
  rewrite("run", 1, [](CellResult& cell, RunInfo&) {
    cell.outcome = Outcome::kFell;
    cell.reason = "trunk low";
  });
  const Answer answer = dobbench("verify run --format csv");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_THAT(answer.out,
              AllOf(HasSubstr(",1,different,\"the same trajectory by its hash"), HasSubstr("com_error_max_m"),
                    HasSubstr(",2,outcome flipped,\"fell at 0.2 s (trunk low) stored")));
}

TEST_F(VerifyCommand, RowsOfAnotherCodePathAreRefusedUnlessAskedFor) {
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  rewrite("run", 1, [](CellResult& cell, RunInfo& now) {
    now.code_path.model = "quantum";
    cell.state_hash ^= 0x10U;
    *cell.metrics.com_error_max_m *= 1.0 + 1e-9;
  });
  expect_refused("verify run", {"run: cannot be compared bit for bit", "model path: 'quantum' there", "--across"});
  const Answer across = dobbench("verify run --across");
  EXPECT_EQ(across.exit_code, 0) << across.err;
  EXPECT_THAT(across.out, AllOf(HasSubstr("model path: 'quantum' there"), HasSubstr("com_error_max_m"),
                                HasSubstr("1.0e-09"), HasSubstr("outcome flipped      0")));
  rewrite("run", 1, [](CellResult& cell, RunInfo& now) {
    now.code_path.model = "quantum";
    cell.outcome = Outcome::kFell;
  });
  EXPECT_EQ(dobbench("verify run --across").exit_code, 1);
}

// The C library is told to do without what its fast functions need: another code path of the same program.
TEST_F(VerifyCommand, TheProcessorsFlagsThatTheCLibraryChoosesByAreOnRecord) {
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  ASSERT_NE(read_run_info(dir / "run").code_path.cpu_flags, "none");
  ::setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX,-SSE4_1", 1);
  const Answer refused = dobbench("verify run");
  const Answer across = dobbench("verify run --across");
  ::unsetenv("GLIBC_TUNABLES");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("CPU flags: '"), HasSubstr("'none' here")));
  EXPECT_EQ(across.exit_code, 0) << across.err << across.out;
  EXPECT_THAT(across.out, HasSubstr("outcome flipped      0"));
  EXPECT_EQ(dobbench("verify run").exit_code, 0);
}

TEST_F(VerifyCommand, OfAnIncompleteRunWhatIsFinishedIsVerified) {
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  copy_part("run", "part", 1);
  const Answer answer = dobbench("verify part");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_THAT(answer.out, AllOf(HasSubstr("part: 1 of 1 finished cells"), HasSubstr("1 of 2 planned cells are not")));
  copy_part("run", "empty", 0);
  expect_refused("verify empty", {"empty: holds no finished cell"});
}

TEST_F(VerifyCommand, WhatIsNoRunOrHasBeenChangedIsRefused) {
  fs::create_directory(dir / "other");
  expect_refused("verify other", {"other: is not a run directory"});
  expect_refused("verify nowhere", {"nowhere: no such directory"});
  expect_refused("verify", {"dir is required"});
  expect_refused("verify other --sample some", {"--sample"});
  expect_refused("verify other --format json", {"--format"});
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  std::ofstream(dir / "run/scenarios/undisturbed_paper.toml", std::ios::app) << "# innocent\n";
  expect_refused("verify run", {"undisturbed_paper.toml: is not the scenario that the run began with"});
  fs::remove(dir / "run/scenarios/undisturbed_paper.toml");
  expect_refused("verify run", {"undisturbed_paper.toml: cannot be opened"});
}

// A run directory may come from anybody: what never ends is not waited for.
TEST_F(VerifyCommand, AResolvedScenarioThatIsNoFileIsRefused) {
  ASSERT_EQ(dobbench(std::string(kTwo) + "--out run").exit_code, 0);
  const fs::path file = dir / "run/scenarios/undisturbed_paper.toml";
  fs::remove(file);
  fs::create_symlink("/dev/zero", file);
  expect_refused("verify run", {"undisturbed_paper.toml: is a symbolic link"});
  fs::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  expect_refused("verify run", {"undisturbed_paper.toml: is a special file"});
}

TEST_F(VerifyCommand, TodaysScenariosAndProfilesDoNotMatterButTheRobotDoes) {
  fs::copy_file(DOB_SOURCE_DIR "/robot/dogbot/dogbot.urdf", dir / "robot.urdf");
  std::ofstream(dir / "mine.toml") << "base = \"undisturbed\"\nsummary = \"x\"\n";
  ASSERT_EQ(dobbench("run mine.toml --observer none --set 'robot.urdf=\"robot.urdf\"' --set duration_s=0.2 --out run")
                .exit_code,
            0);
  fs::remove(dir / "mine.toml");
  expect_all_equal("run", 1);
  std::ofstream(dir / "robot.urdf", std::ios::app) << "<!-- -->";
  const Answer answer = dobbench("verify run");
  EXPECT_EQ(answer.exit_code, 3);
  EXPECT_THAT(answer.out, AllOf(HasSubstr("not verified"), HasSubstr("robot.urdf: is not the robot")));
}

TEST_F(VerifyCommand, ACellThatWasOrIsEndedByTheClockIsNotVerified) {
  const std::string what = "run undisturbed --observer none --set duration_s=60 --keep none ";
  ASSERT_EQ(dobbench(what + "--timeout 0.05 --out run").exit_code, 3);
  const Answer then = dobbench("verify run --format csv --timeout 0.05");
  EXPECT_EQ(then.exit_code, 3);
  EXPECT_THAT(then.out, HasSubstr("not verified,the stored row is a timeout"));
  ASSERT_EQ(dobbench("run --resume --retry-errors --out run").exit_code, 0);
  const Answer now = dobbench("verify run --format csv --timeout 0.05");
  EXPECT_EQ(now.exit_code, 3);
  EXPECT_THAT(now.out, HasSubstr("not verified,could not be run again: timeout after 0.05 s"));
}

// A plugin is code: it is loaded if the user names it here, and holds what it held then.
TEST_F(VerifyCommand, PluginsAreLoadedOnlyWhenTheyAreNamed) {
  fs::copy_file(DOB_PLUGIN_DIR "/first_order.so", dir / "mine.so");
  ASSERT_EQ(dobbench("run undisturbed --set duration_s=0.1 --profile paper --observer ./mine.so:gain_rad_s=20 "
                     "--observer none --observer legs=./mine.so,com=com_wrench --out run")
                .exit_code,
            0);
  ASSERT_EQ(dobbench("run undisturbed --set duration_s=0.1 --observer none --shadow ./mine.so --out shadow").exit_code,
            0);
  const Answer answer = dobbench("verify run --format csv");
  EXPECT_EQ(answer.exit_code, 3);
  EXPECT_THAT(answer.out, AllOf(HasSubstr("first_order:gain_rad_s=20,-,paper,zmp,duration_s=0.1,1,not verified,plugin"),
                                HasSubstr("none,-,paper,zmp,duration_s=0.1,1,equal"),
                                HasSubstr("com=com_wrench\",paper,paper,zmp,duration_s=0.1,1,not verified,plugin")));
  EXPECT_EQ(dobbench("verify shadow").exit_code, 3);
  fs::rename(dir / "mine.so", dir / "moved.so");
  expect_all_equal("run --plugin moved.so", 3);
  expect_all_equal("shadow --plugin ./moved.so", 1);
  std::ofstream(dir / "moved.so", std::ios::app) << "x";
  EXPECT_EQ(dobbench("verify run --plugin moved.so").exit_code, 3);
  expect_refused("verify run --plugin nowhere.so", {"--plugin", "nowhere.so"});
}

}  // namespace
}  // namespace dob::verify_test
