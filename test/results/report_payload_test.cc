#include "results/report_payload.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/report_samples.h"

namespace dob::report_payload_test {
namespace {

using test::PageTrace;
using test::trace_of;
using test::walking_trace;
using ::testing::HasSubstr;

PageTrace encoded(const Trace& trace) {
  const TracePayload payload = encode_trace(trace);
  return {payload.description, payload.base64};
}

TEST(ReportPayload, ReplayFramesAreTheSamplesAtTheirTimes) {
  const PageTrace page = encoded(walking_trace(301));
  EXPECT_TRUE(page.is_complete());
  EXPECT_EQ(page.description()["replay"]["rate_Hz"], 25.0);
  ASSERT_EQ(page.description()["replay"]["frames"], 76);  // 0 to 3 s, both included
  const std::vector<double> x = page.replay("trunk/x_m"), hip = page.replay("LF/hip/angle_rad");
  ASSERT_EQ(hip.size(), 76U);
  for (std::size_t k = 0; k < hip.size(); ++k) {
    const double t = static_cast<double>(k) / 25.0;
    EXPECT_NEAR(x[k], 0.1 * t, 0.51 * page.scale("replay", "trunk/x_m"));
    EXPECT_NEAR(hip[k], 0.3 * std::sin(t), 0.51 * page.scale("replay", "LF/hip/angle_rad"));
  }
  EXPECT_LE(page.scale("replay", "trunk/x_m"), 1e-3) << "a millimetre is seen";
  EXPECT_EQ(page.replay("trunk/qw")[0], 1.0);
}

TEST(ReportPayload, FramesOfAnotherRateAreTheNearestSamples) {
  const double rate = 1000.0 / 9.0;  // every ninth tick of 1 ms
  const PageTrace page = encoded(trace_of(1000, {{"trunk/x_m", [](double t) { return t; }}}, rate));
  const std::vector<double> x = page.replay("trunk/x_m");
  ASSERT_EQ(x.size(), 225U);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], static_cast<double>(k) / 25.0, 0.5 / rate + 1e-3);
  const PageTrace slow = encoded(trace_of(10, {{"trunk/x_m", [](double t) { return t; }}}, 10.0));
  EXPECT_EQ(slow.description()["replay"]["rate_Hz"], 10.0);
  EXPECT_EQ(slow.replay("trunk/x_m").size(), 10U);
}

TEST(ReportPayload, PlotsKeepAPeakOfOneSampleAtItsTime) {
  const double peak = 23.45;  // [s] of 60
  const PageTrace page =
      encoded(trace_of(6001, {{"com_error_m", [peak](double t) { return std::abs(t - peak) < 0.004 ? 0.5 : 0.01; }}}));
  const auto& plots = page.description()["plots"];
  const std::vector<double> error = page.plot("com_error_m");
  ASSERT_EQ(error.size(), plots["points"].get<std::size_t>());
  ASSERT_EQ(plots["points"].get<int>(), 2 * plots["buckets"].get<int>());
  EXPECT_LT(error.size(), 2000U) << "decimated";
  const auto highest = std::max_element(error.begin(), error.end());
  EXPECT_NEAR(*highest, 0.5, page.scale("plots", "com_error_m"));
  const double bucket = plots["bucket_s"];
  const double begin = std::floor(static_cast<double>(highest - error.begin()) / 2.0) * bucket;
  EXPECT_LE(begin, peak + 0.005);
  EXPECT_GE(begin + bucket, peak - 0.005);
  EXPECT_GE(plots["buckets"].get<double>() * bucket, 60.0) << "to the end";
}

TEST(ReportPayload, ThePathErrorIsTheHorizontalDistanceToThePath) {
  const PageTrace page = encoded(walking_trace());
  const std::vector<double> error = page.plot("path_error_m");
  ASSERT_FALSE(error.empty());
  for (const double e : error) EXPECT_NEAR(e, 0.005, 0.51 * page.scale("plots", "path_error_m"));
}

TEST(ReportPayload, SignalsThatAreNotThereOrApplyNowhereAreLeftOut) {
  const PageTrace page = encoded(walking_trace());
  EXPECT_TRUE(page.replay("applied/point/x_m").empty()) << "NaN throughout";
  EXPECT_TRUE(page.replay("RF/stance").empty()) << "not recorded";
  const PageTrace without_path = encoded(trace_of(10, {{"com/x_m", [](double) { return 0.0; }}}));
  EXPECT_TRUE(without_path.plot("path_error_m").empty());
}

TEST(ReportPayload, AForceThatActsForAWhileDoesNotApplyBesides) {
  const auto point = [](double t) { return t < 1.0 ? std::nan("") : 0.25; };
  const std::vector<double> x = encoded(trace_of(200, {{"applied/point/x_m", point}})).replay("applied/point/x_m");
  ASSERT_EQ(x.size(), 50U);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (k < 25) {
      EXPECT_TRUE(std::isnan(x[k])) << k;
    } else {
      EXPECT_NEAR(x[k], 0.25, 1e-3) << k;
    }
  }
}

TEST(ReportPayload, SwingsAndDisturbancesAreIntervals) {
  const PageTrace page = encoded(walking_trace(300));
  const auto& swings = page.description()["swings"];
  EXPECT_EQ(swings["LF"], nlohmann::ordered_json::parse("[[0.5, 0.7]]"));
  EXPECT_EQ(swings["RF"], nlohmann::ordered_json::array()) << "not recorded";
  EXPECT_EQ(page.description()["disturbed"], nlohmann::ordered_json::parse("[[2.0, 3.0]]")) << "to the end";
  EXPECT_NEAR(page.description()["end_s"].get<double>(), 2.99, 1e-9);
}

TEST(ReportPayload, ATraceOfOneSampleIsOneFrameAndOneBucket) {
  const PageTrace page = encoded(walking_trace(1));
  EXPECT_EQ(page.replay("trunk/x_m").size(), 1U);
  EXPECT_EQ(page.plot("com_error_m").size(), 2U);
  EXPECT_EQ(page.description()["end_s"], 0.0);
}

TEST(ReportPayload, WhatCannotBeDrawnIsRefused) {
  EXPECT_THAT(test::store_error([] { encode_trace(walking_trace(0)); }), HasSubstr("no samples"));
  for (const double rate : {0.0, -1.0, std::nan(""), 1e300}) {
    Trace trace = walking_trace(3);
    trace.rate_Hz = rate;
    EXPECT_THAT(test::store_error([&] { encode_trace(trace); }), HasSubstr("rate")) << rate;
  }
}

}  // namespace
}  // namespace dob::report_payload_test
