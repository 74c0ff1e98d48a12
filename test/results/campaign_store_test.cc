#include <SQLiteCpp/SQLiteCpp.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/merge.h"
#include "results/store.h"
#include "test/results/run_samples.h"

namespace dob::campaign_store_test {
namespace {

using test::key;
using test::store_error;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// One curve of two levels with two seeds.
class CampaignStoreTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path dir = temporary.path() / "run";
  RunInfo info{"dobbench campaign c", "0.1.0", "abc", "Release", "g++ 12", "-O3", {"CPU", 2, "Debian 12"}, "2026", {}};
  Campaign campaign{.kind = CampaignKind::kBreakdown,
                    .name = "c",
                    .summary = "how \"much\"",
                    .document = "kind = \"breakdown\"\n",
                    .axes = {{"delay", "ms", {0.0, 0.1 + 0.2}, false}},
                    .factors = {},
                    .curves = {{key("s", "v", "a", "x", 0), {0}, {}}},
                    .cells = {{0, {0, 0}}, {0, {0, 0}}, {0, {1, 0}}, {0, {1, 0}}}};

  CampaignStoreTest() {
    for (const char* override_text : {"delay=0", "delay=0.3"}) {
      for (int seed = 1; seed <= 2; ++seed) {
        CellKey cell = key("s", "v", "a", "x", seed);
        cell.overrides = override_text;
        info.cells.push_back(cell);
      }
    }
    info.shards = {{1, 1, 4, "fingerprint"}};
    info.campaign = campaign;
  }

  void execute(const std::string& sql) const {
    SQLite::Database((dir / "run.sqlite").string(), SQLite::OPEN_READWRITE).exec(sql);
  }
};

TEST_F(CampaignStoreTest, IsReadBackAsItWasWritten) {
  RunStore::create(dir, info, {});
  const auto back = read_campaign(dir);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->kind, CampaignKind::kBreakdown);
  EXPECT_EQ(back->name, "c");
  EXPECT_EQ(back->summary, campaign.summary);
  EXPECT_EQ(back->document, campaign.document);
  ASSERT_EQ(back->axes.size(), 1U);
  EXPECT_EQ(back->axes[0].unit, "ms");
  EXPECT_EQ(back->axes[0].levels, campaign.axes[0].levels);  // bit for bit
  ASSERT_EQ(back->curves.size(), 1U);
  EXPECT_EQ(back->curves[0].key, campaign.curves[0].key);
  EXPECT_THAT(back->curves[0].axes, ElementsAre(0));
  ASSERT_EQ(back->cells.size(), 4U);
  EXPECT_EQ(back->cells[3].level[0], 1);
}

TEST_F(CampaignStoreTest, ARunThatIsNoneHasNone) {
  info.campaign.reset();
  RunStore::create(dir, info, {});
  EXPECT_FALSE(read_campaign(dir).has_value());
}

TEST_F(CampaignStoreTest, SurvivesAMerge) {
  RunStore::create(dir, info, {}).set_complete(true);
  merge_runs({dir}, temporary.path() / "merged");
  const auto back = read_campaign(temporary.path() / "merged");
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->cells.size(), 4U);
  EXPECT_EQ(back->document, campaign.document);
}

TEST_F(CampaignStoreTest, WhatCannotBeOneIsRefused) {
  RunStore::create(dir, info, {});
  const auto refusal = [&] { return store_error([&] { read_campaign(dir); }); };
  execute("UPDATE campaign_cell SET level_0 = 2 WHERE cell = 4");
  EXPECT_THAT(refusal(), HasSubstr("level 2 of an axis of 2"));
  execute("UPDATE campaign_cell SET level_0 = 1, curve = 7 WHERE cell = 4");
  EXPECT_THAT(refusal(), HasSubstr("there is no curve 7"));
  execute("DELETE FROM campaign_cell WHERE cell = 4");
  EXPECT_THAT(refusal(), HasSubstr("not one row for each cell"));
  execute("UPDATE campaign SET document = '{'");
  EXPECT_THAT(refusal(), HasSubstr("campaign"));
}

}  // namespace
}  // namespace dob::campaign_store_test
