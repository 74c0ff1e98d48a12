#include <SQLiteCpp/SQLiteCpp.h>
#include <array>
#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/results/run_samples.h"

namespace dob::store_faults_test {
namespace {

using test::append_text;
using test::key;
using test::store_error;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class StoreFaultsTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path dir = temporary.path() / "run";
  CellResult a = test::survived(key("s", "", "a", "-", 1), 1.0);
  CellResult b = test::survived(key("s", "", "b", "-", 1), 2.0);

  std::filesystem::path database() const { return dir / "run.sqlite"; }
  void execute(const std::string& sql) const {
    SQLite::Database(database().string(), SQLite::OPEN_READWRITE).exec(sql);
  }

  // A run of the cells a and b of which a is finished.
  void make_run() const {
    RunStore store = RunStore::create(dir, test::run_of({a, b}).info, {});
    store.append(a);
  }
};

TEST_F(StoreFaultsTest, WhatIsNotAsItShouldBeIsNamed) {
  make_run();
  const auto with = [&](const std::string& change, const std::string& back) {
    execute(change);
    const std::string error = store_error([&] { read_run(dir); });
    execute(back);
    return error;
  };
  EXPECT_THAT(with("UPDATE result SET outcome = 'ascended'", "UPDATE result SET outcome = 'survived'"),
              AllOf(StartsWith(database().string() + ": "), HasSubstr("outcome 'ascended', allowed: survived")));
  EXPECT_THAT(with("UPDATE result SET state_hash = '00zz'", "UPDATE result SET state_hash = '0000000000000000'"),
              HasSubstr("state_hash '00zz'"));
  EXPECT_THAT(with("UPDATE result SET simulated_s = 'long'", "UPDATE result SET simulated_s = 46.0"),
              HasSubstr("simulated_s 'long', allowed: a number"));
  EXPECT_THAT(with("INSERT INTO result(cell, batch, outcome, state_hash) VALUES(99, 1, 'fell', '0000000000000000')",
                   "DELETE FROM result WHERE cell = 99"),
              HasSubstr("table result: cell 99 is not planned"));
  for (const std::string table : {"checkpoint", "shadow"}) {
    EXPECT_THAT(with("INSERT INTO " + table + "(cell, number) VALUES(0, 0)", "DELETE FROM " + table),
                HasSubstr("table " + table + ": cell 0 is not planned"));
    EXPECT_THAT(with("INSERT INTO " + table + "(cell, number) VALUES(2, 0)", "DELETE FROM " + table),
                HasSubstr("table " + table + ": cell 2 has no result"));
  }
  EXPECT_THAT(with("INSERT INTO timing(cell, batch) VALUES(3, 1)", "DELETE FROM timing"),
              HasSubstr("table timing: cell 3 is not planned"));
  EXPECT_EQ(read_run(dir).cells.size(), 1U);
}

TEST_F(StoreFaultsTest, CellOfAnotherRunIsRefused) {
  make_run();
  const CellResult stranger = test::survived(key("s", "", "stranger", "-", 1), 1.0);
  EXPECT_THAT(store_error([&] { RunStore::open(dir, {}).append(stranger); }),
              HasSubstr("a cell that does not belong to the run"));
}

TEST_F(StoreFaultsTest, AMetricThatWasNotRecordedThenIsMissingWithANote) {
  make_run();
  execute("ALTER TABLE result DROP COLUMN slip_max_m");
  const auto run = read_run(dir);
  EXPECT_EQ(run.cells.at(0).metrics.slip_max_m, std::nullopt);
  EXPECT_EQ(run.cells.at(0).metrics.com_error_max_m, 1.0);
  ASSERT_EQ(run.notes.size(), 1U);
  EXPECT_THAT(run.notes[0], HasSubstr("slip_max_m: not recorded"));
}

TEST_F(StoreFaultsTest, MissingForeignOrDamagedDirectoriesAreToldApart) {
  EXPECT_EQ(store_error([&] { read_run(dir); }), dir.string() + ": no such directory");
  EXPECT_THAT(store_error([&] { read_run(temporary.path()); }), HasSubstr("is not a run directory"));
  EXPECT_THAT(store_error([&] { RunStore::open(temporary.path(), {}); }), HasSubstr("is not a run directory"));
  make_run();
  std::filesystem::resize_file(database(), std::filesystem::file_size(database()) / 2);
  EXPECT_THAT(store_error([&] { read_run(dir); }), AllOf(StartsWith(database().string()), HasSubstr("malformed")));
  std::ofstream(database()) << "years of work in another format, as long as the head of a database file, and longer..."
                               "................................................................................";
  EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("file is not a database"));
  std::filesystem::remove(database());
  SQLite::Database(database().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t(x)");
  EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("is not the database of a run"));
}

TEST_F(StoreFaultsTest, AStoreOfAnotherVersionIsRefusedWithTheReason) {
  make_run();
  execute("PRAGMA user_version = 4");
  EXPECT_THAT(store_error([&] { read_run(dir); }),
              HasSubstr("store of version 4, this program reads 2 to 3: it was written by a newer dobbench"));
  execute("PRAGMA user_version = 0");
  EXPECT_THAT(store_error([&] { RunStore::open(dir, {}); }), HasSubstr("version 0, this program reads 2 to 3: it was "
                                                                       "written by an older dobbench"));
}

// A process that begins a transaction, writes, and is killed before its end. Its journal stays behind.
TEST_F(StoreFaultsTest, TheTransactionOfAKilledProcessIsRolledBack) {
  make_run();
  const pid_t child = ::fork();
  if (child == 0) {
    SQLite::Database mine(database().string(), SQLite::OPEN_READWRITE);
    mine.exec(
        "PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN IMMEDIATE; UPDATE result SET reason = "
        "hex(zeroblob(1000000));");  // more than its cache: it reaches the file
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_TRUE(std::filesystem::exists(database().string() + "-journal"));
  EXPECT_EQ(read_run(dir).cells.at(0).reason, "");
  RunStore::open(dir, {}).append(b);
  EXPECT_EQ(read_cells(dir).size(), 2U);
}

TEST_F(StoreFaultsTest, ASecondProcessThatWritesTheSameRunIsRefusedUntilTheFirstHasEnded) {
  make_run();
  std::array<int, 2> ready{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const RunStore store = RunStore::open(dir, {});
    if (::write(ready[1], "x", 1) != 1) ::_exit(1);
    ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THAT(store_error([&] { RunStore::open(dir, {}); }),
              HasSubstr("another batch (process " + std::to_string(child) + ") is writing it"));
  EXPECT_EQ(read_cells(dir).size(), 1U);  // readers are welcome
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  RunStore::open(dir, {}).append(b);
  EXPECT_EQ(read_cells(dir).size(), 2U);
}

TEST_F(StoreFaultsTest, ADirectoryWhoseMakingWasCutShortIsMadeAnew) {
  std::filesystem::create_directories(dir / "scenarios");
  append_text(dir / "run.lock", "");
  append_text(dir / "run.sqlite.part", "half a database");
  append_text(dir / "scenarios/old.toml", "");
  RunStore::create(dir, test::run_of({a}).info, {}).append(a);
  EXPECT_EQ(read_cells(dir).size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(dir / "run.sqlite.part"));
  EXPECT_FALSE(std::filesystem::exists(dir / "scenarios/old.toml"));
}

TEST_F(StoreFaultsTest, DirectoryInUseIsNotOverwritten) {
  make_run();
  EXPECT_EQ(store_error([&] { RunStore::create(dir, {}, {}); }), dir.string() + ": holds a run already");
  const std::filesystem::path other = temporary.path() / "other";
  std::filesystem::create_directory(other);
  append_text(other / "thesis.tex", "years of work");
  EXPECT_THAT(store_error([&] { RunStore::create(other, {}, {}); }), HasSubstr("is not a run directory"));
  EXPECT_FALSE(std::filesystem::exists(other / "scenarios"));
}

TEST_F(StoreFaultsTest, DirectoryThatCannotBeMadeIsOneClearError) {
  append_text(temporary.path() / "file", "");
  const std::filesystem::path below = temporary.path() / "file/results";
  EXPECT_EQ(store_error([&] { RunStore::create(below, {}, {}); }),
            below.string() + ": cannot create the directory: Not a directory");
  EXPECT_EQ(store_error([&] { RunStore::create_numbered(below, {}, {}); }),
            below.string() + ": cannot create the directory: Not a directory");
}

TEST_F(StoreFaultsTest, ScenarioNamesCannotLeaveTheDirectory) {
  for (const char* name : {"", "../../evil", "a/b", ".hidden", "a b", "a\nb"}) {
    EXPECT_THAT(store_error([&] { RunStore::create(dir, {}, {{name, ""}}); }), HasSubstr("letters, digits")) << name;
  }
  EXPECT_THAT(store_error([&] {
                RunStore::create(dir, {}, {{"twice", ""}, {"twice", ""}});
              }),
              HasSubstr("two scenarios"));
  EXPECT_FALSE(std::filesystem::exists(dir));
}

// Limits the size of files that this process may write; the limit is lifted with the object.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST_F(StoreFaultsTest, FullDiskLeavesWhatWasThereIntact) {
  RunStore store = RunStore::create(dir, test::run_of({a, b}).info, {});
  store.append(a);
  b.reason = std::string(1'000'000, 'x');
  std::string error;
  {
    const FileSizeLimit limit(std::filesystem::file_size(database()) + 8192);  // room for a part of it only
    error = store_error([&] { store.append(b); });
  }
  EXPECT_THAT(error, StartsWith(database().string() + ": "));
  EXPECT_EQ(read_cells(dir).size(), 1U);
  store.append(b);
  EXPECT_EQ(read_cells(dir).size(), 2U);
}

}  // namespace
}  // namespace dob::store_faults_test
