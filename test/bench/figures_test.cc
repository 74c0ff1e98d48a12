// `dobbench figures` as a user starts it.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/bench/command_line.h"

namespace dob::figures_test {
namespace {

namespace fs = std::filesystem;
using dob::test::Answer;
using dob::test::CommandLine;
using dob::test::read;
using ::testing::HasSubstr;

class FiguresCommand : public CommandLine {
 protected:
  void run_case1() {
    const Answer answer = dobbench(
        "run case1/knee_lateral --observer momentum --observer none --profile paper --set duration_s=14 --out run");
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
  }
};

TEST_F(FiguresCommand, DrawsWhatTheRunHasAndSaysWhatItLacks) {
  run_case1();
  const Answer answer = dobbench("figures run");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("fig05.svg  Case study 1"));
  EXPECT_THAT(answer.out, HasSubstr("not drawn: fig10: case3/left_10"));
  EXPECT_THAT(read(dir / "run/figures/fig05.svg"), HasSubstr("CoM error [mm]"));
  EXPECT_THAT(read(dir / "run/figures/index.md"), HasSubstr("[fig05.svg](fig05.svg)"));
  EXPECT_FALSE(fs::exists(dir / "run/figures/fig10.svg"));

  const Answer again = dobbench("figures run --out again");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  for (const char* name : {"fig01.svg", "fig05.svg", "errors.svg", "fig06.dat", "fig06.gp"}) {
    EXPECT_EQ(read(dir / "again" / name), read(dir / "run/figures" / name)) << name;
    EXPECT_FALSE(read(dir / "again" / name).empty()) << name;
  }
}

TEST_F(FiguresCommand, DrawsEveryFormat) {
  run_case1();
  EXPECT_EQ(dobbench("figures run --format pdf --out figures").exit_code, 0);
  EXPECT_EQ(dobbench("figures run --format png --out figures").exit_code, 0);
  EXPECT_TRUE(read(dir / "figures/fig05.pdf").starts_with("%PDF"));
  EXPECT_TRUE(read(dir / "figures/fig05.png").starts_with("\x89PNG"));
}

TEST_F(FiguresCommand, WithoutGnuplotScriptsAndDataAreThereAndTheErrorNamesThePackage) {
  run_case1();
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", dir.c_str(), 1);  // where there is none
  const Answer without = dobbench("figures run --out figures");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.err, HasSubstr("gnuplot-nox"));
  EXPECT_TRUE(fs::exists(dir / "figures/fig05.gp"));
  EXPECT_TRUE(fs::exists(dir / "figures/fig05.dat"));
}

TEST_F(FiguresCommand, BadInputIsRefused) {
  run_case1();
  expect_refused("figures nowhere", {"nowhere"});
  expect_refused("figures run --format gif", {"--format", "gif"});
  expect_refused("figures run --profile nonsense", {"--profile nonsense", "paper"});
  expect_refused("figures run --observer nonsense", {"--observer nonsense", "momentum"});
  expect_refused("figures run --out run/run.sqlite/x", {"run.sqlite"});
}

}  // namespace
}  // namespace dob::figures_test
