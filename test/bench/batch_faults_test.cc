// Batches from outside: killed, stopped, twice at once, without room or permission to write.
#include <SQLiteCpp/SQLiteCpp.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/bench/command_line_children.h"

namespace dob::batch_faults_test {
namespace {

namespace fs = std::filesystem;
using test::Answer;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Clock = std::chrono::steady_clock;

// Two observers, this many seeds.
std::string batch(int seeds, double duration_s) {
  return fmt::format(
      "run undisturbed --observer none --observer momentum --profile matched --keep none --seeds {} --set "
      "duration_s={} ",
      seeds, duration_s);
}

class BatchFaults : public test::CommandLineChildren {
 protected:
  std::string table(const std::string& run) const { return dobbench("table " + run + " --format json").out; }

  // By SQLite itself.
  void expect_intact(const std::string& run) const {
    SQLite::Database database((dir / run / "run.sqlite").string(), SQLite::OPEN_READWRITE);
    EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok") << run;
  }

  // One line on stderr that holds every part.
  static void expect_one_line(const Answer& answer, const std::vector<std::string>& parts) {
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    for (const std::string& part : parts) EXPECT_THAT(answer.err, HasSubstr(part));
  }

  // dobbench with these shell words before it: a limit, another user.
  Answer dobbench_under(const std::string& before, const std::string& arguments) const {
    return dobbench("--version >/dev/null; " + before + " '" DOBBENCH "' " + arguments);
  }
};

TEST_F(BatchFaults, KilledAtTwentyRandomMomentsAndGoneOnWithItEndsInTheSameTable) {
  const std::string what = batch(6, 0.2);
  const auto start_time = Clock::now();
  ASSERT_EQ(dobbench(what + "--jobs 2 --out whole").exit_code, 0);
  const std::chrono::duration<double> whole = Clock::now() - start_time;
  const std::string expected = table("whole");
  const auto expected_hashes = hashes("whole");
  ASSERT_EQ(expected_hashes.size(), 12U);
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int met_at_work = 0;
  for (int i = 0; i < 20; ++i) {
    const std::string out = "killed" + std::to_string(i);
    const pid_t batch = start(what + "--jobs 2 --out " + out);
    std::this_thread::sleep_for(share(random) * whole);
    ::kill(batch, SIGKILL);
    wait_for(batch);
    if (is_run_directory(dir / out)) {
      expect_intact(out);
      const std::size_t finished = read_cells(dir / out).size();
      if (finished > 0 && finished < 12) ++met_at_work;
    }
    const Answer rest = dobbench(what + "--jobs 2 --out " + out + " --resume");
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(table(out), expected) << out;
    EXPECT_EQ(hashes(out), expected_hashes) << out;
  }
  EXPECT_GT(met_at_work, 0) << "no kill met a batch at work: this test has shown nothing";
}

TEST_F(BatchFaults, ASignalStopsItCleanlyAndItGoesOnLater) {
  const std::string what = batch(12, 0.5);
  ASSERT_EQ(dobbench(what + "--out whole").exit_code, 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = "stopped" + std::to_string(signal);
    const pid_t batch = start(what + "--jobs 1 --out " + out);
    ASSERT_TRUE(comes_true([&] { return is_run_directory(dir / out) && !read_cells(dir / out).empty(); }));
    ::kill(batch, signal);
    EXPECT_EQ(wait_for(batch), 128 + signal);
    expect_intact(out);
    EXPECT_LT(read_cells(dir / out).size(), 24U) << "it had ended before the signal came: this test has shown nothing";
    EXPECT_FALSE(fs::exists(dir / out / "run.sqlite-journal"));
    EXPECT_EQ(dobbench("run --resume --out " + out).exit_code, 0);
    EXPECT_EQ(table(out), table("whole"));
  }
}

TEST_F(BatchFaults, ASecondBatchOnTheSameDirectoryIsRefusedAndTheFirstDoesNotNotice) {
  const std::string what = "run undisturbed --observer none --set duration_s=5 --keep none --log csv --log-rate 1 ";
  const pid_t first = start(what + "--out run");
  ASSERT_TRUE(comes_true([&] { return fs::exists(dir / "run/logs"); }));  // from then on it holds the lock
  ::kill(first, SIGSTOP);                                                 // it holds the lock for as long as this takes
  for (const std::string& second : {what + "--out run --resume", std::string("run --resume --out run"),
                                    std::string("timing --seconds 0.2 --out run")}) {
    expect_refused(second, {"run: another batch (process " + std::to_string(first) + ") is writing it"});
  }
  expect_refused(what + "--out run", {"holds a run already"});
  ::kill(first, SIGCONT);
  EXPECT_EQ(wait_for(first), 0);
  EXPECT_EQ(read_cells(dir / "run").at(0).outcome, Outcome::kSurvived);
}

// The limit is a little less than what the database of the whole run takes.
TEST_F(BatchFaults, WithoutRoomForTheDatabaseItEndsWithOneErrorAndGoesOnLater) {
  const std::string what = batch(12, 0.2);
  ASSERT_EQ(dobbench(what + "--out whole").exit_code, 0);
  const std::uintmax_t blocks = fs::file_size(dir / "whole/run.sqlite") / 512 - 8;  // of 512 bytes, as ulimit counts
  const Answer full = dobbench_under("ulimit -f " + std::to_string(blocks) + ";", what + "--out full");
  EXPECT_EQ(full.exit_code, 4) << full.out << full.err;
  expect_one_line(full, {"full/run.sqlite: ", "what was finished is kept", "--resume"});
  EXPECT_EQ(full.out, "");
  expect_intact("full");
  const std::size_t finished = read_cells(dir / "full").size();
  EXPECT_GT(finished, 0U);
  EXPECT_LT(finished, 24U);
  ASSERT_EQ(dobbench("run --resume --out full").exit_code, 0);
  EXPECT_EQ(table("full"), table("whole"));
  EXPECT_EQ(hashes("full"), hashes("whole"));
}

// A cell whose time series find no room could be run: it is no row with an error, which would stay, but is run again.
TEST_F(BatchFaults, WithoutRoomForTimeSeriesItEndsWithOneErrorAndGoesOnLater) {
  const std::string what = "run undisturbed --observer none --set duration_s=2 --seeds 2 --keep none --log csv ";
  ASSERT_EQ(dobbench(what + "--out whole").exit_code, 0);
  const Answer full = dobbench_under("ulimit -f 1000;", what + "--out full");
  EXPECT_EQ(full.exit_code, 4) << full.out << full.err;
  expect_one_line(full, {"full/logs/", ".csv: ", "what was finished is kept", "--resume"});
  expect_intact("full");
  EXPECT_EQ(read_cells(dir / "full").size(), 0U);
  ASSERT_EQ(dobbench("run --resume --out full").exit_code, 0);
  EXPECT_EQ(table("full"), table("whole"));
}

TEST_F(BatchFaults, WithoutRoomToBeginNothingIsRun) {
  const Answer full = dobbench_under("ulimit -f 8;", batch(1, 0.2) + "--out full");
  EXPECT_EQ(full.exit_code, 4) << full.err;
  expect_one_line(full, {"full/"});
  EXPECT_FALSE(is_run_directory(dir / "full"));
  EXPECT_EQ(dobbench(batch(1, 0.2) + "--out full").exit_code, 0);  // what is left there is no obstacle
}

// Root may write everywhere: as root, the program runs without that right.
TEST_F(BatchFaults, WithoutPermissionToWriteThereIsOneErrorAndReadingStillWorks) {
  const std::string before = ::getuid() == 0 ? "setpriv --bounding-set=-dac_override,-dac_read_search" : "exec";
  ASSERT_EQ(dobbench("run undisturbed --observer none --set duration_s=0.2 --out run").exit_code, 0);
  const std::string expected = table("run");
  fs::create_directory(dir / "closed");
  dobbench("--version; chmod -R a-w run closed");
  const Answer again = dobbench_under(before, "run --resume --out run");
  const Answer anew = dobbench_under(before, "run undisturbed --observer none --set duration_s=0.2 --out closed/new");
  const Answer report = dobbench_under(before, "report run");
  const Answer read = dobbench_under(before, "table run --format json");
  dobbench("--version; chmod -R u+w run closed");
  EXPECT_EQ(again.exit_code, 2);
  expect_one_line(again, {"run/run.lock: Permission denied"});
  EXPECT_EQ(anew.exit_code, 2);
  expect_one_line(anew, {"closed/new: cannot create the directory: Permission denied"});
  EXPECT_EQ(report.exit_code, 2);
  expect_one_line(report, {"run/report.html: cannot be written"});
  EXPECT_EQ(read.out, expected) << read.err;
  expect_intact("run");
}

TEST_F(BatchFaults, AStandardOutputWithoutRoomIsAnError) {
  ASSERT_EQ(dobbench("run undisturbed --observer none --set duration_s=0.1 --out run").exit_code, 0);
  const Answer full = dobbench("table run >/dev/full");
  EXPECT_EQ(full.exit_code, 4);
  expect_one_line(full, {"No space left on device"});
}

TEST_F(BatchFaults, AStoreOfAnotherVersionIsRefusedWithTheReason) {
  ASSERT_EQ(dobbench("run undisturbed --observer none --set duration_s=0.1 --out run").exit_code, 0);
  for (const auto& [version, who] : std::map<int, std::string>{{99, "a newer"}, {1, "an older"}}) {
    SQLite::Database((dir / "run/run.sqlite").string(), SQLite::OPEN_READWRITE)
        .exec("PRAGMA user_version = " + std::to_string(version));
    for (const char* command : {"table run", "run --resume --out run", "report run", "compare run run"}) {
      expect_refused(command, {"run/run.sqlite: store of version " + std::to_string(version), who + " dobbench"});
    }
  }
}

}  // namespace
}  // namespace dob::batch_faults_test
