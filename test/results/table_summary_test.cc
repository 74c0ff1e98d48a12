#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/table.h"
#include "test/results/run_samples.h"

namespace dob::table_summary_test {
namespace {

using test::failed;
using test::fell;
using test::key;
using test::run_of;
using test::survived;
using ::testing::HasSubstr;
using ::testing::Not;

CellResult walked(CellKey k, double com, double foot) {
  CellResult cell = survived(std::move(k), com);
  cell.metrics.foot_error_max_m = foot;
  return cell;
}

// Two scenarios, the first with two variants; the oracle first, so that its place is not that of the run.
dob::Run batch() {
  std::vector<CellResult> cells;
  const auto add = [&](const char* observer, double scale) {
    cells.push_back(walked(key("case1", "knee", observer, "paper", 1), 0.010 * scale, 0.004 * scale));
    cells.push_back(walked(key("case1", "tip", observer, "paper", 1), 0.012 * scale, 0.003 * scale));
    cells.push_back(walked(key("case4", "", observer, "paper", 1), 0.020 * scale, 0.040 * scale));
  };
  add("oracle_full", 0.5);
  add("none", 4.0);
  add("momentum", 2.0);
  add("momentum_com", 1.0);
  cells[4] = fell(key("case1", "tip", "none", "paper", 1), 9.0, 0.9);
  return run_of(cells);
}

std::string summary_of(const dob::Run& run, TableFormat format = TableFormat::kText) {
  const std::string text = render_table(run, {.format = format});
  const std::size_t begin = text.find("summary: ");
  return begin == std::string::npos ? "" : text.substr(begin, text.find("\n\n", text.find("oracle", begin)) - begin);
}

TEST(TableSummaryTest, IsOneLinePerObserverTheBestFirstAndBoundsBelowARule) {
  EXPECT_EQ(summary_of(batch()), R"(summary: gains paper, planner spline
  observer      profile   rank  falls        case1     case4
                                              [mm]      [mm]
  momentum_com  paper      1.0    0/3       12 / 4   20 / 40
  momentum      paper      2.0    0/3       24 / 8   40 / 80
  none          paper      3.0    1/3  1/2 40 / 16  80 / 160
  ----------------------------------------------------------
  oracle_full   paper    bound    0/3        6 / 2   10 / 20)");
}

TEST(TableSummaryTest, FiguresAreThoseOfTheWorstVariantThatWasSurvived) {
  dob::Run run = batch();
  run.cells[9].metrics.com_error_max_m = 0.0345;  // momentum_com, knee
  EXPECT_THAT(summary_of(run), HasSubstr("34.5 / 4 "));
}

TEST(TableSummaryTest, FallsComeBeforeRanksAndRunsThatCouldNotBeRunAreLostToo) {
  dob::Run run = batch();
  run.cells[9] = failed(run.cells[9].key, "crashed");
  run.cells[10] = failed(run.cells[10].key, "crashed");
  run.cells[11] = failed(run.cells[11].key, "crashed");
  const std::string summary = summary_of(run);
  EXPECT_LT(summary.find("momentum "), summary.find("none "));
  EXPECT_LT(summary.find("none "), summary.find("momentum_com"));
  EXPECT_THAT(summary, HasSubstr("0/0"));
}

TEST(TableSummaryTest, EachSetOfGainsHasItsOwn) {
  dob::Run run = batch();
  const dob::Run stiff = batch();
  for (CellResult cell : stiff.cells) {
    cell.key.gains = "stiff";
    run.info.cells.push_back(cell.key);
    run.cells.push_back(cell);
  }
  const std::string text = render_table(run, {});
  EXPECT_THAT(text, HasSubstr("summary: gains paper, planner spline\n"));
  EXPECT_THAT(text, HasSubstr("summary: gains stiff, planner spline\n"));
}

TEST(TableSummaryTest, NeedsTwoScenariosAndTwoObservers) {
  const CellResult a = survived(key("s", "", "a", "-", 1), 0.01), b = survived(key("s", "", "b", "-", 1), 0.01);
  const CellResult c = survived(key("t", "", "a", "-", 1), 0.01), d = survived(key("t", "", "b", "-", 1), 0.01);
  EXPECT_THAT(render_table(run_of({a, b}), {}), Not(HasSubstr("summary")));
  EXPECT_THAT(render_table(run_of({a, c}), {}), Not(HasSubstr("summary")));
  EXPECT_THAT(render_table(run_of({a, b, c, d}), {}), HasSubstr("summary: "));
}

// As the order study: it brings its own observers, and only one of the others.
TEST(TableSummaryTest, LeavesOutObserversOfOneScenarioAndScenariosOfOneObserver) {
  dob::Run run = batch();
  const std::string before = summary_of(run);
  std::vector<CellResult> cells = run.cells;
  for (const char* observer : {"none", "order_1", "order_2"}) {
    cells.push_back(walked(key("study", "", observer, "paper", 1), 0.010, 0.004));
  }
  EXPECT_EQ(summary_of(run_of(cells)), before);
}

TEST(TableSummaryTest, StandsInMarkdownAndNotWhereProgramsRead) {
  EXPECT_THAT(render_table(batch(), {.format = TableFormat::kMarkdown}),
              HasSubstr("| momentum\\_com | paper | 1.0 | 0/3 |"));
  for (const auto format : {TableFormat::kCsv, TableFormat::kJson}) {
    EXPECT_THAT(render_table(batch(), {.format = format}), Not(HasSubstr("summary")));
  }
}

TEST(TableSummaryTest, ScenariosThatDoNotFitSideBySideGoBelow) {
  std::vector<CellResult> cells;
  for (int i = 0; i < 24; ++i) {
    for (const char* observer : {"momentum", "none"}) {
      cells.push_back(walked(key("scenario_" + std::to_string(100 + i), "", observer, "paper", 1), 0.0123, 0.0123));
    }
  }
  const std::string text = render_table(run_of(cells), {});
  const std::string summary = text.substr(text.find("summary: "));
  std::istringstream lines(summary);
  int panels = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 160U);
    panels += line.starts_with("  observer  profile  rank  falls") ? 1 : 0;
  }
  EXPECT_EQ(panels, 3);
  for (int i = 0; i < 24; ++i) {
    const std::string name = "scenario_" + std::to_string(100 + i);
    EXPECT_EQ(summary.find(name), summary.rfind(name)) << name;
    EXPECT_NE(summary.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace dob::table_summary_test
