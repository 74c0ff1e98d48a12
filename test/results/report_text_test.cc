#include "results/report_text.h"

#include <gtest/gtest.h>

namespace dob::report_text_test {
namespace {

TEST(ReportText, AbsolutePathsBecomeTheirFilesNames) {
  EXPECT_EQ(without_directories("/home/anna/robots/mine.so: cannot be loaded"), "mine.so: cannot be loaded");
  EXPECT_EQ(without_directories("in '/a/b.toml', in \"/c/d\" (/e/f) g=/h/i"), "in 'b.toml', in \"d\" (f) g=i");
  EXPECT_EQ(without_directories("-fdebug-prefix-map=/home/anna=. -O3"), "-fdebug-prefix-map=anna=. -O3");
}

TEST(ReportText, WhatIsNoAbsolutePathStays) {
  for (const char* text : {"case1/knee_lateral", "17.4 / 2.5", "3/20 m/s", "traces/00001.dobtrace: damaged", "", "/"}) {
    EXPECT_EQ(without_directories(text), text);
  }
}

TEST(ReportText, NothingEndsTheScriptElementAndTheTextComesBack) {
  const std::string hostile = "</script><!-- <script>\xE2\x80\xA8\xE2\x80\xA9 \\u003c \"\n";
  const std::string text = script_json({{"name", hostile}, {hostile, 1}});
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.find("\xE2\x80\xA8"), std::string::npos);
  EXPECT_EQ(text.find("\xE2\x80\xA9"), std::string::npos);
  const auto back = nlohmann::json::parse(text);
  EXPECT_EQ(back.at("name"), hostile);
  EXPECT_EQ(back.at(hostile), 1);
}

TEST(ReportText, BytesThatAreNoTextAreReplaced) {
  const std::string text = script_json({{"name",
                                         "a\xFF"
                                         "b"}});
  EXPECT_EQ(nlohmann::json::parse(text).at("name"),
            "a\xEF\xBF\xBD"
            "b");
}

}  // namespace
}  // namespace dob::report_text_test
