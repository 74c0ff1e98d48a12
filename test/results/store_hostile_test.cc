// Run directories that somebody else has prepared: nothing in them is obeyed.
#include <SQLiteCpp/SQLiteCpp.h>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/results/run_samples.h"

namespace dob::store_hostile_test {
namespace {

namespace fs = std::filesystem;
using test::append_text;
using test::key;
using test::read_text;
using test::store_error;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class HostileStoreTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  fs::path dir = temporary.path() / "run";
  fs::path database = dir / "run.sqlite";
  CellResult a = test::survived(key("s", "", "a", "-", 1), 1.0);
  CellResult b = test::survived(key("s", "", "b", "-", 1), 2.0);

  void SetUp() override { make_run(dir); }

  void make_run(const fs::path& at) const { RunStore::create(at, test::run_of({a, b}).info, {}).append(a); }

  void execute(const std::string& sql) const { SQLite::Database(database.string(), SQLite::OPEN_READWRITE).exec(sql); }
  int count(const std::string& table) const {
    return SQLite::Database(database.string()).execAndGet("SELECT count(*) FROM " + table).getInt();
  }

  // Readers and writers refuse it, with the file and these words.
  void expect_refused(const std::string& words) const {
    const auto refusal = AllOf(StartsWith(dir.string()), HasSubstr(words));
    EXPECT_THAT(store_error([&] { read_run(dir); }), refusal);
    EXPECT_THAT(store_error([&] { read_run_info(dir); }), refusal);
    EXPECT_THAT(store_error([&] { RunStore::open(dir, {}); }), refusal);
  }
};

TEST_F(HostileStoreTest, TriggersAreRefusedAndDoNotRun) {
  execute("CREATE TRIGGER gift AFTER INSERT ON batch BEGIN DELETE FROM cell; END");
  expect_refused("holds the trigger 'gift', which no dobbench makes so");
  EXPECT_EQ(count("cell"), 2);
  execute("DROP TRIGGER gift");
  EXPECT_EQ(read_cells(dir).size(), 1U);
}

TEST_F(HostileStoreTest, WhatIsNoTableOfOursIsRefused) {
  const auto with = [&](const std::string& change, const std::string& back, const std::string& words) {
    execute(change);
    expect_refused(words);
    execute(back);
  };
  with("CREATE TABLE mine(x)", "DROP TABLE mine", "the table 'mine'");
  with("CREATE VIEW mine AS SELECT * FROM cell", "DROP VIEW mine", "the view 'mine'");
  with("CREATE INDEX mine ON cell(seed)", "DROP INDEX mine", "the index 'mine'");
  with("CREATE VIRTUAL TABLE timing_histogram USING fts5(x)", "DROP TABLE timing_histogram", "timing_histogram");
  with("CREATE TABLE timing_histogram(cell DEFAULT (randomblob(9)))", "DROP TABLE timing_histogram",
       "timing_histogram");
  with("CREATE TABLE timing_histogram(cell CHECK(cell))", "DROP TABLE timing_histogram", "timing_histogram");
  with("CREATE TABLE timing_histogram(cell, c GENERATED ALWAYS AS (cell))", "DROP TABLE timing_histogram",
       "timing_histogram");
  with("CREATE VIEW timing_histogram AS SELECT 1", "DROP VIEW timing_histogram", "the view 'timing_histogram'");
  with("CREATE TABLE \"m\x1b[2J\"(x)", "DROP TABLE \"m\x1b[2J\"", "the table 'm [2J'");
  EXPECT_EQ(read_cells(dir).size(), 1U);
}

TEST_F(HostileStoreTest, ADatabaseWithDamageInsideIsRefused) {
  // A page in the middle is overwritten.
  std::fstream file(database, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(4096 * 4);
  file << std::string(4096, '\x5a');
  file.close();
  expect_refused("malformed");
}

TEST_F(HostileStoreTest, AWriteAheadLogIsRefused) {
  execute("PRAGMA journal_mode = WAL");
  expect_refused("has a write-ahead log");
  execute("PRAGMA journal_mode = DELETE");
  EXPECT_EQ(read_cells(dir).size(), 1U);
  append_text(database.string() + "-wal", "pages from elsewhere");
  expect_refused("run.sqlite-wal: a write-ahead log");
}

// A journal that names a further file: SQLite takes it for the journal of several databases, finds that none needs it
// any more, and deletes it. The journal is that of a process that was killed, with what SQLite would write behind it.
class HostileJournalTest : public HostileStoreTest {
 protected:
  fs::path precious = temporary.path() / "thesis.tex";

  void SetUp() override {
    HostileStoreTest::SetUp();
    append_text(precious, "years of work");
    leave_journal();
    name_in_journal(precious.string());
  }

  void leave_journal() const {
    const pid_t child = ::fork();
    if (child == 0) {
      SQLite::Database mine(database.string(), SQLite::OPEN_READWRITE);
      mine.exec(
          "PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN IMMEDIATE; "
          "UPDATE result SET reason = hex(zeroblob(1000000));");
      ::raise(SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    ASSERT_GT(fs::file_size(database.string() + "-journal"), 512U);
  }

  void name_in_journal(const std::string& name) const {
    const auto number = [](std::uint32_t n) {
      std::string bytes;
      for (unsigned shift = 32; shift > 0; shift -= 8) bytes += static_cast<char>(n >> (shift - 8));
      return bytes;
    };
    std::uint32_t sum = 0;
    for (const char c : name) sum += static_cast<std::uint32_t>(c);
    constexpr std::uint32_t kLockPage = 0x40000000 / 4096 + 1;
    append_text(database.string() + "-journal", number(kLockPage) + name +
                                                    number(static_cast<std::uint32_t>(name.size())) + number(sum) +
                                                    "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7");
  }
};

TEST_F(HostileJournalTest, ThatNamesAFileElsewhereIsRefusedAndTheFileStays) {
  expect_refused("run.sqlite-journal: names another file");
  EXPECT_EQ(read_text(precious), "years of work");
}

TEST_F(HostileJournalTest, WouldHaveHadTheFileDeleted) {
  SQLite::Database(database.string(), SQLite::OPEN_READWRITE).execAndGet("SELECT count(*) FROM cell");
  EXPECT_FALSE(fs::exists(precious)) << "SQLite has learnt not to: the guard may go, and this test with it";
}

TEST_F(HostileStoreTest, LinksAndSpecialFilesAreRefusedAndNothingBehindThemChanges) {
  const fs::path other = temporary.path() / "other";
  make_run(other);
  const std::string before = read_text(other / "run.sqlite");
  fs::rename(database, temporary.path() / "own.sqlite");
  fs::create_symlink(other / "run.sqlite", database);
  expect_refused("run.sqlite: is a symbolic link");
  fs::remove(database);
  fs::create_directory(database);
  expect_refused("run.sqlite: is a directory");
  fs::remove(database);
  fs::rename(temporary.path() / "own.sqlite", database);
  fs::create_symlink(other / "run.sqlite", database.string() + "-journal");
  expect_refused("run.sqlite-journal: is a symbolic link");
  fs::remove(database.string() + "-journal");
  ASSERT_EQ(::mkfifo((database.string() + "-journal").c_str(), 0600), 0);
  expect_refused("run.sqlite-journal: is a special file");
  fs::remove(database.string() + "-journal");
  fs::remove(dir / "run.lock");
  fs::create_symlink(temporary.path() / "made", dir / "run.lock");
  EXPECT_THAT(store_error([&] { RunStore::open(dir, {}); }), HasSubstr("run.lock: is a symbolic link"));
  EXPECT_FALSE(fs::exists(temporary.path() / "made"));
  EXPECT_EQ(read_text(other / "run.sqlite"), before);
  EXPECT_EQ(read_cells(dir).size(), 1U);
}

TEST_F(HostileStoreTest, NamesThatLeadElsewhereAreRefused) {
  for (const char* trace : {"../../../etc/passwd", "/dev/zero", "traces/../../x", "traces/", "scenarios/s.toml"}) {
    execute(std::string("UPDATE result SET trace = '") + trace + "'");
    EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("allowed: a file in traces/")) << trace;
  }
  execute("UPDATE result SET trace = 'traces/00001_s.dobtrace'");
  EXPECT_EQ(read_cells(dir).at(0).trace, "traces/00001_s.dobtrace");
  execute("INSERT INTO scenario(id, file, hash) VALUES(7, '../../evil', ''); UPDATE cell SET scenario_id = 7;");
  EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("scenario file '../../evil' is not one of scenarios/"));
  EXPECT_THAT(store_error([&] { read_run_info(dir); }), StartsWith(database.string() + ": "));
  execute("UPDATE cell SET scenario_id = NULL, observer = char(27) || '[2J' || id");
  EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("' [2J1' holds a control character"));
}

// Half made by somebody else: what stands there is replaced, what links point to is left alone.
TEST_F(HostileStoreTest, MakingARunWritesThroughNoLink) {
  const fs::path half = temporary.path() / "half", outside = temporary.path() / "outside";
  fs::create_directory(outside);
  append_text(outside / "s.toml", "mine");
  append_text(outside / "thesis.tex", "years of work");
  fs::create_directory(half);
  append_text(half / "run.lock", "");
  fs::create_symlink(outside, half / "scenarios");
  for (const char* name : {"run.sqlite.part", "run.sqlite.part-journal", "run.sqlite-journal", "run.sqlite-wal"}) {
    fs::create_symlink(outside / "thesis.tex", half / name);
  }
  RunStore::create(half, test::run_of({a}).info, {{"s", "duration_s = 1\n"}}).append(a);
  EXPECT_EQ(read_cells(half).size(), 1U);
  EXPECT_EQ(read_text(half / "scenarios/s.toml"), "duration_s = 1\n");
  EXPECT_EQ(read_text(outside / "s.toml"), "mine");
  EXPECT_EQ(read_text(outside / "thesis.tex"), "years of work");
}

}  // namespace
}  // namespace dob::store_hostile_test
