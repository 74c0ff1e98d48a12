#include "bench/gnuplot_process.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/signals.h"
#include "results/figure_gnuplot.h"
#include "results/figures.h"
#include "results/whole_file.h"
#include "test/results/run_samples.h"

namespace dob::gnuplot_process_test {
namespace {

using ::testing::HasSubstr;

std::string message_of(const std::filesystem::path& dir, const std::string& script) {
  try {
    run_gnuplot(dir, script);
  } catch (const GnuplotError& error) {
    return error.what();
  }
  return "";
}

TEST(Gnuplot, AScriptThatIsWrongIsAnErrorWithItsName) {
  const test::TemporaryDirectory temporary;
  write_whole_file(temporary.path() / "bad.gp", "nonsense\n");
  EXPECT_THAT(message_of(temporary.path(), "bad.gp"), HasSubstr("bad.gp"));
  EXPECT_THAT(message_of(temporary.path(), "missing.gp"), HasSubstr("missing.gp"));
}

// Whatever a name says, it is drawn, and nothing else happens.
TEST(Gnuplot, DrawsHostileNamesAsTheyAre) {
  const test::TemporaryDirectory temporary;
  Figure figure;
  figure.id = "f";
  figure.subtitle = "it's `touch broken` $(touch broken) \"x\" \\n";
  figure.panels.emplace_back();
  FigurePanel& panel = figure.panels[0];
  panel.title = "'; system('touch broken'); '";
  panel.x_range = panel.y_range = {0.0, 1.0};
  FigureLine line;
  line.label = "a_b@c^{d} & <e>\nsystem 'touch broken'";
  line.x = line.y = {0.0, 1.0};
  panel.lines = {line};
  const GnuplotFiles files = gnuplot_files(figure, FigureFormat::kSvg);
  write_whole_file(temporary.path() / "f.gp", files.script);
  write_whole_file(temporary.path() / "f.dat", files.data);
  EXPECT_EQ(message_of(temporary.path(), "f.gp"), "");
  EXPECT_FALSE(std::filesystem::exists(temporary.path() / "broken"));
  const std::string svg = test::read_text(temporary.path() / "f.svg");
  EXPECT_THAT(svg, HasSubstr("it's `touch broken` $(touch broken)"));
  EXPECT_THAT(svg, HasSubstr("'; system('touch broken'); '"));
  EXPECT_THAT(svg, HasSubstr("a_b@c^{d} &amp; &lt;e> system"));
}

TEST(ShippedFigures, ReferToSignalsThatATraceHas) {
  std::set<std::string> names;
  for (const Signal& signal : tick_signals()) names.insert(signal.name);
  const FigureSet set = load_figures(paper_figures_file());
  int asked = 0;
  for (const FigureSpec& figure : set.figures) {
    for (const FigurePanelSpec& panel : figure.panels) {
      const FigureQuantity& q = set.quantity(panel.quantity);
      std::vector<std::string> signals{"disturbance_active"};
      for (const auto* list : {&q.signals, &q.minus, &q.truth})
        signals.insert(signals.end(), list->begin(), list->end());
      if (!q.while_signal.empty()) signals.push_back(q.while_signal);
      if (!panel.leg.empty()) signals.emplace_back("$/stance");
      for (const std::string& signal : signals) {
        EXPECT_TRUE(names.contains(with_leg(signal, panel.leg))) << figure.id << ": " << signal;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 100);
}

}  // namespace
}  // namespace dob::gnuplot_process_test
