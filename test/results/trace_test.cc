#include "results/trace.h"

#include <bit>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::trace_test {
namespace {

using test::read_text;
using test::store_error;
using ::testing::HasSubstr;

class TraceTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path file = temporary.path() / "cell.dobtrace";
  Trace trace{200.0,
              {"t_s", "com/x_m"},
              {{0.0F, 0.005F, 0.01F},
               {-0.0F, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::quiet_NaN()}}};

  std::string error_with(std::size_t position, char byte) const {
    std::string bytes = read_text(file);
    bytes.at(position) = byte;
    std::ofstream(file, std::ios::binary) << bytes;
    return store_error([&] { read_trace(file); });
  }
};

TEST_F(TraceTest, ReadsBackBitForBit) {
  write_trace(file, trace);
  const Trace back = read_trace(file);
  EXPECT_EQ(back.rate_Hz, 200.0);
  EXPECT_EQ(back.names, trace.names);
  ASSERT_EQ(back.rows(), 3U);
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(back.columns[c][i]), std::bit_cast<std::uint32_t>(trace.columns[c][i]));
    }
  }
  EXPECT_EQ(back.column("com/x_m").size(), 3U);
  EXPECT_THROW(back.column("com/z_m"), StoreError);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST_F(TraceTest, AnEmptyTraceIsOne) {
  write_trace(file, {100.0, {"t_s"}, {{}}});
  EXPECT_EQ(read_trace(file).rows(), 0U);
}

TEST_F(TraceTest, WhatIsNoTraceOrDamagedIsToldApart) {
  EXPECT_THAT(store_error([&] { read_trace(file); }), HasSubstr("cannot be read"));
  write_trace(file, trace);
  EXPECT_THAT(error_with(0, 'x'), HasSubstr("is not a trace"));
  write_trace(file, trace);
  EXPECT_THAT(error_with(8, 2), HasSubstr("trace of version 2, this program reads version 1"));
  write_trace(file, trace);
  EXPECT_THAT(error_with(read_text(file).size() - 1, 'x'), HasSubstr("damaged"));
  write_trace(file, trace);
  std::filesystem::resize_file(file, read_text(file).size() - 4);
  EXPECT_THAT(store_error([&] { read_trace(file); }), HasSubstr("damaged"));
}

}  // namespace
}  // namespace dob::trace_test
