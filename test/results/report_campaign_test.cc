#include "results/report_campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/campaign_samples.h"
#include "test/results/report_samples.h"

namespace dob::report_campaign_test {
namespace {

using test::failed;
using test::key;
using test::survived;
using test::with_trace;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(CampaignJson, ARunThatIsNoneHasNone) {
  EXPECT_TRUE(campaign_json(std::nullopt, dob::Run{}).is_null());
}

TEST(CampaignJson, ACurveHasItsLevelsThresholdsAndSeeds) {
  const Json json = campaign_json(test::limit_result(), dob::Run{});
  EXPECT_EQ(json["kind"], "limit");
  EXPECT_EQ(json["axes"], Json::parse(R"([{"name": "amplitude", "unit": "N", "levels": [20.0, 40.0, 80.0],
                                           "logarithmic": true}])"));
  EXPECT_EQ(json["planned"], 60);
  ASSERT_EQ(json["curves"].size(), 2U);
  const Json& curve = json["curves"][0];
  EXPECT_EQ(curve["scenario_id"], "case1/tip_lateral");
  EXPECT_EQ(curve["observer_id"], "momentum@tuned");
  EXPECT_EQ(json["observers"][0]["id"], "momentum@tuned");
  EXPECT_EQ(json["settings"][curve["setting"].get<std::size_t>()]["gains"], "paper");
  EXPECT_EQ(curve["levels"][1]["falls"], 6);
  EXPECT_NEAR(curve["levels"][1]["falls_ci95"][0].get<double>(), 0.2538, 1e-4);
  EXPECT_NEAR(curve["levels"][1]["com_error_m"].get<double>(), 0.03, 1e-9);
  EXPECT_TRUE(curve["levels"][2]["com_error_m"].is_null());
  EXPECT_EQ(curve["fall_50"],
            Json::parse(R"({"estimate": 40.0, "ci95": [34.0, 47.0], "below": false, "above": false})"));
  EXPECT_TRUE(curve["fall_5"]["below"].get<bool>());
  EXPECT_EQ(curve["non_monotone"], Json::parse(R"([{"seed": 7, "fell_at": 40.0, "survived_at": 80.0}])"));
  EXPECT_TRUE(json["curves"][1]["fall_5"].is_null());
}

TEST(CampaignJson, WhatAnAxisChangesNeedsNotBeACellsObserver) {
  CampaignResult result = test::limit_result();
  result.curves[0].curve.key.overrides = "duration_s=4";
  const dob::Run run = test::run_of({survived(key("case1", "tip_lateral", "momentum:bandwidth=5", "tuned", 1), 0.01)});
  const Json json = campaign_json(result, run);
  EXPECT_EQ(json["observers"].size(), 2U);
  EXPECT_EQ(json["settings"][json["curves"][0]["setting"].get<std::size_t>()]["overrides"], "duration_s=4");
}

TEST(CampaignJson, AFactorialHasItsSharesOfVariance) {
  const Json json = campaign_json(test::factorial_result(), dob::Run{});
  EXPECT_EQ(json["factors"], Json({"scenario", "leg estimator"}));
  EXPECT_EQ(json["curves"][0]["factors"], Json({"case1", "momentum"}));
  const Json& response = json["factorial"][0];
  EXPECT_EQ(response["left_out"], 20);
  EXPECT_EQ(response["shares"][0],
            Json::parse(R"({"factor": "leg estimator", "levels": 4, "share": 0.61, "ci95": [0.55, 0.66]})"));
  EXPECT_TRUE(response["shares"][1]["ci95"].is_null());
}

TEST(CampaignJson, WhyCellsCouldNotBeRunIsCountedTheMostFrequentFirst) {
  const auto cell = [](int seed) { return key("case1", "", "none", "-", seed); };
  const dob::Run run = test::run_of({failed(cell(1), "/home/anna/a.so: is gone"), failed(cell(2), "b"),
                                     failed(cell(3), "b"), survived(cell(4), 0.01)});
  EXPECT_EQ(campaign_json(test::limit_result(), run)["reasons"],
            Json::parse(R"([{"reason": "b", "cells": 2}, {"reason": "a.so: is gone", "cells": 1}])"));
}

TEST(RunWithSeries, OfEachCurveAndLevelTheFirstCellThatHasOne) {
  Campaign campaign;
  std::vector<CellResult> cells;
  for (const int level : {0, 0, 0, 1, 1}) {
    cells.push_back(survived(key("case1", "", "none", "-", static_cast<int>(cells.size())), 0.01));
    campaign.cells.push_back({0, {level, 0}});
  }
  for (const std::size_t i : {1U, 2U, 4U}) cells[i].trace = "traces/a.dobtrace";
  dob::Run run = test::run_of(cells);
  run.info.sources = {{}, {}, {}, {}, {"last", ""}};
  run.timings = {{.key = cells[0].key}, {.key = cells[4].key}};
  const dob::Run part = run_with_series(run, campaign);
  ASSERT_EQ(part.cells.size(), 2U);
  EXPECT_EQ(part.cells[0].key.seed, 1);
  EXPECT_EQ(part.cells[1].key.seed, 4);
  EXPECT_EQ(part.info.cells.size(), 2U);
  EXPECT_EQ(part.info.sources[1].scenario, "last");
  ASSERT_EQ(part.timings.size(), 1U);
  EXPECT_EQ(part.timings[0].key.seed, 4);
}

class ReportOfACampaign : public test::ReportFixture {
 protected:
  const CellKey first = key("case1", "tip_lateral", "momentum", "tuned", 1);
  const CellKey second = key("case1", "tip_lateral", "momentum", "tuned", 2);
  const CellKey open = key("case1", "tip_lateral", "momentum", "tuned", 3);

  test::Page page_of(const CellResult& a, const CellResult& b) {
    test::make_run(dir, {first, second, open}, {a, b});
    for (const CellResult& cell : {a, b}) {
      if (!cell.trace.empty()) write_trace(dir / cell.trace, test::walking_trace());
    }
    CampaignResult result = test::limit_result();
    result.campaign.cells.resize(3);
    summary = write_report(dir, read_run(dir), result, file, options);
    return test::read_page(file);
  }
};

TEST_F(ReportOfACampaign, ListsTheCellsThatCanBeReplayedAndNeitherRowsNorClaims) {
  const test::Page p = page_of(survived(first, 0.01), with_trace(survived(second, 0.01), "b"));
  EXPECT_EQ(p.data["campaign"]["name"], "push");
  EXPECT_EQ(p.data["campaign"]["finished"], 2);
  EXPECT_TRUE(p.data["rows"].empty());
  EXPECT_TRUE(p.data["claims"].empty());
  ASSERT_EQ(p.data["cells"].size(), 1U);
  EXPECT_EQ(p.data["cells"][0]["seed"], 2);
  ASSERT_EQ(p.data["traces"].size(), 1U);
  EXPECT_EQ(p.data["traces"][0]["cell"], 0);
  EXPECT_EQ(p.data["run"]["planned"], 3);
  EXPECT_THAT(p.missing(), Not(HasSubstr("have not been run"))) << "a search needs not run all";
}

TEST_F(ReportOfACampaign, WithoutTimeSeriesSaysSo) {
  const test::Page p = page_of(survived(first, 0.01), survived(second, 0.01));
  EXPECT_TRUE(p.data["cells"].empty());
  EXPECT_THAT(p.missing(), HasSubstr("this campaign kept no time series"));
}

}  // namespace
}  // namespace dob::report_campaign_test
