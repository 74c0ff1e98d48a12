#include <csignal>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/results/run_samples.h"

namespace dob {
namespace {

using test::append_text;
using test::key;
using test::read_text;
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

  // A run of the cells a and b of which a is finished.
  void make_run() const {
    RunStore store = RunStore::create(dir, test::run_of({a, b}).info, {});
    store.append(a);
  }
};

TEST_F(StoreFaultsTest, TornLastLineIsIgnoredWithANote) {
  make_run();
  append_text(dir / "cells.jsonl", R"({"scenario":"s","vari)");
  const auto run = read_run(dir);
  EXPECT_EQ(run.cells.size(), 1U);
  ASSERT_EQ(run.notes.size(), 1U);
  EXPECT_THAT(run.notes[0], AllOf(StartsWith((dir / "cells.jsonl").string() + ":2: "), HasSubstr("incomplete")));
}

TEST_F(StoreFaultsTest, LastLineThatLacksOnlyItsEndIsTornToo) {
  make_run();
  std::string text = read_text(dir / "cells.jsonl");
  std::filesystem::resize_file(dir / "cells.jsonl", text.size() - 1);
  EXPECT_TRUE(read_run(dir).cells.empty());
  EXPECT_EQ(read_run(dir).notes.size(), 1U);
}

TEST_F(StoreFaultsTest, OpeningRemovesATornLineSoThatTheNextOneIsWhole) {
  make_run();
  const std::string before = read_text(dir / "cells.jsonl");
  append_text(dir / "cells.jsonl", R"({"scenario":"s","vari)");
  append_text(dir / "timing.jsonl", "{");
  { const RunStore store = RunStore::open(dir); }
  EXPECT_EQ(read_text(dir / "cells.jsonl"), before);
  RunStore::open(dir).append(b);
  const auto run = read_run(dir);
  EXPECT_EQ(run.cells.size(), 2U);
  EXPECT_TRUE(run.notes.empty());
}

TEST_F(StoreFaultsTest, WholeLineThatCannotBeReadIsAnErrorWithItsPlace) {
  make_run();
  append_text(dir / "cells.jsonl", "{\"scenario\":\"s\"}\n");
  EXPECT_THAT(store_error([&] { read_run(dir); }),
              AllOf(StartsWith((dir / "cells.jsonl").string() + ":2: "), HasSubstr("variant")));
}

TEST_F(StoreFaultsTest, LinesInTheMiddleAreNotForgiven) {
  make_run();
  append_text(dir / "cells.jsonl", "{\"scenario\":\n{}\n");
  EXPECT_THAT(store_error([&] { read_run(dir); }), StartsWith((dir / "cells.jsonl").string() + ":2: "));
}

TEST_F(StoreFaultsTest, WrongOutcomeOrHashIsNamed) {
  make_run();
  std::string line = read_text(dir / "cells.jsonl");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = line;
    changed.replace(changed.find(from), from.size(), to);
    std::ofstream(dir / "cells.jsonl") << changed;
    return store_error([&] { read_run(dir); });
  };
  EXPECT_THAT(with("survived", "ascended"), HasSubstr("outcome 'ascended', allowed: survived, fell, error"));
  EXPECT_THAT(with("0000000000000000", "00000000000000zz"), HasSubstr("state_hash '00000000000000zz'"));
  EXPECT_THAT(with("46.0", "\"long\""), HasSubstr("must be number"));
}

TEST_F(StoreFaultsTest, CellOfAnotherRunIsRefused) {
  make_run();
  RunStore::open(dir).append(test::survived(key("s", "", "stranger", "-", 1), 1.0));
  EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("a cell that run.json does not name"));
}

TEST_F(StoreFaultsTest, MissingForeignOrDamagedDirectoriesAreToldApart) {
  EXPECT_EQ(store_error([&] { read_run(dir); }), dir.string() + ": no such directory");
  EXPECT_THAT(store_error([&] { read_run(temporary.path()); }), HasSubstr("is not a run directory"));
  EXPECT_THAT(store_error([&] { RunStore::open(temporary.path()); }), HasSubstr("is not a run directory"));
  make_run();
  std::ofstream(dir / "run.json") << "{\"format\": 1";
  EXPECT_THAT(store_error([&] { read_run(dir); }), AllOf(StartsWith((dir / "run.json").string()), HasSubstr("line 1")));
  std::ofstream(dir / "run.json") << "{\"format\": 2}";
  EXPECT_THAT(store_error([&] { read_run(dir); }), HasSubstr("format 2, this program reads 1"));
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
  const std::string before = read_text(dir / "cells.jsonl");
  std::string error;
  {
    const FileSizeLimit limit(before.size() + 10);  // room for a part of the next line only
    error = store_error([&] { store.append(b); });
  }
  EXPECT_THAT(error, AllOf(StartsWith((dir / "cells.jsonl").string()), HasSubstr("cannot write")));
  EXPECT_EQ(read_text(dir / "cells.jsonl"), before);
  store.append(b);
  EXPECT_EQ(read_cells(dir).size(), 2U);
}

}  // namespace
}  // namespace dob
