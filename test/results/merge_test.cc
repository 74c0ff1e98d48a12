#include "results/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/table.h"
#include "test/results/run_samples.h"

namespace dob::merge_test {
namespace {

namespace fs = std::filesystem;
using test::key;
using test::store_error;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Two observers with three seeds each, in two shards of every second cell.
class MergeTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  fs::path dir = temporary.path();
  std::vector<ResolvedScenario> scenarios{{"s", "duration_s = 1\n"}};
  std::vector<CellKey> keys;

  MergeTest() {
    for (const char* observer : {"a", "b"}) {
      for (int seed = 1; seed <= 3; ++seed) keys.push_back(key("s", "", observer, "x", seed));
    }
  }

  RunInfo info_of(const std::vector<long>& ids, const RunShard& shard) const {
    RunInfo info{"dobbench run s", "0.1.0", "abc", "Release", "g++ 12", "-O3", {"CPU", 2, "Debian 12"}, "2026", {}};
    for (const long id : ids) {
      info.cells.push_back(keys[static_cast<std::size_t>(id - 1)]);
      info.sources.push_back({"s", "[" + info.cells.back().observer + "]\n"});
    }
    info.ids = ids;
    info.shards = {shard};
    return info;
  }

  static RunShard shard(int number, int count) { return {number, count, 6, "fingerprint"}; }

  CellResult result(long id) const {
    CellResult cell = test::survived(keys[static_cast<std::size_t>(id - 1)], 0.001 * static_cast<double>(id));
    cell.state_hash = static_cast<std::uint64_t>(id) * 1000003ULL;
    cell.checkpoints = {test::checkpoint(1.0, 0.0005 * static_cast<double>(id))};
    cell.shadows.push_back({.observer = "c", .profile = "x", .estimate_rmse_N = 0.1 * static_cast<double>(id)});
    return cell;
  }

  // Appends the first `finished` of its cells.
  fs::path write(const std::string& name, const RunInfo& info, std::size_t finished = 99) const {
    RunStore store = RunStore::create(dir / name, info, scenarios);
    const std::size_t count = std::min(finished, info.cells.size());
    for (std::size_t i = 0; i < count; ++i) store.append(result(info.ids[i]));
    if (count == info.cells.size()) store.set_complete(true);
    return dir / name;
  }

  fs::path whole() const { return write("whole", info_of({1, 2, 3, 4, 5, 6}, shard(1, 1))); }
  fs::path odd() const { return write("odd", info_of({1, 3, 5}, shard(1, 2))); }
  fs::path even() const { return write("even", info_of({2, 4, 6}, shard(2, 2))); }

  static std::string table(const fs::path& run) { return render_table(read_run(run), {.format = TableFormat::kJson}); }
};

TEST_F(MergeTest, AllShardsGiveTheRunThatWasNeverDivided) {
  const MergeSummary merged = merge_runs({even(), odd()}, dir / "merged");
  EXPECT_TRUE(merged.complete());
  EXPECT_EQ(merged.planned, 6U);
  EXPECT_EQ(merged.finished, 6U);
  const dob::Run run = read_run(dir / "merged"), undivided = read_run(whole());
  EXPECT_EQ(run.info.cells, CellKeys(keys));
  EXPECT_EQ(table(dir / "merged"), table(dir / "whole"));
  EXPECT_EQ(render_table(run, {.shadow = true}), render_table(undivided, {.shadow = true}));
  ASSERT_EQ(run.cells.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(cell_to_line(run.cells[i]), cell_to_line(undivided.cells[i]));
    EXPECT_EQ(run.info.sources[i].observer, undivided.info.sources[i].observer);
  }
  EXPECT_THAT(run.notes, IsEmpty());
  EXPECT_EQ(read_resolved(dir / "merged", "s").toml, scenarios[0].toml);
}

TEST_F(MergeTest, AgainInAnyOrderAndWithItselfItIsTheSame) {
  merge_runs({odd(), even()}, dir / "merged");
  const std::string once = table(dir / "merged");
  merge_runs({dir / "even", dir / "odd", dir / "even"}, dir / "merged");
  EXPECT_EQ(table(dir / "merged"), once);
  merge_runs({dir / "merged", dir / "odd"}, dir / "again");
  EXPECT_EQ(table(dir / "again"), once);
}

TEST_F(MergeTest, WhatIsMissingIsSaidAndComesLater) {
  write("half", info_of({2, 4, 6}, shard(2, 2)), 1);
  const MergeSummary merged = merge_runs({dir / "half"}, dir / "merged");
  EXPECT_FALSE(merged.complete());
  EXPECT_THAT(merged.missing, ElementsAre(1));
  EXPECT_THAT(merged.unfinished, ElementsAre(2));
  EXPECT_EQ(merged.cells, 3U);
  EXPECT_EQ(merged.finished, 1U);
  EXPECT_THAT(read_run(dir / "merged").notes,
              ElementsAre("of 2 shards these are not here: 1", "of 2 shards these are not finished: 2"));
  const MergeSummary rest = merge_runs({odd(), even()}, dir / "merged");
  EXPECT_TRUE(rest.complete());
  whole();
  EXPECT_EQ(table(dir / "merged"), table(dir / "whole"));
}

TEST_F(MergeTest, ACellThatCouldNotBeRunGivesWayToOneThatCould) {
  const RunInfo info = info_of({1, 3, 5}, shard(1, 2));
  {
    RunStore store = RunStore::create(dir / "failed", info, scenarios);
    store.append(test::failed(info.cells[0], "killed"));
    store.append(result(3));
  }
  EXPECT_EQ(merge_runs({dir / "failed"}, dir / "merged").errors, 1U);
  const MergeSummary merged = merge_runs({odd(), dir / "failed", even()}, dir / "merged");
  EXPECT_TRUE(merged.complete());
  EXPECT_EQ(merged.errors, 0U);
  whole();
  EXPECT_EQ(table(dir / "merged"), table(dir / "whole"));
}

TEST_F(MergeTest, ForeignShardsAreRefusedAndTheMergeStays) {
  merge_runs({odd(), even()}, dir / "merged");
  const std::string before = table(dir / "merged");
  const auto refusal = [&](const std::string& name, const RunInfo& info) {
    write(name, info);
    return store_error([&] { merge_runs({dir / name}, dir / "merged"); });
  };
  RunInfo other = info_of({1, 3, 5}, shard(1, 2));
  other.shards[0].plan = "another";
  EXPECT_THAT(refusal("plan", other), AllOf(HasSubstr("belongs to another plan"), HasSubstr("another")));
  EXPECT_THAT(refusal("thirds", info_of({1, 4}, shard(1, 3))), HasSubstr("of 2 shards, that one of 3"));
  other = info_of({1, 3, 5}, shard(1, 2));
  other.commit = "def";
  EXPECT_THAT(refusal("program", other), AllOf(HasSubstr("computed by"), HasSubstr("def"), HasSubstr("abc")));
  other = info_of({1, 3, 5}, shard(1, 2));
  other.shards.clear();
  EXPECT_THAT(refusal("old", other), HasSubstr("was made before runs could be merged"));
  EXPECT_EQ(table(dir / "merged"), before);
}

TEST_F(MergeTest, ACellThatCameOutDifferentlyIsRefused) {
  odd();
  const RunInfo info = info_of({1, 3, 5}, shard(1, 2));
  {
    RunStore store = RunStore::create(dir / "other", info, scenarios);
    CellResult cell = result(3);
    cell.state_hash += 1;
    store.append(cell);
  }
  EXPECT_THAT(store_error([&] {
                merge_runs({dir / "odd", dir / "other"}, dir / "merged");
              }),
              AllOf(HasSubstr("cell 3 has come out differently"), HasSubstr("other")));
  EXPECT_FALSE(is_run_directory(dir / "merged"));
}

TEST_F(MergeTest, ADirectoryWithSomethingElseInItIsLeftAlone) {
  fs::create_directory(dir / "full");
  test::append_text(dir / "full" / "notes", "mine");
  EXPECT_THAT(store_error([&] { merge_runs({odd()}, dir / "full"); }), HasSubstr("not a run directory"));
  EXPECT_THAT(store_error([&] { merge_runs({dir / "odd"}, dir / "odd"); }), HasSubstr("is --out, too"));
  EXPECT_THAT(store_error([&] { merge_runs({dir / "nowhere"}, dir / "merged"); }), HasSubstr("no such directory"));
}

TEST_F(MergeTest, ARefusedMergeLeavesEverythingAsItWas) {
  fs::create_directory(odd() / "traces");
  test::append_text(dir / "odd" / "traces" / "00001_s.dobtrace", "trace");
  merge_runs({dir / "odd"}, dir / "merged");
  const RunInfo info = info_of({1, 3, 5}, shard(1, 2));
  {
    RunStore store = RunStore::create(dir / "other", info, scenarios);
    CellResult cell = result(3);
    cell.state_hash += 1;
    store.append(cell);
  }
  fs::create_directory(dir / "other" / "traces");
  test::append_text(dir / "other" / "traces" / "00001_s.dobtrace", "junk");
  const auto merge = [&](const fs::path& out) { merge_runs({dir / "odd", dir / "other"}, out); };
  EXPECT_NE(store_error([&] { merge(dir / "merged"); }), "");
  EXPECT_EQ(test::read_text(dir / "merged" / "traces" / "00001_s.dobtrace"), "trace");
  EXPECT_FALSE(fs::exists(dir / "merged" / "run.sqlite.part"));
  EXPECT_NE(store_error([&] { merge(dir / "new"); }), "");
  EXPECT_FALSE(fs::exists(dir / "new"));
}

TEST_F(MergeTest, AShardIsNoPlaceForAMerge) {
  EXPECT_THAT(store_error([&] { merge_runs({odd()}, even()); }), HasSubstr("holds a run, or a shard of one"));
  EXPECT_EQ(read_run(dir / "even").cells.size(), 3U);
}

// A campaign that was gone on with may have chosen other cells than those that were merged before.
TEST_F(MergeTest, AShardReplacesWhatAnEarlierMergeHasOfIt) {
  merge_runs({odd(), even()}, dir / "merged");
  {
    RunStore store = RunStore::resume(dir / "odd", info_of({1, 3, 5}, shard(1, 2)), scenarios);
    store.set_complete(false);
    store.remove({keys[2]});
  }
  const MergeSummary merged = merge_runs({dir / "odd"}, dir / "merged");
  EXPECT_EQ(merged.finished, 5U);
  EXPECT_THAT(merged.unfinished, ElementsAre(1));
}

TEST_F(MergeTest, TracesAreCopiedAndLinksAreNot) {
  const fs::path part = odd();
  fs::create_directory(part / "traces");
  test::append_text(part / "traces" / "00001_s.dobtrace", "trace");
  test::append_text(dir / "secret", "secret");
  fs::create_symlink(dir / "secret", part / "traces" / "link.dobtrace");
  merge_runs({part}, dir / "merged");
  EXPECT_EQ(test::read_text(dir / "merged" / "traces" / "00001_s.dobtrace"), "trace");
  EXPECT_FALSE(fs::exists(dir / "merged" / "traces" / "link.dobtrace"));
}

TEST_F(MergeTest, AShardIsResumedAsThatShardOnly) {
  odd();
  EXPECT_THAT(store_error([&] {
                RunStore::resume(dir / "odd", info_of({2, 4, 6}, shard(2, 2)), scenarios);
              }),
              HasSubstr("it is shard 1/2, not shard 2/2"));
}

}  // namespace
}  // namespace dob::merge_test
