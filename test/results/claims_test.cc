#include "results/claims.h"

#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/claim_cells.h"
#include "results/metric_fields.h"
#include "scenarios/input_error.h"
#include "scenarios/loader.h"
#include "test/results/claim_samples.h"

namespace dob::claims_test {
namespace {

using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kHead = "subject = \"momentum\"\nours = \"momentum_com\"\n";
const std::string kBound =
    "[[claim]]\nid = \"one\"\ncase = \"case 1\"\ntext = \"CoM\"\npaper = \"<= 10\"\nsource = \"5.3\"\n"
    "cells = [\"case1/*\"]\nkind = \"bound\"\nmetric = \"com_error_max_m\"\nat_most_m = 0.01\n";

class ClaimsTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory directory_;

  ClaimSet load(const std::string& text) const {
    const std::filesystem::path file = directory_.path() / "claims.toml";
    std::filesystem::remove(file);
    test::append_text(file, text);
    return load_claims(file);
  }

  std::string refusal(const std::string& text) const {
    try {
      load(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

std::string with(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST_F(ClaimsTest, PaperClaimsLoadAndCoverEveryCase) {
  const ClaimSet set = load_claims(paper_claims_file());
  std::set<std::string> studies;
  for (const Claim& claim : set.claims) studies.insert(claim.study);
  EXPECT_THAT(studies, ElementsAre("case 1", "case 2", "case 3", "case 4", "case 4, noise", "case 5", "case 6",
                                   "limits", "order study"));
}

TEST_F(ClaimsTest, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(refusal(kHead + kBound), "");
  EXPECT_THAT(refusal(kHead + with(kBound, "\"bound\"", "\"bond\"")),
              AllOf(HasSubstr("claims.toml:10:1: claim.0.kind"), HasSubstr("two_peaks")));
  EXPECT_THAT(refusal(kHead + with(kBound, "com_error_max_m", "com_error_max")),
              AllOf(HasSubstr(":11:1: claim.0.metric"), HasSubstr("com_error_max_m")));
  EXPECT_THAT(refusal(kHead + with(kBound, "at_most_m", "at_most_N")),
              AllOf(HasSubstr(":12:1: claim.0.at_most_N"), HasSubstr("did you mean 'at_most_m'")));
  EXPECT_THAT(refusal(kHead + with(kBound, "at_most_m = 0.01", "")), HasSubstr("claim.0.below_m: missing"));
  EXPECT_THAT(refusal(kHead + kBound + kBound), HasSubstr("claim.1.id"));
  EXPECT_THAT(refusal(kHead + with(kBound, "source", "sauce")), HasSubstr("unknown key 'sauce'"));
  EXPECT_THAT(refusal(with(kHead, "ours", "theirs") + kBound), HasSubstr("unknown key 'theirs'"));
}

TEST_F(ClaimsTest, AMissingIdIsOneWhateverTheOthersHave) {
  const std::string unnamed = with(kBound, "id = \"one\"\n", "");
  EXPECT_THAT(refusal(kHead + unnamed), HasSubstr("claims.toml:3:1: claim.0.id: missing"));
  EXPECT_THAT(refusal(kHead + with(kBound, "\"one\"", "\"\"") + unnamed),
              HasSubstr("claim.0.id: \"\"; allowed: an id"));
}

TEST_F(ClaimsTest, AFewLinesDoNotStandForMoreThanAnybodyWrites) {
  std::string many = "\"0\"";
  for (int i = 1; i < 1001; ++i) many += fmt::format(", \"{}\"", i);
  EXPECT_THAT(refusal(kHead + with(kBound, "\"one\"", "\"$\"\neach = [" + many + "]")),
              HasSubstr("claim: more than 1000"));
  std::string dollars(900, '$');
  std::string cells = "cells = [\"" + dollars + "\"";
  for (int i = 0; i < 99; ++i) cells += ", \"" + dollars + "\"";
  const std::string each = fmt::format("\"$\"\neach = [\"{}\"]", std::string(900, 'x'));
  EXPECT_THAT(refusal(kHead + with(with(kBound, "\"one\"", each), "cells = [\"case1/*\"", cells)),
              HasSubstr("each: its claims take more than"));
  std::string contrasts;
  for (int i = 0; i < 101; ++i) contrasts += "[[contrast]]\ngains = \"stiff\"\n";
  EXPECT_THAT(refusal(kHead + contrasts + kBound),
              HasSubstr("contrast: an array of tables; allowed: at most 100 tables"));
}

TEST_F(ClaimsTest, EachMakesAClaimOfEveryText) {
  const ClaimSet set = load(kHead + with(kBound, "\"one\"", "\"one/$\"\neach = [\"a\", \"b\"]"));
  ASSERT_EQ(set.claims.size(), 2U);
  EXPECT_EQ(set.claims[1].id, "one/b");
}

TEST_F(ClaimsTest, ARowForEverySettingAndOneForWhatIsNotInTheRun) {
  const ClaimSet set = load(kHead + kBound + with(with(kBound, "one", "two"), "case1", "case9"));
  const dob::Run run = run_of({survived(key("case1", "knee", "momentum", "paper", 1), 0.02),
                               survived(key("case1", "tip", "momentum", "paper", 1), 0.03),
                               survived(key("case1", "knee", "momentum", "matched", 1), 0.01),
                               survived(key("case1", "knee", "none", "-", 1), 0.05)});
  const std::vector<ClaimRow> rows = evaluate_claims(set, run);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].setting.profile, "paper");
  EXPECT_EQ(rows[0].finding.verdict, Verdict::kNo);
  EXPECT_EQ(rows[0].finding.measured, "25 (30) mm, worst in case1/tip");
  EXPECT_EQ(rows[1].setting.profile, "matched");
  EXPECT_EQ(rows[1].finding.verdict, Verdict::kYes);
  EXPECT_FALSE(rows[2].planned);
  EXPECT_EQ(rows[2].finding.verdict, Verdict::kNoData);
}

TEST_F(ClaimsTest, OursIsAskedTheSame) {
  const dob::Run run = run_of({survived(key("case1", "knee", "momentum", "paper", 1), 0.02),
                               survived(key("case1", "knee", "momentum_com", "paper", 1), 0.003)});
  const ClaimSet set = load(kHead + kBound);
  const ClaimRow row = evaluate_claims(set, run).at(0);
  ASSERT_TRUE(row.ours.has_value());
  EXPECT_EQ(row.ours->verdict, Verdict::kYes);
  EXPECT_EQ(row.ours->measured, "3 mm");
}

TEST_F(ClaimsTest, MissingRunsLeaveAYesOpenButNotANo) {
  const ClaimSet set = load(kHead + kBound);
  dob::Run run = run_of({survived(key("case1", "knee", "momentum", "paper", 1), 0.002),
                         test::failed(key("case1", "knee", "momentum", "paper", 2), "crashed")});
  EXPECT_EQ(evaluate_claims(set, run).at(0).finding.verdict, Verdict::kNoData);
  EXPECT_THAT(evaluate_claims(set, run).at(0).note, HasSubstr("1 runs are missing"));
  run.cells[0].metrics.com_error_max_m = 0.02;
  EXPECT_EQ(evaluate_claims(set, run).at(0).finding.verdict, Verdict::kNo);
}

TEST_F(ClaimsTest, AnOffsetLacksItsReferenceRunsToo) {
  const std::string offset = with(with(kBound, "\"bound\"\nmetric = \"com_error_max_m\"\nat_most_m = 0.01",
                                       "\"offset\"\nreference = \"case4\"\nshare_at_least = 0.5"),
                                  "case1/*", "case5");
  const auto run_with = [](double offset_Nm, CellResult cell) {
    cell.metrics.estimate_offset_Nm = offset_Nm;
    cell.metrics.joint_estimate_rmse_Nm = 2.5;
    return cell;
  };
  const dob::Run run = run_of({run_with(0.1, survived(key("case4", "", "momentum", "paper", 1), 0.01)),
                               test::failed(key("case4", "", "momentum", "paper", 2), "crashed"),
                               run_with(2.0, survived(key("case5", "", "momentum", "paper", 1), 0.01))});
  const ClaimSet set = load(kHead + offset);
  const ClaimRow row = evaluate_claims(set, run).at(0);
  EXPECT_EQ(row.finding.verdict, Verdict::kNoData);
  EXPECT_THAT(row.note, HasSubstr("1 runs are missing"));
}

TEST_F(ClaimsTest, AnotherDurationLeavesFallsOpen) {
  const std::string kind = "\"bound\"\nmetric = \"com_error_max_m\"\nat_most_m = 0.01";
  const ClaimSet set =
      load(kHead + with(kBound, kind, "\"survive\"") + with(with(kBound, kind, "\"fall\""), "\"one\"", "\"two\"") +
           with(kBound, "\"one\"", "\"three\""));
  const auto verdicts = [&](const std::string& overrides) {
    CellKey shortened = key("case1", "knee", "momentum", "paper", 1);
    shortened.overrides = overrides;
    const dob::Run run = run_of({survived(shortened, 0.003)});
    std::vector<Verdict> all;
    for (const ClaimRow& row : evaluate_claims(set, run)) all.push_back(row.finding.verdict);
    return all;
  };
  const auto open = ElementsAre(Verdict::kNoData, Verdict::kNoData, Verdict::kYes);
  EXPECT_THAT(verdicts("duration_s=5"), open);
  EXPECT_THAT(verdicts("controller.friction=0.4; duration_s=5"), open);
  EXPECT_THAT(verdicts("path.0.duration_s=5"), open);
  EXPECT_THAT(verdicts("controller.friction=0.4; disturbance.0.duration_s=5"),
              ElementsAre(Verdict::kYes, Verdict::kNo, Verdict::kYes));
}

TEST_F(ClaimsTest, NoteOfANoNamesTheContrastsOfTheRunAndOfRecordedOnes) {
  const std::string contrasts =
      "contrast = [{ observer = \"oracle_legs\" }, { profile = \"matched\" }, { gains = \"stiff\" }, { planner = "
      "\"zmp\" }]\n";
  const ClaimSet set = load(kHead + contrasts + kBound);
  const dob::Run run = run_of({survived(key("case1", "knee", "momentum", "paper", 1), 0.0175),
                               survived(key("case1", "knee", "oracle_legs", "paper", 1), 0.0173),
                               survived(key("case1", "knee", "momentum", "matched", 1), 0.0099)});
  CellKey stiff = key("case1", "knee", "momentum", "paper", 1);
  stiff.gains = "stiff";
  const dob::Run recorded =
      run_of({survived(stiff, 0.0096), survived(key("case1", "knee", "oracle_legs", "paper", 1), 0.0)});
  const std::vector<ClaimRow> rows = evaluate_claims(set, run, {recorded});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(
      rows[0].note,
      "also fails with oracle_legs (17.3 mm); holds with profile matched (9.9 mm), gains stiff (9.6 mm, recorded)");
  EXPECT_EQ(rows[1].note, "");  // it holds
}

// What comes of blocks above the step is one sentence of the paper: robots that fall and robots that are held up are
// both a yes, one that walks past them is a no.
TEST(PaperClaims, BlocksAboveTheStepAreOneClaim) {
  const auto verdicts = [](std::vector<CellResult> cells) {
    const ClaimSet set = load_claims(paper_claims_file());
    const dob::Run run = run_of(std::move(cells));
    std::vector<Verdict> all;
    for (const ClaimRow& row : evaluate_claims(set, run)) {
      if (row.planned) all.push_back(row.finding.verdict);
    }
    return all;
  };
  const auto block = [](int seed) { return key("block_height_sweep", "h_06", "momentum", "paper", seed); };
  CellResult held_up = survived(block(1), 0.004), walks = survived(block(2), 0.004);
  held_up.metrics.path_error_max_m = 1.9;
  walks.metrics.path_error_max_m = 0.08;
  const CellResult falls = fell(block(3), 12.0, 0.3);
  EXPECT_THAT(verdicts({held_up, falls}), ElementsAre(Verdict::kYes));
  EXPECT_THAT(verdicts({held_up, falls, walks}), ElementsAre(Verdict::kNo));
}

// A slip of the pen there would read "not part of this run" for ever.
TEST(PaperClaims, NameScenariosAndObserversThatThereAre) {
  std::vector<CellResult> cells;
  for (const ScenarioInfo& info : list_scenarios()) {
    if (info.variants.empty()) cells.push_back(survived(key(info.name, "", "none", "-", 1), 0.01));
    for (const std::string& variant : info.variants)
      cells.push_back(survived(key(info.name, variant, "none", "-", 1), 0.01));
  }
  const dob::Run run = run_of(cells);
  const CellGroups shipped(run);
  const ClaimSet set = load_claims(paper_claims_file());
  for (const Claim& claim : set.claims) {
    for (const std::string& pattern : claim.cells) {
      EXPECT_FALSE(shipped.cases(pattern).empty()) << claim.id << ": " << pattern;
    }
    for (const std::string& observer : claim.observers) EXPECT_NO_THROW(load_observer(observer, "paper")) << claim.id;
  }
}

}  // namespace
}  // namespace dob::claims_test
