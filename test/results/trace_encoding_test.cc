#include "results/trace_encoding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results/zlib_stream.h"
#include "test/results/trace_decoder.h"

namespace dob::trace_encoding_test {
namespace {

using test::from_base64;
using test::inflated;
using test::numbers_at;
using test::values_of;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<double> decoded(const QuantisedColumn& column) {
  return values_of(column.numbers, column.offset, column.scale);
}

TEST(TraceEncoding, ValuesComeBackWithinHalfAStep) {
  std::vector<float> column;
  for (int i = 0; i < 2000; ++i) column.push_back(static_cast<float>(0.3 * std::sin(0.01 * i)));
  const QuantisedColumn quantised = quantise(column, 1e-4);
  EXPECT_EQ(quantised.scale, 1e-4);
  const std::vector<double> back = decoded(quantised);
  ASSERT_EQ(back.size(), column.size());
  for (std::size_t i = 0; i < column.size(); ++i) EXPECT_NEAR(back[i], column[i], 0.5001e-4) << i;
}

TEST(TraceEncoding, ZeroAndCountsStayWhatTheyAre) {
  EXPECT_EQ(decoded(quantise({0.0F, 1.0F, -0.0F, 12.0F}, 1.0)), (std::vector<double>{0.0, 1.0, 0.0, 12.0}));
  EXPECT_EQ(decoded(quantise({0.0F, 35.2F}, 0.02)).front(), 0.0);
}

TEST(TraceEncoding, AWideRangeMakesTheStepsCoarserAndKeepsItsEnds) {
  const std::vector<float> column{-1e6F, 0.0F, 3e6F};
  const QuantisedColumn quantised = quantise(column, 1e-3);
  EXPECT_NEAR(quantised.scale, 4e6 / 65534.0, 1e-6);
  const std::vector<double> back = decoded(quantised);
  for (std::size_t i = 0; i < column.size(); ++i) EXPECT_NEAR(back[i], column[i], 0.5001 * quantised.scale);
}

TEST(TraceEncoding, ANarrowRangeFarFromZeroKeepsItsResolution) {
  const std::vector<float> column{1000.0F, 1000.25F, 1000.5F};
  const QuantisedColumn quantised = quantise(column, 1e-3);
  EXPECT_EQ(quantised.scale, 1e-3);
  const std::vector<double> back = decoded(quantised);
  for (std::size_t i = 0; i < column.size(); ++i) EXPECT_NEAR(back[i], column[i], 0.5001e-3);
}

TEST(TraceEncoding, WhatIsNotFiniteDoesNotApply) {
  const QuantisedColumn quantised = quantise({1.0F, kNan, kInfinity, -kInfinity, 2.0F}, 0.5);
  EXPECT_EQ(quantised.numbers, (std::vector<std::int16_t>{2, -32768, -32768, -32768, 4}));
  EXPECT_EQ(quantise({kNan, kNan}, 0.5).numbers, (std::vector<std::int16_t>{-32768, -32768}));
  EXPECT_TRUE(quantise({}, 0.5).numbers.empty());
}

TEST(TraceEncoding, NoValueIsTakenForOneThatDoesNotApply) {
  const float most = std::numeric_limits<float>::max();
  const QuantisedColumn quantised = quantise({-most, most, 0.0F}, 1e-5);
  EXPECT_EQ(std::count(quantised.numbers.begin(), quantised.numbers.end(), kDoesNotApply), 0);
  EXPECT_NEAR(decoded(quantised)[0] / -static_cast<double>(most), 1.0, 1e-4);
}

TEST(TraceEncoding, DecimationKeepsEveryBucketsExtremesInTheirOrder) {
  EXPECT_EQ(min_max_decimated({1.0F, 5.0F, -2.0F, /**/ 3.0F, 0.0F, 9.0F, /**/ 4.0F}, 3),
            (std::vector<float>{5.0F, -2.0F, 0.0F, 9.0F, 4.0F, 4.0F}));
  EXPECT_EQ(min_max_decimated({2.0F, 2.0F}, 2), (std::vector<float>{2.0F, 2.0F}));
  EXPECT_TRUE(min_max_decimated({}, 4).empty());
}

TEST(TraceEncoding, NoPeakIsLostWhereverItStands) {
  for (std::size_t peak = 0; peak < 100; ++peak) {
    std::vector<float> column(100, 1.0F);
    column[peak] = -50.0F;
    const std::vector<float> points = min_max_decimated(column, 7);
    EXPECT_EQ(std::count(points.begin(), points.end(), -50.0F), 1) << peak;
    const auto place = std::find(points.begin(), points.end(), -50.0F) - points.begin();
    EXPECT_EQ(static_cast<std::size_t>(place) / 2, peak / 7) << "in its own bucket";
  }
}

TEST(TraceEncoding, ABucketDoesNotApplyOnlyWhereNoneOfItsValuesDoes) {
  const std::vector<float> points = min_max_decimated({kNan, 3.0F, kNan, /**/ kNan, kNan, kNan}, 3);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0], 3.0F);
  EXPECT_EQ(points[1], 3.0F);
  EXPECT_TRUE(std::isnan(points[2]));
  EXPECT_TRUE(std::isnan(points[3]));
  const std::vector<float> late = min_max_decimated({kNan, 3.0F, -1.0F, 7.0F}, 4);
  EXPECT_EQ(late, (std::vector<float>{-1.0F, 7.0F}));
}

TEST(TraceEncoding, DifferencesSumUpAcrossTheWholeRange) {
  const std::vector<std::int16_t> numbers{-32768, 32767, 0, -32767, 32767, 1, -1};
  const std::string bytes = delta_coded(numbers);
  ASSERT_EQ(bytes.size(), 2 * numbers.size());
  EXPECT_EQ(numbers_at(bytes, 0, numbers.size()), numbers);
  EXPECT_EQ(delta_coded({1, 3, 2}), std::string("\x01\x00\x02\x00\xFF\xFF", 6));
}

// RFC 4648, section 10.
TEST(TraceEncoding, Base64OfTheStandardsExamples) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFB\xFF\xFE"), "+//+");
}

TEST(TraceEncoding, BytesSurviveCompressionAndBase64) {
  std::mt19937 random(7);
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(random() & 0xFFU);
  EXPECT_EQ(inflated(from_base64(base64(zlib_stream(bytes, 9)))), bytes);
  EXPECT_EQ(inflated(zlib_stream("", 9)), "");
}

}  // namespace
}  // namespace dob::trace_encoding_test
