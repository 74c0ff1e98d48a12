#include "results/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/table.h"
#include "scenarios/loader.h"
#include "test/results/report_samples.h"

namespace dob::report_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::failed;
using test::fell;
using test::key;
using test::Page;
using test::store_error;
using test::survived;
using test::with_trace;
using ::testing::HasSubstr;
using ::testing::Not;

class Report : public test::ReportFixture {
 protected:
  const CellKey none = key("case1", "tip_lateral", "none", "-", 1);
  const CellKey tuned = key("case1", "tip_lateral", "momentum", "tuned", 1);
  const CellKey paper = key("case1", "tip_lateral", "momentum", "paper", 1);

  void write(const CellResult& cell, const Trace& trace = test::walking_trace()) const {
    write_trace(dir / cell.trace, trace);
  }
};

TEST_F(Report, APageHoldsTheRunsCellsAndTheirTraces) {
  const CellResult a = with_trace(survived(none, 0.0123456789), "a"), b = with_trace(fell(tuned, 12.5, 0.02), "b");
  test::make_run(dir, {none, tuned, paper}, {a, b});
  write(a);
  write(b, test::walking_trace(200));
  const Page p = page();
  EXPECT_EQ(p.data["schema"], 3);
  EXPECT_TRUE(p.data["campaign"].is_null());
  EXPECT_EQ(p.data["title"], "run");
  EXPECT_EQ(p.data["written_by"], Json({{"version", "1.2.3"}, {"commit", "abc"}}));
  EXPECT_EQ(p.data["observers"][1],
            Json({{"id", "momentum@tuned"}, {"observer", "momentum"}, {"profile", "tuned"}, {"oracle", false}}));
  EXPECT_EQ(p.data["observers"][0]["id"], "none");
  EXPECT_EQ(p.data["settings"], Json::parse(R"([{"id": 0, "gains": "paper", "planner": "spline", "overrides": ""}])"));

  const Json& cells = p.data["cells"];
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[0]["scenario_id"], "case1/tip_lateral");
  EXPECT_EQ(cells[0]["outcome"], "survived");
  EXPECT_NEAR(cells[0]["com_error_max_m"].get<double>(), 0.0123456789, 1e-8);
  EXPECT_TRUE(cells[0]["fall_time_s"].is_null());
  EXPECT_TRUE(cells[0]["foot_error_max_m"].is_null());
  EXPECT_EQ(cells[1]["outcome"], "fell");
  EXPECT_EQ(cells[1]["fall_time_s"], 12.5);
  EXPECT_EQ(cells[1]["reason"], "trunk tilted");
  EXPECT_EQ(cells[2]["outcome"], "pending");

  ASSERT_EQ(p.data["traces"].size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& trace = p.data["traces"][i];
    EXPECT_EQ(cells[trace["cell"].get<std::size_t>()]["trace"], i);
    EXPECT_EQ(trace["bytes"], p.script(fmt::format("trace-{}", i))->size());
    EXPECT_TRUE(p.trace(i).is_complete());
  }
  EXPECT_NEAR(p.trace(0).plot("path_error_m").at(0), 0.005, 1e-4);
  EXPECT_EQ(p.data["traces"][1]["end_s"], 1.99);
  EXPECT_EQ(summary.traces, 2U);
  EXPECT_EQ(summary.bytes, p.html.size());
  EXPECT_THAT(p.html, HasSubstr("<p>behind the data"));
}

TEST_F(Report, RowsAndClaimsAreThoseOfTheTables) {
  test::make_run(dir, {none, tuned}, {survived(none, 0.01), survived(tuned, 0.02)});
  const Page p = page();
  Json rows = Json::parse(render_table(read_run(dir), {.format = TableFormat::kJson, .timing = true}));
  ASSERT_EQ(p.data["rows"].size(), rows.size());
  rows[1]["scenario_id"] = "case1/tip_lateral";
  rows[1]["observer_id"] = "momentum@tuned";
  rows[1]["setting"] = 0;
  EXPECT_EQ(p.data["rows"][1], rows[1]);
  ASSERT_FALSE(p.data["claims"].empty());
  EXPECT_TRUE(p.data["claims"][0].contains("paper"));
}

TEST_F(Report, TheTerrainIsThatOfTheSeedThatIsReplayed) {
  const std::string toml = resolved_toml({.name = "case6", .gains = "paper"}, "");
  const Scenario scenario = load_scenarios({.name = "case6", .gains = "paper"}).front();
  RunInfo info;
  info.cells = {key("case6", "", "none", "-", 3)};
  info.sources = {{"case6_paper", "observer = \"none\""}};
  RunStore::create(dir, info, {{"case6_paper", toml}});
  const Json shown = page().data["scenarios"][0];
  EXPECT_EQ(shown["id"], "case6");
  EXPECT_EQ(shown["set"], "paper");
  EXPECT_EQ(shown["summary"], scenario.summary);
  EXPECT_EQ(shown["duration_s"], scenario.duration);
  EXPECT_EQ(shown["friction"], scenario.terrain.ground_friction);
  const std::vector<TerrainBox> blocks = lay_blocks(*scenario.block_field, 3);
  const std::size_t fixed = scenario.terrain.boxes.size();
  ASSERT_EQ(shown["boxes"].size(), fixed + blocks.size());
  bool shuffled = false;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Json& box = shown["boxes"][fixed + i];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(box["center"][static_cast<std::size_t>(axis)].get<double>(), blocks[i].center[axis], 1e-4);
      EXPECT_NEAR(box["size"][static_cast<std::size_t>(axis)].get<double>(), blocks[i].size[axis], 1e-4);
    }
    EXPECT_EQ(box["friction"], blocks[i].friction);
    shuffled = shuffled || blocks[i].friction != lay_blocks(*scenario.block_field, 1)[i].friction;
  }
  EXPECT_TRUE(shuffled) << "or the seed would not show";
}

TEST_F(Report, HostileTextsStayTextsAndThePageStaysOne) {
  const std::string hostile = "</script><script>alert(1)</script><!--\xE2\x80\xA8 \xFF";
  CellKey bad = none;
  bad.scenario = bad.variant = bad.observer = bad.overrides = hostile;
  test::make_run(dir, {bad, none}, {failed(bad, hostile), fell(none, 1.0, 0.1)});
  const Page p = page();
  EXPECT_EQ(p.html.find("<script>"), std::string::npos);
  EXPECT_EQ(p.html.find("<!--"), std::string::npos);
  EXPECT_EQ(p.html.find("\xE2\x80\xA8"), std::string::npos);
  std::size_t ends = 0;
  for (std::size_t at = 0; (at = p.html.find("</script", at)) != std::string::npos; ++at) ++ends;
  EXPECT_EQ(ends, 1U);
  EXPECT_THAT(p.data["cells"][0]["reason"].get<std::string>(), HasSubstr("</script><script>alert(1)"));
}

TEST_F(Report, NoPathOfThisMachineIsInThePage) {
  const CellResult a = with_trace(survived(none, 0.01), "a");
  test::make_run(dir, {none, tuned}, {a, failed(tuned, "/home/anna/mine.so: is gone")});
  std::ofstream(dir / a.trace) << "damaged";
  const Page p = page();
  EXPECT_EQ(p.data["cells"][1]["reason"], "mine.so: is gone");
  EXPECT_EQ(p.html.find(temporary.path().string()), std::string::npos);
  EXPECT_EQ(p.html.find("/home/anna"), std::string::npos);
  EXPECT_THAT(p.missing(), HasSubstr("traces/a.dobtrace: is not a trace"));
}

TEST_F(Report, ThePageKeepsItsSizeAndSaysWhatItCost) {
  std::vector<CellKey> keys;
  std::vector<CellResult> cells;
  for (int seed = 1; seed <= 8; ++seed) {
    keys.push_back(key("case1", "tip_lateral", "none", "-", seed));
    cells.push_back(with_trace(survived(keys.back(), 0.01), std::to_string(seed)));
  }
  test::make_run(dir, keys, cells);
  for (const CellResult& cell : cells) write(cell, test::walking_trace(4000, 0.1));
  const std::size_t whole = page().html.size();
  ASSERT_EQ(summary.traces, 8U);
  std::size_t last = 8;
  for (const double share : {0.99, 0.9, 0.8}) {
    options.max_megabytes = 1e-6 * share * static_cast<double>(whole);
    const Page p = page();
    EXPECT_LE(static_cast<double>(fs::file_size(file)), 1e6 * options.max_megabytes);
    EXPECT_EQ(summary.traces + summary.left_out.size(), 8U);
    EXPECT_EQ(p.data["left_out"].size(), summary.left_out.size());
    EXPECT_LE(summary.traces, last);
    last = summary.traces;
  }
  EXPECT_LT(last, 8U);
}

TEST_F(Report, APageThatIsTooLargeWithoutTracesIsRefusedAndNothingIsWritten) {
  test::make_run(dir, {none}, {survived(none, 0.01)});
  options.max_megabytes = 0.001;
  EXPECT_THAT(store_error([&] { write_report(dir, file, options); }),
              AllOf(HasSubstr("page.html: the page takes 0."), HasSubstr("allowed: 0.001 MB (--max-size)")));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(Report, ARunWithNothingFinishedIsAPageThatSaysSo) {
  test::make_run(dir, {none, tuned}, {});
  const Page p = page();
  EXPECT_EQ(p.data["run"]["planned"], 2);
  EXPECT_EQ(p.data["run"]["finished"], 0);
  EXPECT_THAT(p.missing(), HasSubstr("2 of 2 cells have not been run"));
  EXPECT_THAT(p.missing(), HasSubstr("dobbench timing --out DIR"));
  EXPECT_TRUE(p.data["robots"].empty());
  EXPECT_TRUE(p.data["scenarios"][0]["robot"].is_null());
  EXPECT_TRUE(p.data["traces"].empty());
}

TEST_F(Report, ARunWithoutCellsIsAPageToo) {
  test::make_run(dir, {}, {});
  EXPECT_TRUE(page().data["cells"].empty());
}

TEST_F(Report, WhatARunWithoutTracesAndScenariosLacksIsSaid) {
  test::make_run(dir, {none}, {survived(none, 0.01)});
  const Page p = page();
  EXPECT_THAT(p.missing(), HasSubstr("No plots over time and no replay of case1/tip_lateral"));
  EXPECT_THAT(p.missing(), HasSubstr("does not say from which scenario file case1/tip_lateral was made"));
  EXPECT_THAT(p.missing(), Not(HasSubstr("have not been run")));
  EXPECT_TRUE(p.data["scenarios"][0]["duration_s"].is_null());
  EXPECT_TRUE(p.data["scenarios"][0]["boxes"].empty());
}

TEST_F(Report, AScenarioFileThatIsGoneCostsItsTerrainOnly) {
  RunInfo info;
  info.cells = {none};
  info.sources = {{"case1_tip_lateral_paper", "observer = \"none\""}};
  RunStore::create(dir, info, {{"case1_tip_lateral_paper", "nonsense = 1\n"}});
  EXPECT_THAT(page().missing(), HasSubstr("No terrain, duration and summary of case1/tip_lateral"));
  fs::remove_all(dir / "scenarios");
  EXPECT_THAT(page().missing(), HasSubstr("No terrain, duration and summary of case1/tip_lateral"));
}

TEST_F(Report, HistogramsOfASerialPassAreInThePage) {
  CellTiming timing{.key = none, .tick_p50_us = 50.0, .tick_histogram = time_histogram({40.0, 50.0, 60.0})};
  test::make_run(dir, {none, tuned}, {survived(none, 0.01)}, {timing});
  const Page p = page();
  ASSERT_EQ(p.data["timing"].size(), 1U);
  const Json& shown = p.data["timing"][0];
  EXPECT_EQ(shown["observer_id"], "none");
  EXPECT_EQ(shown["tick_p50_us"], 50.0);
  EXPECT_TRUE(shown["qp_histogram"].is_null());
  EXPECT_EQ(shown["tick_histogram"]["counts"].get<std::vector<long>>(), timing.tick_histogram.counts);
  const auto edges = shown["tick_histogram"]["edges_us"].get<std::vector<double>>();
  ASSERT_EQ(edges.size(), timing.tick_histogram.edges_us.size());
  for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_NEAR(edges[i] / timing.tick_histogram.edges_us[i], 1.0, 1e-3);
  EXPECT_THAT(p.missing(), Not(HasSubstr("histograms")));
}

TEST_F(Report, WhatIsNoRunIsRefused) {
  const auto error = [&] { return store_error([&] { write_report(dir, file, options); }); };
  EXPECT_THAT(error(), HasSubstr("run: no such directory"));
  fs::create_directories(dir);
  EXPECT_THAT(error(), HasSubstr("run: is not a run directory"));
  std::ofstream(dir / "run.sqlite") << "this is no database at all, but it is long enough to be taken for one";
  EXPECT_THAT(error(), HasSubstr("run.sqlite: "));
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace dob::report_test
