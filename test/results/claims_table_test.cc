#include "results/claims_table.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/metric_fields.h"
#include "test/results/claim_samples.h"

namespace dob::claims_table_test {
namespace {

using test::key;
using test::run_of;
using test::survived;
using ::testing::HasSubstr;
using ::testing::Not;

ClaimSet two_claims() {
  Claim com;
  com.id = "com";
  com.study = "case 1";
  com.text = "CoM, \"small\"";
  com.paper = "<= 0.01 m";
  com.source = "5.3";
  com.kind = "bound";
  com.cells = {"case1/knee"};
  com.test = BoundClaim{.observer = "momentum", .metric = metric_index("com_error_max_m"), .at_most = 0.01};
  com.observers = {"momentum"};
  com.contrasts = {{.observer = "oracle_legs"}};
  Claim absent = com;
  absent.id = "absent";
  absent.cells = {"case9"};
  return {"momentum", "momentum_com", {com, absent}};
}

std::string render(TableFormat format) {
  const ClaimSet set = two_claims();
  const Run run = run_of({survived(key("case1", "knee", "momentum", "paper", 1), 0.0175),
                          survived(key("case1", "knee", "momentum_com", "paper", 1), 0.003),
                          survived(key("case1", "knee", "oracle_legs", "paper", 1), 0.0173)});
  return render_claims(set, evaluate_claims(set, run), format);
}

TEST(ClaimsTableTest, TextCountsAndNotes) {
  const std::string text = render(TableFormat::kText);
  EXPECT_THAT(text, HasSubstr("Profile paper, gains paper, planner spline: 0 hold, 1 do not, 0 without data"));
  EXPECT_THAT(text, HasSubstr("17.5 mm"));
  EXPECT_THAT(text, HasSubstr("also fails with oracle_legs (17.3 mm)"));
  EXPECT_THAT(text, HasSubstr("Not part of this run"));
}

TEST(ClaimsTableTest, JsonTellsTrueFalseAndNull) {
  const auto json = nlohmann::json::parse(render(TableFormat::kJson));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["holds"], false);
  EXPECT_EQ(json[0]["ours_holds"], true);
  EXPECT_EQ(json[0]["worst"], 0.0175);
  EXPECT_EQ(json[0]["contrasts"][0]["name"], "oracle_legs");
  EXPECT_EQ(json[0]["contrasts"][0]["holds"], false);
  EXPECT_EQ(json[1]["holds"], nullptr);
  EXPECT_EQ(json[1]["worst"], nullptr);
}

TEST(ClaimsTableTest, CsvQuotesAndHasALineForEveryRow) {
  const std::string csv = render(TableFormat::kCsv);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_THAT(csv, HasSubstr("com,case 1,case1/knee,\"CoM, \"\"small\"\"\",bound,5.3,<= 0.01 m,momentum,paper"));
}

TEST(ClaimsTableTest, MarkdownHasAColumnForTheNoteAndLatexHasNot) {
  EXPECT_THAT(render(TableFormat::kMarkdown), HasSubstr("| holds | momentum_com | note |"));
  EXPECT_THAT(render(TableFormat::kMarkdown), HasSubstr("| no | yes: 3 mm |"));
  EXPECT_THAT(render(TableFormat::kLatex), AllOf(HasSubstr("\\toprule"), Not(HasSubstr("& note"))));
}

}  // namespace
}  // namespace dob::claims_table_test
