#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/table.h"
#include "test/results/run_samples.h"

namespace dob::table_data_test {
namespace {

using nlohmann::json;
using test::fell;
using test::key;
using test::run_of;
using test::survived;

// Those that a reader of the tables may count on; there may be more.
const std::set<std::string> kMetrics{
    "com_error_max_m",      "com_error_rms_m",    "com_error_p99_m",           "path_error_max_m",
    "foot_error_max_m",     "foot_error_p99_m",   "foot_error_onset_max_m",    "foot_error_stance_max_m",
    "foothold_error_max_m", "grf_error_mean_N",   "estimate_rmse_N",           "joint_estimate_rmse_Nm",
    "com_force_rmse_N",     "com_moment_rmse_Nm", "orientation_error_max_rad", "torque_saturation_ratio",
    "qp_failures",          "slip_max_m",         "planner_failures"};
const std::set<std::string> kPaired{"com_error_max_m", "com_error_rms_m", "path_error_max_m", "foot_error_max_m",
                                    "grf_error_mean_N"};
const std::set<std::string> kTiming{"tick_time_p50_us", "tick_time_p99_us", "tick_time_max_us",
                                    "qp_time_p50_us",   "qp_time_p99_us",   "real_time_factor"};

std::set<std::string> all_fields(bool timing) {
  std::set<std::string> names{
      "scenario", "variant",     "observer",     "profile",    "gains",      "planner", "overrides",
      "seeds",    "runs",        "falls",        "falls_ci95", "errors",     "oracle",  "fall_time_median_s",
      "rank",     "fall_reason", "error_reason", "reference",  "paired_runs"};
  for (const std::string& metric : kPaired) names.insert({"paired_" + metric, "paired_" + metric + "_ci95"});
  for (const std::string& metric : kMetrics) names.insert({metric, metric + "_worst", metric + "_ci95"});
  if (timing) names.insert(kTiming.begin(), kTiming.end());
  return names;
}

std::string render(const Run& run, TableFormat format, bool timing = false) {
  return render_table(run, {format, TableOrder::kByScenario, timing});
}

Run two_observers() {
  CellResult good = survived(key("case1", "knee", "momentum", "paper", 1), 0.018);
  CellResult bad = fell(key("case1", "knee", "none", "-", 1), 20.5, 0.25);
  good.checkpoints = {test::checkpoint(20.0, 0.0625), test::checkpoint(20.5, 0.125), test::checkpoint(46.0, 0.018)};
  bad.checkpoints = {test::checkpoint(20.0, 0.1875), test::checkpoint(20.499, 0.25)};
  Run run = run_of({bad, good});
  run.timings = {{good.key, 10.0, 20.0, 300.0, 5.0, 8.0, 9.0, 19.5}};
  return run;
}

std::set<std::string> names_of(const json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

TEST(TableJsonTest, FieldsAreThoseOfTheContract) {
  for (const bool timing : {false, true}) {
    const std::set<std::string> names =
        names_of(json::parse(render(two_observers(), TableFormat::kJson, timing)).at(0));
    const std::set<std::string> promised = all_fields(timing);
    EXPECT_TRUE(std::includes(names.begin(), names.end(), promised.begin(), promised.end()));
    EXPECT_EQ(names.contains("real_time_factor"), timing);
  }
}

TEST(TableJsonTest, RowsHoldTheFiguresInSi) {
  const json table = json::parse(render(two_observers(), TableFormat::kJson, true));
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table[0]["observer"], "none");
  EXPECT_EQ(table[0]["falls"], 1);
  EXPECT_EQ(table[0]["fall_time_median_s"], 20.5);
  EXPECT_EQ(table[0]["fall_reason"], "trunk tilted");
  EXPECT_EQ(table[0]["error_reason"], nullptr);
  EXPECT_EQ(table[0]["real_time_factor"], nullptr);
  EXPECT_EQ(table[1]["com_error_max_m"], 0.018);
  EXPECT_EQ(table[1]["com_error_max_m_worst"], 0.018);
  EXPECT_EQ(table[1]["com_error_max_m_ci95"], nullptr);
  EXPECT_EQ(table[1]["estimate_rmse_N"], nullptr);
  EXPECT_EQ(table[1]["fall_time_median_s"], nullptr);
  EXPECT_EQ(table[0]["rank"], 2);
  EXPECT_EQ(table[1]["rank"], 1);
  EXPECT_EQ(table[1]["oracle"], false);
  EXPECT_EQ(table[1]["tick_time_p50_us"], 10.0);
  EXPECT_EQ(table[1]["tick_time_p99_us"], 20.0);
  EXPECT_EQ(table[1]["tick_time_max_us"], 300.0);
  EXPECT_EQ(table[1]["qp_time_p50_us"], 5.0);
  EXPECT_EQ(table[1]["qp_time_p99_us"], 8.0);
  EXPECT_EQ(table[1]["real_time_factor"], 19.5);
}

TEST(TableJsonTest, PairsAreComparedAtTheLastMomentBothReached) {
  const json table = json::parse(render(two_observers(), TableFormat::kJson));
  EXPECT_EQ(table[0]["reference"], nullptr);  // it is the reference
  EXPECT_EQ(table[0]["paired_runs"], nullptr);
  EXPECT_EQ(table[1]["reference"], "none@-");
  EXPECT_EQ(table[1]["paired_runs"], 1);
  EXPECT_EQ(table[1]["paired_com_error_max_m"], 0.0625 - 0.1875);
  EXPECT_EQ(table[1]["paired_foot_error_max_m"], 10.0 * (0.0625 - 0.1875));
  EXPECT_EQ(table[1]["paired_grf_error_mean_N"], nullptr);
  EXPECT_EQ(table[1]["paired_com_error_max_m_ci95"], nullptr);
}

TEST(TableJsonTest, WithoutTimingItIsTheSameBytesWhateverWasTimed) {
  dob::Run untimed = two_observers();
  untimed.timings.clear();
  untimed.cells[0].wall_s = 5.0;
  for (const auto format :
       {TableFormat::kText, TableFormat::kMarkdown, TableFormat::kCsv, TableFormat::kLatex, TableFormat::kJson}) {
    EXPECT_EQ(render(untimed, format), render(two_observers(), format));
    EXPECT_NE(render(untimed, format, true), render(two_observers(), format, true));
  }
}

TEST(TableJsonTest, IntervalsAreTwoNumbers) {
  std::vector<CellResult> cells;
  for (int i = 1; i <= 8; ++i) cells.push_back(survived(key("s", "", "o", "-", i), 0.25));
  const json row = json::parse(render(run_of(cells), TableFormat::kJson)).at(0);
  EXPECT_EQ(row["com_error_max_m_ci95"], json::array({0.25, 0.25}));
  EXPECT_EQ(row["falls_ci95"][0], 0.0);
}

TEST(TableJsonTest, RunWithoutCellsIsAnEmptyArray) {
  EXPECT_EQ(render(dob::Run{}, TableFormat::kJson), "[]\n");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> values_of(const std::string& line) {
  std::vector<std::string> values;
  std::istringstream in(line + ",");
  for (std::string value; std::getline(in, value, ',');) values.push_back(value);
  return values;
}

// Names and values of a row of JSON as they should stand in CSV.
std::pair<std::vector<std::string>, std::vector<std::string>> flattened(const nlohmann::ordered_json& row) {
  std::vector<std::string> names, values;
  for (const auto& [name, value] : row.items()) {
    const bool interval = name.ends_with("_ci95");
    for (const char* suffix : interval ? std::vector<const char*>{"_low", "_high"} : std::vector<const char*>{""}) {
      names.push_back(name + suffix);
      values.push_back(value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  return {names, values};
}

TEST(TableCsvTest, HeadingAndLinesHoldWhatJsonHoldsWithIntervalsInTwoColumns) {
  const auto lines = lines_of(render(two_observers(), TableFormat::kCsv, true));
  const auto table = nlohmann::ordered_json::parse(render(two_observers(), TableFormat::kJson, true));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[0], ::testing::StartsWith("scenario,variant,observer,profile,gains,planner,overrides,seeds,runs,"
                                              "falls,falls_ci95_low,falls_ci95_high,errors,fall_time_median_s,"));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [names, values] = flattened(table[i]);
    EXPECT_EQ(values_of(lines[0]), names);
    EXPECT_EQ(values_of(lines[i + 1]), values);
  }
}

TEST(TableCsvTest, IntervalsFillTheirTwoColumns) {
  std::vector<CellResult> cells;
  for (int i = 1; i <= 8; ++i) cells.push_back(survived(key("s", "", "o", "-", i), 0.25));
  EXPECT_THAT(lines_of(render(run_of(cells), TableFormat::kCsv)).at(1), ::testing::HasSubstr(",0.25,0.25,0.25,0.25,"));
}

TEST(TableCsvTest, QuotesWhatWouldBreakALine) {
  CellResult cell = test::failed(key("s", "a\"b", "legs=x,com=y", "-", 1), "two\nlines");
  cell.key.overrides = "plain";
  const std::string csv = render(run_of({cell}), TableFormat::kCsv);
  EXPECT_THAT(csv, ::testing::HasSubstr("s,\"a\"\"b\",\"legs=x,com=y\",-,paper,spline,plain,1,0,0,,,1,"));
  EXPECT_THAT(csv, ::testing::HasSubstr(",\"two\nlines\"\n"));
}

}  // namespace
}  // namespace dob::table_data_test
