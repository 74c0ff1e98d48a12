#include "scenarios/document.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "test/scenarios/scratch_files.h"

namespace dob::document_test {
namespace {

Node parse(const std::string& text) {
  return parse_file(ScratchFiles().write("document.toml", text));
}

double number_at(const Node& table, std::string_view key) {
  return std::get<double>(table.find(key)->value);
}

TEST(Document, MergesTablesKeyByKeyAndReplacesEverythingElse) {
  Node base = parse("a = 1\nlist = [1, 2, 3]\n[t]\nx = 1\ny = 2\n[t.u]\nz = 3\n");
  merge(base, parse("list = [4]\n[t]\ny = 5\n[t.u]\nw = 6\n"));
  EXPECT_EQ(to_toml(base), "a = 1\nlist = [4]\n\n[t]\nx = 1\ny = 5\n\n[t.u]\nz = 3\nw = 6\n");
}

TEST(Document, ReplacesListsOfTablesAsAWhole) {
  Node base = parse("[[d]]\nx = 1\n[[d]]\nx = 2\n");
  merge(base, parse("[[d]]\ny = 3\n"));
  EXPECT_EQ(to_toml(base), "\n[[d]]\ny = 3\n");
}

TEST(Document, MergesATableOfNumbersIntoTheElementsOfAList) {
  Node base = parse("[[d]]\nx = 1\n[[d]]\nx = 2\ny = 3\n");
  merge(base, parse("d.1.x = 5\n"));
  EXPECT_EQ(to_toml(base), "\n[[d]]\nx = 1\n\n[[d]]\nx = 5\ny = 3\n");
  EXPECT_THROW(merge(base, parse("d.2.x = 5\n")), InputError);
}

TEST(Document, MergedValuesStillStandWhereTheyWereWritten) {
  Node base = parse("\n\n[t]\nx = 1\ny = 2\n");
  merge(base, parse("[t]\n  y = 5\n"));
  const Node& table = *base.find("t");
  EXPECT_EQ(table.find("x")->place.line, 4);
  EXPECT_EQ(table.find("y")->place.line, 2);
  EXPECT_EQ(table.find("y")->place.column, 3);
}

TEST(Document, SetsAValueInATableAndInAListOfTables) {
  Node document = parse("[[d]]\nx = 1\n[[d]]\nx = 2\n");
  set(document, "d.1.x", {7.0, {"--set"}});
  set(document, "new.table.key", {true, {"--set"}});
  EXPECT_EQ(to_toml(document), "\n[[d]]\nx = 1\n\n[[d]]\nx = 7\n\n[new]\n\n[new.table]\nkey = true\n");
}

TEST(Document, CopiesAreIndependent) {
  const Node original = parse("[t]\nx = 1\n");
  Node copy = original;
  set(copy, "t.x", {2.0, {"--set"}});
  EXPECT_EQ(number_at(*original.find("t"), "x"), 1.0);
}

TEST(Document, KeepsTheOrderOfTheFile) {
  EXPECT_EQ(to_toml(parse("z = 1\na = 2\nm = 3\n")), "z = 1\na = 2\nm = 3\n");
}

TEST(Document, WritesTextThatParsesToTheSameText) {
  const std::string text =
      "text = \"a \\\"b\\\" \\\\ \\u0009 \\u000a \u00e9\"\n\"odd key\" = [[1, 2], [\"x\", true], "
      "[]]\n\n[t]\n\n[t.u]\nempty = []\n";
  EXPECT_EQ(to_toml(parse(text)), text);
}

TEST(Document, WritesEveryNumberExactly) {
  std::mt19937_64 engine(1);
  for (int i = 0; i < 2000; ++i) {
    const double number = std::bit_cast<double>(engine());
    if (!std::isfinite(number)) continue;
    const Node written{Table{{"x", {number, {}}}}, {}};
    const Node value = parse_value("x", describe(*written.find("x")), {"--set"});
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::get<double>(value.value)), std::bit_cast<std::uint64_t>(number))
        << to_toml(written);
  }
}

TEST(Document, TakesAWordWithoutQuotesFromTheCommandLine) {
  EXPECT_EQ(std::get<std::string>(parse_value("metric_leg", "LF", {"--set"}).value), "LF");
  EXPECT_EQ(std::get<std::string>(parse_value("metric_leg", "\"LF\"", {"--set"}).value), "LF");
  EXPECT_EQ(std::get<bool>(parse_value("sim.joint_stops", "true", {"--set"}).value), true);
}

}  // namespace
}  // namespace dob::document_test
