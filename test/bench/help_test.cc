// What the program says of itself: help, examples, manual page, completion.
#include <regex>
#include <set>

#include <gmock/gmock.h>

#include "test/bench/command_line.h"

namespace dob::help_test {
namespace {

using dob::test::Answer;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

class Help : public dob::test::CommandLine {
 protected:
  std::vector<std::string> commands() const {
    const std::string help = dobbench("--help").out;
    std::vector<std::string> names;
    for (const std::string& line : lines_of(help.substr(help.find("Subcommands:")))) {
      if (std::smatch match; std::regex_search(line, match, std::regex("^  (\\w+) "))) names.push_back(match[1]);
    }
    return names;
  }

  // The example lines of a command's help.
  std::vector<std::string> examples(const std::string& command) const {
    const std::string help = dobbench(command + " --help").out;
    std::vector<std::string> examples;
    for (const std::string& line : lines_of(help)) {
      if (line.starts_with("  dobbench ")) examples.push_back(line.substr(2));
    }
    return examples;
  }

  std::vector<std::string> completions(const std::string& words) const {
    const Answer answer = dobbench("__complete " + words);
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_EQ(answer.err, "");
    return lines_of(answer.out);
  }

  // A shell command where `dobbench` is the program.
  Answer shell(const std::string& command) const {
    const std::string program = DOBBENCH;
    return dobbench("--version >/dev/null && PATH='" + program.substr(0, program.rfind('/')) + "':$PATH && " + command);
  }
};

TEST_F(Help, EveryCommandShowsWhatItIsUsedFor) {
  ASSERT_GE(commands().size(), 12U);
  for (const std::string& command : commands()) {
    ASSERT_THAT(examples(command), Not(IsEmpty())) << command;
    for (const std::string& example : examples(command)) EXPECT_THAT(example, HasSubstr("dobbench " + command));
  }
}

TEST_F(Help, ValuesOfAnOptionStandBehindItsName) {
  EXPECT_THAT(dobbench("run --help").out, HasSubstr("  --keep {all,first-seed,none}"));
  EXPECT_THAT(dobbench("table --help").out, HasSubstr("  --format {csv,json,latex,md,text}"));
}

// In this order each finds what those before it have left.
TEST_F(Help, TheExamplesRun) {
  std::filesystem::copy_file(DOB_SOURCE_DIR "/test/slurm/campaign.toml", dir / "limit.toml");
  std::set<std::string> left;
  for (const std::string& command : commands()) left.insert(command);
  for (const char* command : {"list", "run", "table", "report", "figures", "campaign", "merge", "compare", "verify",
                              "timing", "analyse", "check", "tune", "slurm", "completion", "manual"}) {
    for (const std::string& example : examples(command)) {
      const Answer answer = shell(example);
      EXPECT_EQ(answer.exit_code, 0) << example << ": " << answer.err;
    }
    left.erase(command);
  }
  EXPECT_THAT(left, IsEmpty()) << "a command whose examples nobody has run";
}

TEST_F(Help, TheVersionNamesCommitBuildAndCompiler) {
  const Answer answer = dobbench("--version");
  EXPECT_TRUE(std::regex_match(answer.out, std::regex("dobbench \\d+\\.\\d+\\.\\d+ \\(\\S.*, \\w+, \\w+ [\\d.]+\\)\n")))
      << answer.out;
}

TEST_F(Help, TheManualPageDescribesEveryCommandAndOption) {
  const Answer manual = dobbench("manual");
  ASSERT_EQ(manual.exit_code, 0);
  const std::vector<std::string> lines = lines_of(manual.out);
  EXPECT_THAT(lines.front(), HasSubstr(".TH DOBBENCH 1 "));
  for (const std::string& command : commands()) EXPECT_THAT(lines, Contains(".SS " + command));
  std::size_t entries = 0;
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    if (lines[i] != ".TP") continue;
    ++entries;
    EXPECT_GE(lines[i + 2].size(), 5U) << lines[i + 1];
    EXPECT_FALSE(lines[i + 2].starts_with(".")) << lines[i + 1];
  }
  EXPECT_GT(entries, 60U);
  for (const char* part : {"\\-\\-observer", "\\-\\-resume", ".SH EXIT STATUS", ".SH EXAMPLES", "DOBBENCH_SCENARIOS"}) {
    EXPECT_THAT(manual.out, HasSubstr(part));
  }
}

TEST_F(Help, CompletionKnowsCommandsOptionsAndValues) {
  EXPECT_THAT(completions("''"), IsSupersetOf(commands()));
  EXPECT_THAT(completions("ta"), ElementsAre("table"));
  EXPECT_THAT(completions("nonsense ''"), IsEmpty());
  EXPECT_THAT(completions("run --ob"), ElementsAre("--observer"));
  EXPECT_THAT(completions("run --keep ''"), ElementsAre("all", "first-seed", "none"));
  EXPECT_THAT(completions("table --format = js"), ElementsAre("json"));
  EXPECT_THAT(completions("list sc"), ElementsAre("scenarios"));
  EXPECT_THAT(completions("completion ''"), ElementsAre("bash", "zsh"));
}

TEST_F(Help, CompletionKnowsWhatThereIsToRun) {
  EXPECT_THAT(completions("run case1/ti"), ElementsAre("case1/tip_lateral", "case1/tip_sagittal"));
  EXPECT_THAT(completions("run --observer none --claims undist"), ElementsAre("undisturbed"));
  EXPECT_THAT(completions("run case1 --observer momentum_c"), ElementsAre("momentum_com"));
  EXPECT_THAT(completions("analyse none com_w"), ElementsAre("com_wrench"));
  EXPECT_THAT(completions("run --profile ''"), ElementsAre("matched", "paper", "tuned"));
  EXPECT_THAT(completions("run --planner s"), ElementsAre("spline"));
  EXPECT_THAT(completions("compare a b --metric slip"), ElementsAre("slip_max_m"));
  EXPECT_THAT(completions("table some"), IsEmpty());  // the shell offers files
}

TEST_F(Help, EveryOptionOfTheHelpIsOffered) {
  for (const std::string& command : commands()) {
    const std::vector<std::string> offered = completions(command + " -");
    const std::string help = dobbench(command + " --help").out;
    int options = 0;
    for (const std::string& line : lines_of(help.substr(help.find("Options:")))) {
      std::smatch match;
      if (!std::regex_search(line, match, std::regex("^  (?:-\\w,)?(--[\\w-]+)"))) continue;
      EXPECT_THAT(offered, Contains(match[1].str())) << command;
      ++options;
    }
    EXPECT_EQ(offered.size(), static_cast<std::size_t>(options)) << command;
  }
}

TEST_F(Help, BashCompletesWithTheScript) {
  const std::string words =
      "bash -euc 'source <(dobbench completion bash); COMP_WORDS=(dobbench run case1/tip_l); COMP_CWORD=2; _dobbench; "
      "printf \"%s,\" \"${COMPREPLY[@]}\"; complete -p dobbench'";
  const Answer answer = shell(words);
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.out, "case1/tip_lateral,complete -o default -F _dobbench dobbench\n");
}

}  // namespace
}  // namespace dob::help_test
