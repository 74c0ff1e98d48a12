#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/table.h"
#include "test/results/run_samples.h"

namespace dob {
namespace {

using test::failed;
using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::HasSubstr;
using ::testing::StartsWith;

CellResult full(CellKey k, double scale) {
  CellResult cell = survived(std::move(k), 0.0184 * scale);
  cell.metrics.com_error_rms_m = 0.00612 * scale;
  cell.metrics.foot_error_max_m = 0.0041 * scale;
  cell.metrics.grf_error_mean_N = 2.8 * scale;
  cell.metrics.estimate_rmse_N = 123.4 * scale;
  return cell;
}

// One seed, one fall; two seeds, one error.
Run sample() {
  return run_of({fell(key("undisturbed", "", "none", "-", 1), 20.44, 0.25),
                 full(key("case_1", "knee", "momentum", "paper", 1), 1.0),
                 full(key("case_1", "knee", "momentum", "paper", 2), 2.0),
                 survived(key("case_1", "knee", "none", "-", 1), 0.5),
                 failed(key("case_1", "knee", "none", "-", 2), "cannot open 50% of_it")});
}

std::string render(const Run& run, TableFormat format, TableOrder order = TableOrder::kByScenario,
                   bool timing = false) {
  return render_table(run, {format, order, timing});
}

TEST(TableTextTest, BlocksAreAlignedWithNotesBelow) {
  EXPECT_THAT(render(sample(), TableFormat::kText), StartsWith(
                                                        R"(undisturbed: gains paper, planner spline
  observer  profile         falls  CoM max  CoM rms  foot max  onset  GRF err  est. rmse  QP fail
                                      [mm]     [mm]      [mm]   [mm]      [N]        [N]
  none      -        1/1 (20.4 s)     250*        -         -      -        -          -       0*
  ! none (-): fell: trunk tilted

case_1 / knee: gains paper, planner spline
  observer  profile  falls      CoM max      CoM rms     foot max  onset      GRF err  est. rmse  QP fail
                                   [mm]         [mm]         [mm]   [mm]          [N]        [N]
  none      -          0/1    500 (500)            -            -      -            -          -    0 (0)
  momentum  paper      0/2  27.6 (36.8)  9.18 (12.2)  6.15 (8.20)      -  4.20 (5.60)  185 (247)    0 (0)
  ! none (-): 1 of 2 could not be run: cannot open 50% of_it

CoM: distance)"));
}

TEST(TableTextTest, NoLineIsWiderThanTheScreen) {
  dob::Run run = sample();
  run.cells.back().reason =
      "a reason that is rather long because the library that failed explains itself at length "
      "before it comes to its point, which is that the file was not there";
  std::istringstream text(render(run, TableFormat::kText, TableOrder::kByScenario, true));
  for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), 120U) << line;
}

TEST(TableTextTest, ColumnsCloseUpWhenNamesAreLong) {
  std::vector<CellResult> cells;
  for (int seed = 1; seed <= 10; ++seed) {
    cells.push_back(full(key("case4", "", "contact_consistent", "matched", seed), 1.0 + 0.1 * seed));
    cells.back().metrics.foot_error_onset_max_m = 0.0123 * seed;
  }
  cells[3].outcome = cells[7].outcome = Outcome::kFell;
  const std::string text = render(run_of(cells), TableFormat::kText);
  EXPECT_THAT(text, HasSubstr("contact_consistent matched 2/10 (46.0 s) 28.5 (36.8)"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120U) << line;
}

TEST(TableTextTest, RunsThatAreMissingAreNamed) {
  dob::Run run = sample();
  run.cells.pop_back();
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("! none (-): 1 of 2 not run yet\n"));
  run.cells.clear();
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("  none      -            -        -        -"));
}

TEST(TableTextTest, ObserverOrderPutsTheScenariosInTheRows) {
  EXPECT_THAT(render(sample(), TableFormat::kText, TableOrder::kByObserver),
              StartsWith(
                  R"(none (-): gains paper, planner spline
  scenario     variant         falls    CoM max  CoM rms  foot max  onset  GRF err  est. rmse  QP fail
                                           [mm]     [mm]      [mm]   [mm]      [N]        [N]
  undisturbed           1/1 (20.4 s)       250*        -         -      -        -          -       0*
  case_1       knee              0/1  500 (500)        -         -      -        -          -    0 (0)
  ! undisturbed: fell: trunk tilted
  ! case_1 / knee: 1 of 2 could not be run: cannot open 50% of_it

momentum (paper))"));
}

TEST(TableTextTest, OverridesAndGainsMakeBlocksOfTheirOwn) {
  dob::Run run = run_of({survived(key("s", "", "o", "-", 1), 0.001), survived(key("s", "", "o", "-", 1), 0.002)});
  run.info.cells[1].overrides = run.cells[1].key.overrides = "sim.dt=0.002";
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("s: gains paper, planner spline, set sim.dt=0.002\n"));
}

TEST(TableTextTest, TimingAddsTheRealTimeFactor) {
  CellResult cell = survived(key("s", "", "o", "-", 1), 0.001);
  cell.wall_s = 2.0;
  const std::string text = render(run_of({cell}), TableFormat::kText, TableOrder::kByScenario, true);
  EXPECT_THAT(text, HasSubstr("QP fail     speed\n"));
  EXPECT_THAT(text, HasSubstr("        0        23\n"));
  EXPECT_THAT(render(run_of({cell}), TableFormat::kText), ::testing::Not(HasSubstr("speed")));
}

TEST(TableTextTest, DoesNotDependOnTheOrderInWhichCellsEnded) {
  dob::Run reversed = sample();
  std::reverse(reversed.cells.begin(), reversed.cells.end());
  for (const auto format :
       {TableFormat::kText, TableFormat::kMarkdown, TableFormat::kCsv, TableFormat::kLatex, TableFormat::kJson}) {
    EXPECT_EQ(render(reversed, format), render(sample(), format));
  }
}

TEST(TableTextTest, ReasonsCannotBreakLines) {
  const auto run = run_of({failed(key("s", "", "o", "-", 1), "first\nsecond\x1b[31m")});
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("could not be run: first second [31m\n"));
}

TEST(TableMarkdownTest, IsATablePerBlock) {
  EXPECT_THAT(render(sample(), TableFormat::kMarkdown), StartsWith(
                                                            R"(### undisturbed: gains paper, planner spline

| observer | profile | falls | CoM max \[mm\] | CoM rms \[mm\] | foot max \[mm\] | onset \[mm\] | GRF err \[N\] | est. rmse \[N\] | QP fail |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| none | - | 1/1 (20.4 s) | 250\* | - | - | - | - | - | 0\* |

- none (-): fell: trunk tilted

### case\_1 / knee: gains paper, planner spline
)"));
}

TEST(TableMarkdownTest, EscapesWhatWouldEndACell) {
  const auto run = run_of({survived(key("s", "", "a|b", "-", 1), 0.001)});
  EXPECT_THAT(render(run, TableFormat::kMarkdown), HasSubstr("| a\\|b | - |"));
}

TEST(TableLatexTest, IsABooktabsTablePerBlock) {
  EXPECT_THAT(render(sample(), TableFormat::kLatex), HasSubstr(
                                                         R"(\begin{table}
\centering
\caption{case\_1 / knee: gains paper, planner spline}
\begin{tabular}{llrrrrrrrr}
\toprule
observer & profile & falls & CoM max & CoM rms & foot max & onset & GRF err & est. rmse & QP fail \\
 &  &  & [mm] & [mm] & [mm] & [mm] & [N] & [N] &  \\
\midrule
none & - & 0/1 & 500 (500) & - & - & - & - & - & 0 (0) \\
momentum & paper & 0/2 & 27.6 (36.8) & 9.18 (12.2) & 6.15 (8.20) & - & 4.20 (5.60) & 185 (247) & 0 (0) \\
\bottomrule
\end{tabular}
\par\footnotesize none (-): 1 of 2 could not be run: cannot open 50\% of\_it
\end{table}
)"));
}

TEST(TableLatexTest, EscapesEveryCharacterWithAMeaning) {
  const auto run = run_of({survived(key("s", "", "\\&%$#_{}~^<>|", "-", 1), 0.001)});
  EXPECT_THAT(render(run, TableFormat::kLatex),
              HasSubstr("\\textbackslash{}\\&\\%\\$\\#\\_\\{\\}\\textasciitilde{}\\textasciicircum{}\\textless{}"
                        "\\textgreater{}\\textbar{} & - &"));
}

}  // namespace
}  // namespace dob
