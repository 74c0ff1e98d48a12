#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/table.h"
#include "test/results/run_samples.h"

namespace dob {
namespace {

using nlohmann::json;
using test::fell;
using test::key;
using test::run_of;
using test::survived;

const std::set<std::string> kMetrics{"com_error_max_m",
                                     "com_error_rms_m",
                                     "com_error_p99_m",
                                     "path_error_max_m",
                                     "foot_error_max_m",
                                     "foot_error_p99_m",
                                     "foot_error_onset_max_m",
                                     "foot_error_stance_max_m",
                                     "foothold_error_max_m",
                                     "grf_error_mean_N",
                                     "estimate_rmse_N",
                                     "joint_estimate_rmse_Nm",
                                     "orientation_error_max_rad",
                                     "torque_saturation_ratio",
                                     "qp_failures",
                                     "slip_max_m",
                                     "planner_failures",
                                     "estimate_offset_Nm",
                                     "estimate_overshoot",
                                     "estimate_settling_s",
                                     "com_error_swing_max_m",
                                     "com_error_stance_max_m",
                                     "com_peak_before_m",
                                     "com_peak_push_m",
                                     "com_peak_recovery_m",
                                     "foot_peak_push_m",
                                     "foot_peak_rest_m"};
const std::set<std::string> kTiming{"tick_time_p50_us", "tick_time_p99_us", "tick_time_max_us",
                                    "qp_time_p50_us",   "qp_time_p99_us",   "real_time_factor"};

std::set<std::string> all_fields(bool timing) {
  std::set<std::string> names{"scenario",           "variant",     "observer",    "profile", "gains",      "planner",
                              "overrides",          "seeds",       "runs",        "falls",   "falls_ci95", "errors",
                              "fall_time_median_s", "fall_reason", "error_reason"};
  for (const std::string& metric : kMetrics) names.insert({metric, metric + "_worst", metric + "_ci95"});
  if (timing) names.insert(kTiming.begin(), kTiming.end());
  return names;
}

std::string render(const Run& run, TableFormat format, bool timing = false) {
  return render_table(run, {format, TableOrder::kByScenario, timing});
}

Run two_observers() {
  CellResult good = survived(key("case1", "knee", "momentum", "paper", 1), 0.018);
  good.wall_s = 2.3;
  return run_of({fell(key("case1", "knee", "none", "-", 1), 20.5, 0.25), good});
}

std::set<std::string> names_of(const json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

TEST(TableJsonTest, FieldsAreThoseOfTheContract) {
  EXPECT_EQ(names_of(json::parse(render(two_observers(), TableFormat::kJson)).at(0)), all_fields(false));
  EXPECT_EQ(names_of(json::parse(render(two_observers(), TableFormat::kJson, true)).at(1)), all_fields(true));
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
  EXPECT_DOUBLE_EQ(table[1]["real_time_factor"].get<double>(), 20.0);
  EXPECT_EQ(table[1]["tick_time_p50_us"], nullptr);
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

TEST(TableCsvTest, HeadingAndLineStandForEveryField) {
  const auto lines = lines_of(render(two_observers(), TableFormat::kCsv));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0],
            "scenario,variant,observer,profile,gains,planner,overrides,seeds,runs,falls,falls_ci95_low,"
            "falls_ci95_high,errors,fall_time_median_s,"
            "com_error_max_m,com_error_max_m_worst,com_error_max_m_ci95_low,com_error_max_m_ci95_high,"
            "com_error_rms_m,com_error_rms_m_worst,com_error_rms_m_ci95_low,com_error_rms_m_ci95_high,"
            "com_error_p99_m,com_error_p99_m_worst,com_error_p99_m_ci95_low,com_error_p99_m_ci95_high,"
            "path_error_max_m,path_error_max_m_worst,path_error_max_m_ci95_low,path_error_max_m_ci95_high,"
            "foot_error_max_m,foot_error_max_m_worst,foot_error_max_m_ci95_low,foot_error_max_m_ci95_high,"
            "foot_error_p99_m,foot_error_p99_m_worst,foot_error_p99_m_ci95_low,foot_error_p99_m_ci95_high,"
            "foot_error_onset_max_m,foot_error_onset_max_m_worst,foot_error_onset_max_m_ci95_low,"
            "foot_error_onset_max_m_ci95_high,"
            "foot_error_stance_max_m,foot_error_stance_max_m_worst,foot_error_stance_max_m_ci95_low,"
            "foot_error_stance_max_m_ci95_high,"
            "foothold_error_max_m,foothold_error_max_m_worst,foothold_error_max_m_ci95_low,"
            "foothold_error_max_m_ci95_high,"
            "grf_error_mean_N,grf_error_mean_N_worst,grf_error_mean_N_ci95_low,grf_error_mean_N_ci95_high,"
            "estimate_rmse_N,estimate_rmse_N_worst,estimate_rmse_N_ci95_low,estimate_rmse_N_ci95_high,"
            "joint_estimate_rmse_Nm,joint_estimate_rmse_Nm_worst,joint_estimate_rmse_Nm_ci95_low,"
            "joint_estimate_rmse_Nm_ci95_high,"
            "orientation_error_max_rad,orientation_error_max_rad_worst,orientation_error_max_rad_ci95_low,"
            "orientation_error_max_rad_ci95_high,"
            "torque_saturation_ratio,torque_saturation_ratio_worst,torque_saturation_ratio_ci95_low,"
            "torque_saturation_ratio_ci95_high,"
            "qp_failures,qp_failures_worst,qp_failures_ci95_low,qp_failures_ci95_high,"
            "slip_max_m,slip_max_m_worst,slip_max_m_ci95_low,slip_max_m_ci95_high,"
            "planner_failures,planner_failures_worst,planner_failures_ci95_low,planner_failures_ci95_high,"
            "estimate_offset_Nm,estimate_offset_Nm_worst,estimate_offset_Nm_ci95_low,estimate_offset_Nm_ci95_high,"
            "estimate_overshoot,estimate_overshoot_worst,estimate_overshoot_ci95_low,estimate_overshoot_ci95_high,"
            "estimate_settling_s,estimate_settling_s_worst,estimate_settling_s_ci95_low,estimate_settling_s_ci95_high,"
            "com_error_swing_max_m,com_error_swing_max_m_worst,com_error_swing_max_m_ci95_low,com_error_swing_max_m_"
            "ci95_high,"
            "com_error_stance_max_m,com_error_stance_max_m_worst,com_error_stance_max_m_ci95_low,com_error_stance_max_"
            "m_ci95_high,"
            "com_peak_before_m,com_peak_before_m_worst,com_peak_before_m_ci95_low,com_peak_before_m_ci95_high,"
            "com_peak_push_m,com_peak_push_m_worst,com_peak_push_m_ci95_low,com_peak_push_m_ci95_high,"
            "com_peak_recovery_m,com_peak_recovery_m_worst,com_peak_recovery_m_ci95_low,com_peak_recovery_m_ci95_high,"
            "foot_peak_push_m,foot_peak_push_m_worst,foot_peak_push_m_ci95_low,foot_peak_push_m_ci95_high,"
            "foot_peak_rest_m,foot_peak_rest_m_worst,foot_peak_rest_m_ci95_low,foot_peak_rest_m_ci95_high,"
            "fall_reason,error_reason");
  EXPECT_EQ(lines[1], "case1,knee,none,-,paper,spline,,1,1,1,,,0,20.5,0.25,0.25,,," + std::string(52, ',') +
                          "0.0,0.0,,,,,,,0.0,0.0,,," + std::string(40, ',') + "trunk tilted,");
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
}  // namespace dob
