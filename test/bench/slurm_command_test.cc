// `dobbench slurm` as a user starts it; an sbatch of our own stands in for Slurm (test/slurm/run has the real one).
#include <gmock/gmock.h>

#include "test/bench/command_line.h"

namespace dob::slurm_command_test {
namespace {

namespace fs = std::filesystem;
using dob::test::Answer;
using dob::test::read;
using testing::HasSubstr;

class SlurmCommand : public dob::test::CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    fs::copy_file(DOB_SOURCE_DIR "/test/slurm/campaign.toml", dir / "limit.toml");
  }

  // With an sbatch that writes down its words and prints job ids 100, 200, ..., or as `body` has it.
  Answer with_sbatch(const std::string& arguments, const std::string& body) const {
    fs::create_directories(dir / "bin");
    std::ofstream(dir / "bin" / "sbatch") << "#!/bin/sh\n" << body;
    fs::permissions(dir / "bin" / "sbatch", fs::perms::owner_all);
    const std::string path = "PATH='" + (dir / "bin").native() + "':$PATH ";
    return dobbench("--version > /dev/null && " + path + "'" DOBBENCH "' " + arguments);
  }

  std::string taking() const {
    const std::string file = "'" + (dir / "asked").native() + "'";
    return "echo \"$@\" >> " + file + "; echo $(wc -l < " + file + ")00\n";
  }
};

TEST_F(SlurmCommand, BadInputIsRefusedInOneLineAndNothingIsWritten) {
  expect_refused("slurm --tasks 4", {"file is required"});
  expect_refused("slurm limit.toml", {"--tasks is required"});
  expect_refused("slurm missing.toml --tasks 4", {"missing.toml", "No such file"});
  expect_refused("slurm . --tasks 4", {"a campaign is a file NAME.toml"});
  std::ofstream(dir / "torn.toml") << "kind = \"limit\"\n[budget\n";
  expect_refused("slurm torn.toml --tasks 4", {"torn.toml:2:"});
  for (const char* tasks : {"0", "-1", "10001", "1.5", "nan", "four"})
    expect_refused("slurm limit.toml --tasks " + std::string(tasks), {"--tasks", tasks});
  const std::string good = "slurm limit.toml --tasks 4 ";
  for (const char* option : {"--cpus 0", "--cpus 1025", "--memory 0", "--memory nan", "--budget 0", "--budget 1e9"})
    expect_refused(good + option, {std::string(option).substr(0, 6)});
  expect_refused(good + "--time 10", {"--time 10", "HH:MM:SS"});
  expect_refused(good + "--partition 'a b'", {"--partition a b"});
  expect_refused(good + "--out 'a\\b'", {"--out", "backslashes"});
  expect_refused(good + "--out limit.toml", {"limit.toml", "a directory"});
}

TEST_F(SlurmCommand, WritesScriptsAndACopyOfTheCampaign) {
  const Answer answer = dobbench("slurm limit.toml --tasks 4 --budget 64");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  const fs::path out = dir / "dobbench-results" / "limit";
  EXPECT_EQ(answer.out, fs::canonical(out).string() + ": array.sbatch (4 tasks), merge.sbatch, submit\n");
  EXPECT_EQ(read(out / "campaign" / "limit.toml"), read(dir / "limit.toml"));
  EXPECT_THAT(read(out / "array.sbatch"), HasSubstr(" --budget 64\n"));
  EXPECT_TRUE(fs::is_directory(out / "logs"));
  EXPECT_NE(fs::status(out / "submit").permissions() & fs::perms::owner_exec, fs::perms::none);
}

TEST_F(SlurmCommand, ADirectoryKeepsToItsCampaign) {
  ASSERT_EQ(dobbench("slurm limit.toml --tasks 4 --out a").exit_code, 0);
  const std::string array = read(dir / "a" / "array.sbatch");
  EXPECT_EQ(dobbench("slurm limit.toml --tasks 4 --out a/").exit_code, 0);
  EXPECT_EQ(read(dir / "a" / "array.sbatch"), array);
  EXPECT_EQ(dobbench("slurm limit.toml --tasks 4 --out a --time 10:00:00 --memory 900").exit_code, 0);
  EXPECT_NE(read(dir / "a" / "array.sbatch"), array);
  const std::string longer = read(dir / "a" / "array.sbatch");
  expect_refused("slurm limit.toml --tasks 5 --out a", {"--out", "another campaign"});
  expect_refused("slurm limit.toml --tasks 4 --budget 80 --out a", {"--out", "another campaign"});
  std::ofstream(dir / "limit.toml", std::ios::app) << "# changed\n";
  expect_refused("slurm limit.toml --tasks 4 --out a", {"--out", "another campaign"});
  EXPECT_EQ(read(dir / "a" / "array.sbatch"), longer);
  fs::create_directories(dir / "mine" / "work");
  expect_refused("slurm limit.toml --tasks 4 --out mine", {"--out", "not empty"});
}

TEST_F(SlurmCommand, SubmitsTheArrayAndTheMergeBehindIt) {
  const Answer answer = with_sbatch("slurm limit.toml --tasks 4 --out 'a b' --submit", taking());
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("array job 100\nmerge job 200\n"));
  EXPECT_EQ(read(dir / "asked"),
            "--parsable array.sbatch\n--parsable --dependency=afterany:100,singleton merge.sbatch\n");
  const Answer again =
      dobbench("--version > /dev/null && PATH='" + (dir / "bin").native() + "':$PATH 'a b/submit' 2,4");
  EXPECT_EQ(again.out, "array job 300\nmerge job 400\n") << again.err;
  EXPECT_THAT(read(dir / "asked"), HasSubstr("--parsable --array=2,4 array.sbatch\n"));
}

TEST_F(SlurmCommand, JobsThatSlurmDoesNotTakeAreAnError) {
  const Answer answer =
      with_sbatch("slurm limit.toml --tasks 4 --out a --submit", "echo 'no such partition' >&2; exit 1\n");
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_THAT(answer.err, HasSubstr("no such partition\ndobbench: --submit: "));
  EXPECT_TRUE(fs::exists(dir / "a" / "array.sbatch"));
}

}  // namespace
}  // namespace dob::slurm_command_test
