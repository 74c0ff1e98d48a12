// The scripts are judged by what a shell does with them: the program is replaced by one that prints its words.
#include "bench/slurm_scripts.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/shell_words.h"
#include "results/whole_file.h"
#include "scenarios/input_error.h"
#include "test/results/run_samples.h"

namespace dob::slurm_scripts_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class SlurmScriptsOfACampaign : public ::testing::Test {
 protected:
  // A directory whose name has whatever a name may have.
  SlurmScriptsOfACampaign() : dir_(temporary_.path() / "it's 100%d \"a\" $b `c`;&") {
    fs::create_directories(dir_ / "shards");
    write_whole_file(dir_ / "a program", "#!/bin/sh\nfor word; do printf '<%s>' \"$word\"; done\npwd\n");
    fs::permissions(dir_ / "a program", fs::perms::owner_all);
    options_ = {.program = dir_ / "a program",
                .campaign = dir_ / "campaign" / "limit.toml",
                .working_directory = temporary_.path(),
                .dir = dir_,
                .tasks = 12,
                .cpus = 2};
  }

  // What the program was called with, as <WORD><WORD>...; what the shell says of errors as it is.
  std::string run(const std::string& script, const std::string& environment) const {
    write_whole_file(dir_ / "script", script);
    const fs::path said = temporary_.path() / "said";
    const std::string command = "env -u SLURM_ARRAY_TASK_ID -u SLURM_CPUS_PER_TASK " + environment + " sh " +
                                join_words({(dir_ / "script").string()}) + " > " + said.string() + " 2>&1";
    exit_code_ = WEXITSTATUS(std::system(command.c_str()));
    return test::read_text(said);
  }

  std::string shard_words(const std::string& shard, const std::string& directory, const std::string& jobs) const {
    return "<campaign><" + options_.campaign.string() + "><--shard><" + shard + "><--out><" + dir_.string() +
           "/shards/" + directory + "><--resume><--jobs><" + jobs + ">";
  }

  test::TemporaryDirectory temporary_;
  fs::path dir_;
  SlurmOptions options_;
  mutable int exit_code_ = -1;
};

TEST_F(SlurmScriptsOfACampaign, ATaskRunsTheShardOfItsNumber) {
  const std::string script = slurm_scripts(options_).array;
  EXPECT_EQ(run(script, "SLURM_ARRAY_TASK_ID=7 SLURM_ARRAY_TASK_COUNT=12 SLURM_CPUS_PER_TASK=5"),
            shard_words("7/12", "7", "5") + temporary_.path().string() + "\n");
}

// Submitted again alone, a task is the only one of its array and still the same shard.
TEST_F(SlurmScriptsOfACampaign, ATaskSubmittedAloneRunsTheSameShard) {
  const std::string script = slurm_scripts(options_).array;
  const std::string alone = run(script, "SLURM_ARRAY_TASK_ID=7 SLURM_ARRAY_TASK_COUNT=1");
  EXPECT_THAT(alone, HasSubstr(shard_words("7/12", "7", "2")));
  const std::string other_number = run(script, "SLURM_ARRAY_TASK_ID=7 DOB_SHARDS=9");
  EXPECT_THAT(other_number, HasSubstr("<--shard><7/9>"));
}

TEST_F(SlurmScriptsOfACampaign, AShardRunsByHand) {
  const std::string script = slurm_scripts(options_).array;
  EXPECT_THAT(run(script, "DOB_SHARD=3"), HasSubstr(shard_words("3/12", "3", "2")));
  // The environment in which an array is submitted does not make all its tasks one shard.
  EXPECT_THAT(run(script, "DOB_SHARD=3 SLURM_ARRAY_TASK_ID=7"), HasSubstr("<7/12>"));
  EXPECT_THAT(run(script, "A=b"), HasSubstr("the number of a shard, 1 to 12"));
  EXPECT_NE(exit_code_, 0);
}

TEST_F(SlurmScriptsOfACampaign, WhatTheCampaignIsToBeToldIsHandedOn) {
  options_.campaign_arguments = {"--budget", "64"};
  EXPECT_THAT(run(slurm_scripts(options_).array, "DOB_SHARD=3"), HasSubstr("<--jobs><2><--budget><64>"));
}

TEST_F(SlurmScriptsOfACampaign, TheMergeTakesTheShardsThatHaveBegun) {
  const std::string script = slurm_scripts(options_).merge;
  EXPECT_THAT(run(script, "A=b"), HasSubstr("no shard has begun"));
  EXPECT_EQ(exit_code_, 3);
  for (const char* shard : {"1", "2", "10"}) fs::create_directories(dir_ / "shards" / shard);
  for (const char* shard : {"1", "10"}) write_whole_file(dir_ / "shards" / shard / "run.sqlite", "");
  const std::string shards = dir_.string() + "/shards/";
  EXPECT_THAT(run(script, "A=b"),
              HasSubstr("<merge><" + shards + "1><" + shards + "10><--out><" + dir_.string() + "/merged>"));
}

TEST_F(SlurmScriptsOfACampaign, SlurmIsAskedForWhatTheOptionsSay) {
  const SlurmScripts plain = slurm_scripts(options_);
  for (const char* part : {"#SBATCH --array=1-12\n", "#SBATCH --cpus-per-task=2\n", "#SBATCH --requeue\n",
                           "#SBATCH --job-name=\"limit\"\n", "it's 100%%d \\\"a\\\" $b `c`;&/logs/%A_%a.out\"\n"}) {
    EXPECT_THAT(plain.array, HasSubstr(part));
  }
  for (const char* part : {"--mem", "--time", "--partition"}) EXPECT_THAT(plain.array, Not(HasSubstr(part)));
  EXPECT_THAT(plain.merge, Not(HasSubstr("--array")));
  EXPECT_THAT(plain.merge, HasSubstr("#SBATCH --cpus-per-task=1\n"));
  options_.memory_MB = 1500;
  options_.time = "1-02:30:00";
  options_.partition = "short,long";
  const SlurmScripts full = slurm_scripts(options_);
  for (const char* part : {"#SBATCH --mem=1500M\n", "#SBATCH --time=1-02:30:00\n", "#SBATCH --partition=short,long\n"})
    for (const std::string& script : {full.array, full.merge}) EXPECT_THAT(script, HasSubstr(part));
}

TEST_F(SlurmScriptsOfACampaign, MoreTimeOrMemoryIsStillTheSameCampaign) {
  const std::string script = slurm_scripts(options_).array;
  SlurmOptions more = options_;
  more.time = "10:00:00";
  more.memory_MB = 8000;
  EXPECT_TRUE(same_shards(script, slurm_scripts(more).array));
  SlurmOptions other = options_;
  other.tasks = 13;
  EXPECT_FALSE(same_shards(script, slurm_scripts(other).array));
  other = options_;
  other.campaign_arguments = {"--budget", "64"};
  EXPECT_FALSE(same_shards(script, slurm_scripts(other).array));
}

TEST_F(SlurmScriptsOfACampaign, WhatSlurmCannotReadIsRefused) {
  const auto refused = [this](auto change) {
    SlurmOptions options = options_;
    change(options);
    try {
      validate(options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const char* time : {"00:10:00", "1:00:00", "100:59:59", "3-00:00:00"})
    EXPECT_EQ(refused([&](SlurmOptions& o) { o.time = time; }), "");
  for (const char* time : {"10", "10:00", "0:60:00", "0:00:60", "-1:00:00", "1-1-00:00:00", "00:00:00 --wrap",
                           "a:00:00", "1:0:0", ":00:00", "1:00:000"})
    EXPECT_THAT(refused([&](SlurmOptions& o) { o.time = time; }), HasSubstr("--time " + std::string(time))) << time;
  for (const char* partition : {"a b", "a\n#SBATCH --uid=0", "$x", "a;b"})
    EXPECT_THAT(refused([&](SlurmOptions& o) { o.partition = partition; }), HasSubstr("--partition ")) << partition;
  EXPECT_THAT(refused([](SlurmOptions& o) { o.dir = "/a\\b"; }), HasSubstr("--out /a\\b: "));
  EXPECT_THAT(refused([](SlurmOptions& o) { o.dir = "/a\nb"; }), HasSubstr("--out /a\\x0ab: "));
  EXPECT_THAT(refused([](SlurmOptions& o) { o.campaign = "/a/b\nc.toml"; }), HasSubstr("FILE /a/b\\x0ac.toml: "));
}

TEST_F(SlurmScriptsOfACampaign, ShellcheckFindsNothing) {
  if (std::system("command -v shellcheck > /dev/null") != 0) GTEST_SKIP() << "no shellcheck (Debian: shellcheck)";
  options_.dir = temporary_.path() / "it's here";  // it would take $b in quotes for an oversight
  options_.program = options_.dir / "bin" / "dobbench";
  options_.campaign = options_.dir / "campaign" / "limit.toml";
  options_.campaign_arguments = {"--budget", "64"};
  const SlurmScripts scripts = slurm_scripts(options_);
  for (const std::string& script : {scripts.array, scripts.merge, scripts.submit}) {
    write_whole_file(temporary_.path() / "script", script);
    EXPECT_EQ(std::system(("shellcheck " + (temporary_.path() / "script").string()).c_str()), 0) << script;
  }
}

}  // namespace
}  // namespace dob::slurm_scripts_test
