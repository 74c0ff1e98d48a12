#include "results/figure_spec.h"

#include <map>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/input_error.h"
#include "test/results/run_samples.h"

namespace dob::figure_spec_test {
namespace {

using ::testing::HasSubstr;

TEST(ShippedFigures, AreAllOfThePaper) {
  std::map<std::string, int> drawn;
  for (const FigureSpec& figure : load_figures(paper_figures_file()).figures) ++drawn[figure.paper];
  for (int number = 1; number <= 20; ++number) EXPECT_EQ(drawn[std::to_string(number)], 1) << number;
}

TEST(ShippedFigures, HaveACaptionAndWhatTheyShow) {
  for (const FigureSpec& figure : load_figures(paper_figures_file()).figures) {
    EXPECT_FALSE(figure.caption.empty()) << figure.id;
    for (const FigurePanelSpec& panel : figure.panels) {
      EXPECT_FALSE(panel.cells.empty() && figure.cells.empty()) << figure.id;
      EXPECT_FALSE(panel.observers.empty() && figure.observers.empty()) << figure.id;
    }
  }
}

TEST(WithLeg, ReplacesEveryDollar) {
  EXPECT_EQ(with_leg("$/foot of $", "LF"), "LF/foot of LF");
  EXPECT_EQ(with_leg("com", "LF"), "com");
}

TEST(BlockDiagram, NamesFilesThatAreThere) {
  const std::filesystem::path root = DOB_SOURCE_DIR;
  std::string text = test::read_text(root / "docs" / "block-diagram.svg");
  text = std::regex_replace(text, std::regex("controller/</text><text[^>]*>"), "controller/");  // on two lines
  const std::regex file(R"([a-z_]+/[a-z_]+\.(cc|h)\b)");
  int named = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), file), end; found != end; ++found, ++named) {
    EXPECT_TRUE(std::filesystem::is_regular_file(root / found->str())) << found->str();
  }
  EXPECT_GE(named, 12);
}

class FiguresFile : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;

  std::string error_of(const std::string& figures) const {
    const std::filesystem::path file = temporary.path() / "figures.toml";
    std::ofstream(file) << "[[quantity]]\nid = \"q\"\naxis = \"a [m]\"\nsignals = \"x\"\n" << figures;
    try {
      load_figures(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static std::string figure(const std::string& id, const std::string& panel) {
    return "[[figure]]\nid = \"" + id + "\"\ncaption = \"c\"\ncells = \"case1\"\n[[figure.panel]]\n" + panel + "\n";
  }
};

TEST_F(FiguresFile, IsReadOrRefusedWithItsPlace) {
  EXPECT_EQ(error_of(figure("f", "quantity = \"q\"")), "");
  EXPECT_THAT(error_of(figure("f", "quantity = \"none\"")), HasSubstr("figures.toml:10:1"));
  EXPECT_THAT(error_of(figure("f", "quantity = \"q\"\nleg = \"XX\"")), HasSubstr("RF"));
  EXPECT_THAT(error_of(figure("f", "quantity = \"q\"\ntime_s = [2, 1]")), HasSubstr("from < to"));
  EXPECT_THAT(error_of(figure("f", "quantity = \"q\"\nshade_swing = true")), HasSubstr("only with a leg"));
  EXPECT_THAT(error_of(figure("f", "quantity = \"q\"\nlabels = [\"a\"]")), HasSubstr("as many"));
  EXPECT_THAT(error_of(figure("f", "quantity = \"q\"\nnonsense = 1")), HasSubstr("nonsense"));
  EXPECT_THAT(error_of(figure("f", "quantity = \"q\"") + figure("f", "quantity = \"q\"")), HasSubstr("no other"));
}

TEST_F(FiguresFile, WhatIsMissingIsCalledSo) {
  EXPECT_THAT(error_of(figure("f", "leg = \"LF\"")), HasSubstr("figure.0.panel.0.quantity: missing"));
  EXPECT_THAT(error_of("[[figure]]\ncaption = \"c\"\n"), HasSubstr("figure.0.id: missing"));
}

TEST_F(FiguresFile, AnIdCannotLeadOutOfTheDirectory) {
  EXPECT_THAT(error_of(figure("../f", "quantity = \"q\"")), HasSubstr("letters"));
}

}  // namespace
}  // namespace dob::figure_spec_test
