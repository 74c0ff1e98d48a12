#include "results/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/run_samples.h"

namespace dob::report_page_test {
namespace {

namespace fs = std::filesystem;
using test::append_text;
using test::store_error;
using ::testing::HasSubstr;

class ReportPage : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  fs::path file = temporary.path() / "template.html";
};

TEST_F(ReportPage, TheDataStandInTheMarkersPlace) {
  append_text(file, "<!doctype html>\n<!--REPORT-DATA-->\n<p>end\n");
  EXPECT_EQ(PageTemplate(file).with({{"a", 1}}, {"QUJD", "REVG"}),
            "<!doctype html>\n"
            "<script type=\"application/json\" id=\"report-data\">{\"a\":1}</script>\n"
            "<script type=\"text/plain\" id=\"trace-0\">QUJD</script>\n"
            "<script type=\"text/plain\" id=\"trace-1\">REVG</script>\n"
            "<p>end\n");
}

TEST_F(ReportPage, ATemplateHasTheMarkerOnce) {
  EXPECT_THAT(store_error([&] { PageTemplate{file}; }),
              HasSubstr("template.html: the report's template cannot be read"));
  append_text(file, "<!doctype html>\n");
  EXPECT_THAT(store_error([&] { PageTemplate{file}; }), HasSubstr("<!--REPORT-DATA--> must be there once"));
  append_text(file, "<!--REPORT-DATA-->\n<!--REPORT-DATA-->\n");
  EXPECT_THAT(store_error([&] { PageTemplate{file}; }), HasSubstr("<!--REPORT-DATA--> must be there once"));
}

}  // namespace
}  // namespace dob::report_page_test
