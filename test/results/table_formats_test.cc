#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/table.h"
#include "test/results/run_samples.h"

namespace dob::table_formats_test {
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
  observer  profile  rank         falls  CoM max  CoM rms  foot max  onset  GRF err  est. rmse  QP fail
                                            [mm]     [mm]      [mm]   [mm]      [N]        [N]
  none      -           1  1/1 (20.4 s)     250*        -         -      -        -          -       0*
  ! none (-): fell: trunk tilted

case_1 / knee: gains paper, planner spline
  observer  profile  rank  falls      CoM max      CoM rms     foot max  onset      GRF err  est. rmse  QP fail
                                         [mm]         [mm]         [mm]   [mm]          [N]        [N]
  none      -           2    0/1          500            -            -      -            -          -        0
  momentum  paper       1    0/2  27.6 / 36.8  9.18 / 12.2  6.15 / 8.20      -  4.20 / 5.60  185 / 247        0
  ! none (-): 1 of 2 could not be run: cannot open 50% of_it

CoM: distance)"));
}

TEST(TableTextTest, NoLineIsWiderThanTheScreen) {
  dob::Run run = sample();
  run.cells.back().reason =
      "a reason that is rather long because the library that failed explains itself at length "
      "before it comes to its point, which is that the file was not there";
  std::istringstream text(render(run, TableFormat::kText, TableOrder::kByScenario, true));
  for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), 160U) << line;
}

TEST(TableTextTest, TenSeedsFitTheScreenAndSayHowSureTheirFallsAre) {
  std::vector<CellResult> cells;
  for (int seed = 1; seed <= 10; ++seed) {
    cells.push_back(full(key("case4", "", "contact_consistent", "matched", seed), 1.0 + 0.1 * seed));
    cells.back().metrics.foot_error_onset_max_m = 0.0123 * seed;
  }
  cells[3].outcome = cells[7].outcome = Outcome::kFell;
  const std::string text = render(run_of(cells), TableFormat::kText);
  EXPECT_THAT(text, HasSubstr("contact_consistent  matched     1  2/10 (46.0 s)  6-51  28.5 / 36.8"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 160U) << line;
}

TEST(TableTextTest, RunsThatAreMissingAreNamed) {
  dob::Run run = sample();
  run.cells.pop_back();
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("! none (-): 1 of 2 not run yet\n"));
  run.cells.clear();
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("  none      -           -      -        -        -"));
}

TEST(TableTextTest, ObserverOrderPutsTheScenariosInTheRows) {
  EXPECT_THAT(render(sample(), TableFormat::kText, TableOrder::kByObserver),
              StartsWith(
                  R"(none (-): gains paper, planner spline
  scenario     variant  rank         falls  CoM max  CoM rms  foot max  onset  GRF err  est. rmse  QP fail
                                               [mm]     [mm]      [mm]   [mm]      [N]        [N]
  undisturbed              1  1/1 (20.4 s)     250*        -         -      -        -          -       0*
  case_1       knee        2           0/1      500        -         -      -        -          -        0
  ! undisturbed: fell: trunk tilted
  ! case_1 / knee: 1 of 2 could not be run: cannot open 50% of_it

momentum (paper))"));
}

TEST(TableTextTest, OverridesAndGainsMakeBlocksOfTheirOwn) {
  dob::Run run = run_of({survived(key("s", "", "o", "-", 1), 0.001), survived(key("s", "", "o", "-", 1), 0.002)});
  run.cells[1].key.overrides = "sim.dt=0.002";
  run.info.cells = {run.cells[0].key, run.cells[1].key};
  EXPECT_THAT(render(run, TableFormat::kText), HasSubstr("s: gains paper, planner spline, set sim.dt=0.002\n"));
}

TEST(TableTextTest, TimingAddsABlockOfWhatASerialPassMeasured) {
  dob::Run run = run_of({survived(key("s", "", "o", "-", 1), 0.001), survived(key("t", "", "o", "-", 1), 0.001)});
  run.timings = {{run.cells[0].key, 112.0, 187.4, 321.0, 31.2, 44.1, 57.0, 23.25}};
  const std::string text = render(run, TableFormat::kText, TableOrder::kByScenario, true);
  EXPECT_THAT(text, HasSubstr(R"(
time, s: gains paper, planner spline
  observer  profile  tick p50  tick p99  tick max  QP p50  QP p99  QP max     speed
                         [us]      [us]      [us]    [us]    [us]    [us]  [x real]
  o         -             112       187       321    31.2    44.1      57      23.2

)"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("time, t:")));
  EXPECT_THAT(render(run, TableFormat::kText), ::testing::Not(HasSubstr("tick p50")));
}

TEST(TableTextTest, PairedColumnSaysHowMuchBetterOnTheTimeBothStood) {
  CellResult none = fell(key("s", "", "none", "-", 1), 20.4, 0.25);
  CellResult bound = survived(key("s", "", "oracle_full", "-", 1), 0.002);
  none.checkpoints = {test::checkpoint(20.0, 0.0172)};
  bound.checkpoints = {test::checkpoint(20.0, 0.002), test::checkpoint(46.0, 0.002)};
  const std::string text = render(run_of({none, bound}), TableFormat::kText);
  EXPECT_THAT(text, StartsWith(R"(s: gains paper, planner spline
  observer     profile   rank         falls  CoM max  CoM rms  foot max  onset  GRF err  est. rmse  QP fail  paired
                                                [mm]     [mm]      [mm]   [mm]      [N]        [N]             [mm]
  none         -            1  1/1 (20.4 s)     250*        -         -      -        -          -       0*       -
  oracle_full  -        bound           0/1        2        -         -      -        -          -        0   -15.2
)"));
  EXPECT_THAT(text, HasSubstr("paired: CoM max minus that of none@-, run by run"));
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

| observer | profile | rank | falls | CoM max \[mm\] | CoM rms \[mm\] | foot max \[mm\] | onset \[mm\] | GRF err \[N\] | est. rmse \[N\] | QP fail |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| none | - | 1 | 1/1 (20.4 s) | 250\* | - | - | - | - | - | 0\* |

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
\begin{tabular}{llrrrrrrrrr}
\toprule
{}observer & profile & rank & falls & CoM max & CoM rms & foot max & onset & GRF err & est. rmse & QP fail \\
{} &  &  &  & [mm] & [mm] & [mm] & [mm] & [N] & [N] &  \\
\midrule
{}none & - & 2 & 0/1 & 500 & - & - & - & - & - & 0 \\
{}momentum & paper & 1 & 0/2 & 27.6 / 36.8 & 9.18 / 12.2 & 6.15 / 8.20 & - & 4.20 / 5.60 & 185 / 247 & 0 \\
\bottomrule
\end{tabular}
\par\footnotesize none (-): 1 of 2 could not be run: cannot open 50\% of\_it
\end{table}
)"));
}

// What a LaTeX run would complain of, as far as the text shows it: braces, environments, cells per line.
TEST(TableLatexTest, BracesEnvironmentsAndColumnsMatch) {
  dob::Run run = sample();
  for (int seed = 3; seed <= 10; ++seed) {  // so that every column is there
    run.cells.push_back(full(key("case_1", "knee", "momentum", "paper", seed), 1.0));
    run.cells.push_back(full(key("case_1", "knee", "none", "-", seed), 2.0));
    run.cells.back().checkpoints = run.cells.end()[-2].checkpoints = {test::checkpoint(46.0, 0.001 * seed)};
    for (int i : {1, 2}) run.info.cells.push_back(run.cells.end()[-i].key);
  }
  std::istringstream lines(render(run, TableFormat::kLatex));
  int braces = 0, tables = 0;
  std::ptrdiff_t columns = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("%")) continue;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\\') {
        ++i;  // the character behind it is escaped, or begins a command
      } else {
        braces += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
        EXPECT_EQ(std::string("%$#_^~").find(line[i]), std::string::npos) << line;
      }
    }
    EXPECT_EQ(braces, 0) << line;
    if (const std::string begin = "\\begin{tabular}{"; line.starts_with(begin)) {
      columns = static_cast<std::ptrdiff_t>(line.size() - begin.size() - 1);
      ++tables;
    }
    if (line == "\\end{tabular}") columns = 0;
    if (columns > 0 && line.ends_with("\\\\")) {
      EXPECT_EQ(std::count(line.begin(), line.end(), '&'), columns - 1) << line;
    }
  }
  EXPECT_EQ(tables, 2);
  EXPECT_EQ(columns, 0);
}

TEST(TableLatexTest, EscapesEveryCharacterWithAMeaning) {
  const auto run = run_of({survived(key("s", "", "\\&%$#_{}~^<>|", "-", 1), 0.001)});
  EXPECT_THAT(render(run, TableFormat::kLatex),
              HasSubstr("\\textbackslash{}\\&\\%\\$\\#\\_\\{\\}\\textasciitilde{}\\textasciicircum{}\\textless{}"
                        "\\textgreater{}\\textbar{} & - &"));
}

}  // namespace
}  // namespace dob::table_formats_test
