#include "results/campaign_table.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "test/results/campaign_run_samples.h"

namespace dob::campaign_table_test {
namespace {

using nlohmann::json;
using test::add_trials;
using test::SampleCampaign;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::array kFormats{TableFormat::kText, TableFormat::kMarkdown, TableFormat::kCsv, TableFormat::kLatex,
                              TableFormat::kJson};

std::string render(const SampleCampaign& sample, TableFormat format) {
  return render_campaign(sample.result(), format);
}

void add_ladder(SampleCampaign& sample, const CellKey& key, int axis, const std::vector<std::string>& trials) {
  const std::size_t curve = sample.add_curve(key, {axis});
  for (int level = 0; level < static_cast<int>(trials.size()); ++level) {
    add_trials(sample, curve, {level, 0}, trials[static_cast<std::size_t>(level)]);
  }
}

// Sharp steps: none between 60 and 90, momentum between 90 and 120 with a seed that is not monotone, an oracle that
// survives everything.
SampleCampaign limit() {
  SampleCampaign sample =
      test::empty_campaign(CampaignKind::kLimit, {{"amplitude", "N", {30.0, 60.0, 90.0, 120.0, 150.0}}});
  const std::string s(20, 's'), f(20, 'f');
  add_ladder(sample, test::key("case1", "knee", "none", "-", 0), 0, {s, s, f, f, f});
  add_ladder(sample, test::key("case1", "knee", "momentum", "paper", 0), 0, {s, s, "e" + s, f, "s" + f});
  add_ladder(sample, test::key("case1", "knee", "oracle_full", "-", 0), 0, {s, s, s, s, s});
  CellKey set = test::key("case1", "knee", "momentum", "paper", 0);
  set.overrides = "sim.dt=0.002";
  add_ladder(sample, set, 0, {".", ".", ".", ".", "."});
  return sample;
}

SampleCampaign breakdown() {
  SampleCampaign sample = test::empty_campaign(
      CampaignKind::kBreakdown, {{"amplitude", "N", {30.0, 60.0, 90.0}}, {"delay", "s", {0.001, 0.01, 0.1}, true}});
  const std::string s(20, 's'), f(20, 'f');
  add_ladder(sample, test::key("case1", "", "none", "-", 0), 0, {s, f, "."});
  add_ladder(sample, test::key("case1", "", "none", "-", 0), 1, {s, s, s});
  add_ladder(sample, test::key("case1", "", "momentum", "paper", 0), 0, {s, "sse", f});
  add_ladder(sample, test::key("case1", "", "momentum", "paper", 0), 1, {s, f, f});
  return sample;
}

SampleCampaign map() {
  SampleCampaign sample =
      test::empty_campaign(CampaignKind::kMap, {{"amplitude", "N", {30.0, 60.0}}, {"delay", "s", {0.0, 0.005, 0.01}}});
  const std::size_t curve = sample.add_curve(test::key("case1", "knee", "momentum", "paper", 0), {0, 1});
  add_trials(sample, curve, {0, 0}, "ss");
  add_trials(sample, curve, {0, 1}, "s.");
  add_trials(sample, curve, {0, 2}, "sf");
  add_trials(sample, curve, {1, 0}, "ss");
  add_trials(sample, curve, {1, 1}, "fff");
  add_trials(sample, curve, {1, 2}, "e.");
  return sample;
}

SampleCampaign factorial(const std::vector<std::string>& trials) {
  SampleCampaign sample = test::empty_campaign(CampaignKind::kFactorial, {});
  sample.campaign.factors = {"leg estimator", "gains"};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    CellKey key = test::key("case1", "", i < 2 ? "none" : "momentum", "-", 0);
    key.gains = i % 2 == 0 ? "paper" : "stiff";
    add_trials(sample, sample.add_curve(key, {}, {key.observer, key.gains}), {0, 0}, trials[i]);
  }
  return sample;
}

TEST(CampaignTableTest, LimitIsARowForEachCurveInBlocksOfThoseThatCompete) {
  EXPECT_THAT(render(limit(), TableFormat::kText),
              StartsWith(
                  R"(limit push: how hard a push may be: 301 trials of 307 planned cells, 100 fell, 1 could not be run

case1 / knee, amplitude [N]: gains paper, planner spline
  observer     profile   rank  50 % fall          95 %  5 % fall          95 %  trials  falls  errors  seeds  not monotone
                                     [N]           [N]       [N]           [N]
  none         -            2         75  [66.8, 83.2]      65.8  [56.9, 75.4]     100     60       0     20             0
  momentum     paper        1        105   [96.7, 113]      95.7   [86.5, 105]     101     40       1     21             1
  oracle_full  -        bound      > 150         > 150     > 150  [145, > 150]     100      0       0     20             0
  ! momentum (paper): 1 could not be run
  ! momentum (paper): not monotone [N]: seed 1 fell at 120, survived 150

case1 / knee, amplitude [N]: gains paper, planner spline, set sim.dt=0.002
  observer  profile  rank  50 % fall  95 %  5 % fall  95 %  trials  falls  errors  seeds  not monotone
                                 [N]   [N]       [N]   [N]
  momentum  paper       -          -     -         -     -       0      0       0      0             0

50 % fall, 5 % fall: level)"));
}

TEST(CampaignTableTest, BreakdownHasAColumnForEachLevel) {
  EXPECT_THAT(
      render(breakdown(), TableFormat::kText),
      StartsWith(
          R"(breakdown push: how hard a push may be: 202 trials of 204 planned cells, 80 fell, 1 could not be run

case1, amplitude [N]: gains paper, planner spline
  observer  profile  rank  50 % fall          95 %        30      60     90
                                 [N]           [N]       [N]     [N]    [N]
  none      -           2         45  [35.1, 54.9]  0/20 105   20/20      -
  momentum  paper       1       71.2  [58.5, 84.2]  0/20 105  0/2 15  20/20
  ! momentum (paper): 1 could not be run

case1, delay [s]: gains paper, planner spline
  observer  profile  rank  50 % fall                95 %     0.001      0.01       0.1
                                 [s]                 [s]       [s]       [s]       [s]
  none      -           1      > 0.1               > 0.1  0/20 105  0/20 105  0/20 105
  momentum  paper       2    0.00317  [0.00148, 0.00675]  0/20 105     20/20     20/20

50 % fall, 5 % fall: level)"));
}

TEST(CampaignTableTest, MapIsAGridForEachCurve) {
  EXPECT_EQ(render(map(), TableFormat::kText),
            R"(map push: how hard a push may be: 10 trials of 13 planned cells, 4 fell, 1 could not be run

case1 / knee: momentum (paper): gains paper, planner spline: falls/trials, amplitude [N] down, delay [s] across
  amplitude    0  0.005  0.01
        [N]  [s]    [s]   [s]
         30  0/2    0/1   1/2
         60  0/2    3/3     -
  ! 1 could not be run

k/n: k of n trials fell. -: no trial.
)");
}

TEST(CampaignTableTest, FactorialIsABlockForEachResponse) {
  EXPECT_THAT(render(factorial({"ff", "ff", "sf", "se"}), TableFormat::kText),
              StartsWith(
                  R"(factorial push: how hard a push may be: 7 trials of 8 planned cells, 5 fell, 1 could not be run

Share of the variance of falls: 4 trials, 4 cells left out
  factor                 levels  share  95 %
                                   [%]   [%]
  leg estimator               2  100.0     -
  gains                       2    0.0     -
  leg estimator x gains       4    0.0     -
  residual                    -    0.0     -

Share of the variance of log CoM error: 4 trials, 4 cells left out
)"));
}

TEST(CampaignTableTest, FactorialSaysWhyThereIsNothingToShare) {
  EXPECT_THAT(render(factorial({"ss", "ss", "ss", "ss"}), TableFormat::kText), HasSubstr("  ! no trial differs\n"));
  EXPECT_THAT(render(factorial({".", ".", ".", "."}), TableFormat::kText),
              HasSubstr("  ! no complete part of the design has been run\n"));
}

TEST(CampaignTableTest, EightSeedsHaveAnIntervalOfTheirShares) {
  const std::string text = render(factorial({"ssssffff", "ssssffff", "ssssssss", "ssssssss"}), TableFormat::kText);
  EXPECT_THAT(text, ::testing::ContainsRegex("leg estimator  +2 +33.3 +\\[[0-9.]+, [0-9.]+\\]\n"));
}

TEST(CampaignTableTest, SidesOfADescendingLadderAreThoseOfTheNumbers) {
  SampleCampaign sample = test::empty_campaign(CampaignKind::kLimit, {{"friction", "", {0.8, 0.5, 0.2}}});
  const std::string s(20, 's'), f(20, 'f');
  add_ladder(sample, test::key("s", "", "a", "-", 0), 0, {f, f, f});
  add_ladder(sample, test::key("s", "", "b", "-", 0), 0, {s, s, s});
  add_ladder(sample, test::key("s", "", "c", "-", 0), 0, {s, s, s});
  add_ladder(sample, test::key("s", "", "d", "-", 0), 0, {s, f, f});
  const std::string markdown = render(sample, TableFormat::kMarkdown);
  EXPECT_THAT(markdown, HasSubstr("### s, friction: gains"));
  EXPECT_THAT(markdown, HasSubstr("| observer | profile | rank | 50 % fall | 95 % | 5 % fall |"));
  EXPECT_THAT(markdown, HasSubstr("| a | - | 4 | > 0.8 | "));
  EXPECT_THAT(markdown, HasSubstr("| b | - | 1 | \\< 0.2 | "));
  EXPECT_THAT(markdown, HasSubstr("| c | - | 1 | \\< 0.2 | "));  // equals share a rank
  EXPECT_THAT(markdown, HasSubstr("| d | - | 3 | 0.65 | "));
}

TEST(CampaignTableTest, MarkdownIsATablePerBlockBelowItsHeading) {
  const std::string markdown = render(limit(), TableFormat::kMarkdown);
  EXPECT_THAT(markdown, StartsWith("limit push: how hard a push may be: 301 trials of 307 planned cells, 100 fell, 1 "
                                   "could not be run\n\n### case1 / knee, amplitude \\[N\\]: gains paper"));
  EXPECT_THAT(
      markdown,
      HasSubstr("| none | - | 2 | 75 | \\[66.8, 83.2\\] | 65.8 | \\[56.9, 75.4\\] | 100 | 60 | 0 | 20 | 0 |\n"));
  EXPECT_THAT(markdown, HasSubstr("- momentum (paper): not monotone \\[N\\]: seed 1 fell at 120, survived 150\n"));
  EXPECT_THAT(render(map(), TableFormat::kMarkdown),
              HasSubstr(R"(| amplitude \[N\] | 0 \[s\] | 0.005 \[s\] | 0.01 \[s\] |
| ---: | ---: | ---: | ---: |
| 30 | 0/2 | 0/1 | 1/2 |
| 60 | 0/2 | 3/3 | - |

- 1 could not be run
)"));
}

TEST(CampaignTableTest, LatexIsABooktabsTablePerBlock) {
  SampleCampaign sample = limit();
  sample.campaign.summary = "100 % of_it";
  const std::string latex = render(sample, TableFormat::kLatex);
  EXPECT_THAT(latex, StartsWith("\\par\\noindent limit push: 100 \\% of\\_it: 301 trials of 307"));
  EXPECT_THAT(
      latex,
      HasSubstr(
          "\\caption{case1 / knee, amplitude [N]: gains paper, planner spline}\n\\begin{tabular}{llrrrrrrrrrr}\n"));
  EXPECT_THAT(latex, HasSubstr("{}oracle\\_full & - & bound & \\textgreater{} 150 & \\textgreater{} 150 & "));
}

TEST(CampaignTableTest, JsonNestsTheLevelsInTheirCurves) {
  const json table = json::parse(render(limit(), TableFormat::kJson));
  EXPECT_EQ(table["kind"], "limit");
  EXPECT_EQ(table["name"], "push");
  EXPECT_EQ(table["planned"], 307);
  EXPECT_EQ(table["axes"][0]["levels"], json::array({30.0, 60.0, 90.0, 120.0, 150.0}));
  EXPECT_EQ(table["factorial"], json::array());
  ASSERT_EQ(table["curves"].size(), 4U);
  const json& momentum = table["curves"][1];
  EXPECT_EQ(momentum["observer"], "momentum");
  EXPECT_EQ(momentum["rank"], 1);
  EXPECT_EQ(momentum["curve_trials"], 101);
  EXPECT_EQ(momentum["curve_errors"], 1);
  EXPECT_EQ(momentum["half_above"], false);
  EXPECT_GT(momentum["half_level_ci95"][0], 90.0);
  EXPECT_EQ(momentum["non_monotone"], json::parse(R"([{"seed": 1, "fell_at": 120.0, "survived_at": 150.0}])"));
  ASSERT_EQ(momentum["levels"].size(), 5U);
  EXPECT_EQ(momentum["levels"][2]["level"], 90.0);
  EXPECT_EQ(momentum["levels"][2]["planned"], 21);
  EXPECT_EQ(momentum["levels"][2]["errors"], 1);
  EXPECT_EQ(momentum["levels"][3]["falls"], 20);
  EXPECT_EQ(momentum["levels"][3]["com_error_max_m"], nullptr);
  EXPECT_EQ(table["curves"][2]["rank"], nullptr);
  EXPECT_EQ(table["curves"][2]["half_above"], true);
  EXPECT_EQ(table["curves"][3]["half_level"], nullptr);
}

TEST(CampaignTableTest, JsonHasTheSharesOfAFactorialCampaignInFull) {
  const json table = json::parse(render(factorial({"fff", "fff", "sss", "ssf"}), TableFormat::kJson));
  EXPECT_EQ(table["factors"], json::array({"leg estimator", "gains"}));
  EXPECT_EQ(table["curves"][2]["factor_leg_estimator"], "momentum");
  EXPECT_EQ(table["curves"][2]["factor_gains"], "paper");
  ASSERT_EQ(table["factorial"].size(), 2U);
  const json& falls = table["factorial"][0];
  EXPECT_EQ(falls["response"], "falls");
  EXPECT_EQ(falls["trials"], 12);
  EXPECT_EQ(falls["left_out"], 0);
  // 7 of 12 fell: total 12 (7/12) (5/12) = 35/12; by the leg estimator 6 of 6 and 1 of 6: 3 (5/6)^2 = 25/12.
  EXPECT_EQ(falls["shares"][0]["factor"], "leg estimator");
  EXPECT_NEAR(falls["shares"][0]["share"], 25.0 / 35.0, 1e-12);
  EXPECT_EQ(falls["shares"][0]["share_ci95"], nullptr);
  EXPECT_EQ(falls["shares"].back()["factor"], "residual");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(CampaignTableTest, CsvIsALineForEachCurveAndLevel) {
  const std::vector<std::string> lines = lines_of(render(map(), TableFormat::kCsv));
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0],
            "scenario,variant,observer,profile,gains,planner,overrides,axis,unit,axis_2,unit_2,curve_seeds,"
            "curve_trials,curve_falls,curve_errors,rank,half_level,half_level_ci95_low,half_level_ci95_high,half_below,"
            "half_above,twentieth_level,twentieth_level_ci95_low,twentieth_level_ci95_high,twentieth_below,"
            "twentieth_above,non_monotone_seeds,level,level_2,planned,trials,falls,falls_ci95_low,falls_ci95_high,"
            "errors,com_error_max_m,com_error_max_m_ci95_low,com_error_max_m_ci95_high,foot_error_max_m,"
            "foot_error_max_m_ci95_low,foot_error_max_m_ci95_high");
  EXPECT_EQ(lines[3],
            "case1,knee,momentum,paper,paper,spline,,amplitude,N,delay,s,3,10,4,1,,,,,,,,,,,,0,30.0,0.01,2,2,1,,,0,"
            "0.01,,,,,");
  EXPECT_EQ(lines[6],
            "case1,knee,momentum,paper,paper,spline,,amplitude,N,delay,s,3,10,4,1,,,,,,,,,,,,0,60.0,0.01,2,0,0,,,1,"
            ",,,,,");
}

TEST(CampaignTableTest, CsvLinesHaveAsManyFieldsAsTheHeading) {
  for (const auto& sample : {limit(), breakdown(), map(), factorial({"ff", "ff", "ss", "ss"})}) {
    const std::vector<std::string> lines = lines_of(render(sample, TableFormat::kCsv));
    for (const std::string& line : lines) {
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(lines[0].begin(), lines[0].end(), ',')) << line;
    }
  }
}

TEST(CampaignTableTest, IsTheSameBytesWhateverTheOrderInWhichCellsEnded) {
  for (const auto& sample :
       {limit(), breakdown(), map(), factorial({"ffssffss", "ffffffff", "ssssssss", "ssssssee"})}) {
    for (const auto format : kFormats) EXPECT_EQ(render(test::reversed(sample), format), render(sample, format));
  }
}

TEST(CampaignTableTest, CampaignWithoutCurvesIsItsHeading) {
  const SampleCampaign sample = test::empty_campaign(CampaignKind::kLimit, {});
  EXPECT_THAT(render(sample, TableFormat::kText),
              StartsWith("limit push: how hard a push may be: 0 trials of 0 planned"));
  EXPECT_EQ(json::parse(render(sample, TableFormat::kJson))["curves"], json::array());
  EXPECT_EQ(lines_of(render(sample, TableFormat::kCsv)).size(), 1U);
}

TEST(CampaignTableTest, NamesCannotBreakLines) {
  SampleCampaign sample = test::empty_campaign(CampaignKind::kLimit, {});
  sample.campaign.summary = "first\nsecond\x1b[31m";
  EXPECT_THAT(render(sample, TableFormat::kText), StartsWith("limit push: first second [31m: 0 trials"));
}

}  // namespace
}  // namespace dob::campaign_table_test
