#include "results/figure_lines.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/figure_samples.h"

namespace dob::figure_lines_test {
namespace {

using std::pair;
using test::quantity;
using test::trace_of;
using ::testing::HasSubstr;

TEST(FigureSeries, OfOneSignalIsItsColumnInTheUnitOfTheAxis) {
  const Trace trace = trace_of(5, pair("com_error_m", [](float t) { return 1.0F + t; }));
  const FigureSeries series = series_of(trace, quantity({"com_error_m"}), "");
  ASSERT_EQ(series.value.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(series.t[i], trace.columns[0][i]);
    EXPECT_EQ(series.value[i], 1000.0 * trace.columns[1][i]);
  }
}

TEST(FigureSeries, OfSeveralSignalsIsTheNormOfTheDifference) {
  const Trace trace = trace_of(2, pair("LF/a", [](float) { return 5; }), pair("LF/b", [](float) { return 4; }),
                               pair("LF/c", [](float) { return 2; }), pair("LF/d", [](float) { return 0; }));
  FigureQuantity q = quantity({"$/a", "$/b"});
  q.scale = 1.0;
  q.minus = {"$/c", "$/d"};
  EXPECT_DOUBLE_EQ(series_of(trace, q, "LF").value[1], 5.0);  // (3, 4)
  q.truth = {"$/c", "$/d"};
  EXPECT_DOUBLE_EQ(truth_of(trace, q, "LF").value[1], 2.0);
  q.signals = {"$/c"};
  q.minus = {"$/a"};
  EXPECT_DOUBLE_EQ(series_of(trace, q, "LF").value[1], -3.0);  // one: with its sign
}

TEST(FigureSeries, AppliesOnlyWhileItsSignalIsThere) {
  const Trace trace =
      trace_of(4, pair("x", [](float) { return 1; }), pair("RF/stance", [](float t) { return t < 0.015F ? 1 : 0; }));
  FigureQuantity q = quantity({"x"});
  q.while_signal = "$/stance";
  const FigureSeries series = series_of(trace, q, "RF");
  EXPECT_EQ(series.value[1], 1000.0);
  EXPECT_TRUE(std::isnan(series.value[2]));
}

TEST(FigureSeries, NamesTheSignalThatATraceLacks) {
  const Trace trace = trace_of(1);
  EXPECT_THAT(test::store_error([&] { series_of(trace, quantity({"$/foot_error_m"}), "LH"); }),
              HasSubstr("LH/foot_error_m"));
}

TEST(Decimated, KeepsTheExtremesOfEveryStretchAtTheirTimes) {
  FigureSeries series;
  for (int i = 0; i < 1000; ++i) {
    series.t.push_back(i);
    series.value.push_back(std::sin(0.37 * i));
  }
  series.value[123] = 9.0;
  series.value[678] = -7.0;
  const FigureSeries few = decimated(series, 10);
  ASSERT_EQ(few.t.size(), 20U);
  EXPECT_TRUE(std::is_sorted(few.t.begin(), few.t.end()));
  const auto high = std::max_element(few.value.begin(), few.value.end());
  const auto low = std::min_element(few.value.begin(), few.value.end());
  EXPECT_EQ(*high, 9.0);
  EXPECT_EQ(few.t[static_cast<std::size_t>(high - few.value.begin())], 123.0);
  EXPECT_EQ(*low, -7.0);
  EXPECT_EQ(few.t[static_cast<std::size_t>(low - few.value.begin())], 678.0);
}

TEST(Decimated, LeavesAGapWhereNothingApplies) {
  FigureSeries series;
  for (int i = 0; i < 100; ++i) {
    series.t.push_back(i);
    series.value.push_back(i / 10 == 4 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
  }
  const FigureSeries few = decimated(series, 10);
  EXPECT_EQ(std::count_if(few.value.begin(), few.value.end(), [](double v) { return std::isnan(v); }), 1);
}

TEST(Decimated, AShortSeriesStaysAsItIs) {
  const FigureSeries series{{0, 1, 2}, {5, 4, 3}};
  EXPECT_EQ(decimated(series, 10).value, series.value);
}

TEST(Bands, AreWhereALegSwingsAndWhereADisturbanceActs) {
  const Trace trace = trace_of(100, pair("LF/stance", [](float t) { return t > 0.195F && t < 0.305F ? 0 : 1; }),
                               pair("disturbance_active", [](float t) { return t > 0.895F ? 1 : 0; }));
  const std::vector<FigureBand> swings = swings_of(trace, "LF");
  ASSERT_EQ(swings.size(), 1U);
  EXPECT_FLOAT_EQ(static_cast<float>(swings[0].from), 0.2F);
  EXPECT_FLOAT_EQ(static_cast<float>(swings[0].to), 0.31F);  // the first sample on the ground
  const std::vector<FigureBand> pushes = disturbances_of(trace);
  ASSERT_EQ(pushes.size(), 1U);
  EXPECT_FLOAT_EQ(static_cast<float>(pushes[0].to), 0.99F);  // the end of the trace
  EXPECT_TRUE(pushes[0].disturbance);
}

}  // namespace
}  // namespace dob::figure_lines_test
