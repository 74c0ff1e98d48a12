#include "scenarios/data_root.h"

#include <gtest/gtest.h>

#include "test/scenarios/scratch_files.h"

namespace dob::data_root_test {
namespace {

namespace fs = std::filesystem;

// A directory that holds data, as far as the program looks.
fs::path with_data(const ScratchFiles& files, const std::string& name) {
  files.write(name + "/scenarios/config/defaults.toml", "");
  return files.directory() / name;
}

TEST(DataRoot, OfAnInstalledProgramIsTheShareDirectoryBesideIt) {
  const ScratchFiles files;
  const fs::path share = with_data(files, "prefix/share/dobbench");
  const fs::path source = with_data(files, "source");
  EXPECT_EQ(data_root_of(files.directory() / "prefix/bin/dobbench", {source}), share);
  // The prefix is moved; nothing is written anywhere.
  fs::rename(files.directory() / "prefix", files.directory() / "moved");
  EXPECT_EQ(data_root_of(files.directory() / "moved/bin/dobbench", {source}),
            files.directory() / "moved/share/dobbench");
}

TEST(DataRoot, OfAProgramInABuildTreeIsTheSourceTree) {
  const ScratchFiles files;
  const fs::path source = with_data(files, "source");
  const fs::path configured = with_data(files, "usr/share/dobbench");
  EXPECT_EQ(data_root_of(source / "build/bin/dobbench", {source, configured}), source);
}

TEST(DataRoot, OfAProgramElsewhereIsTheConfiguredPrefixWhenTheSourceTreeIsGone) {
  const ScratchFiles files;
  const fs::path gone = files.directory() / "source";
  const fs::path configured = with_data(files, "usr/share/dobbench");
  EXPECT_EQ(data_root_of("/nowhere/bin/my_program", {gone, configured}), configured);
  EXPECT_EQ(data_root_of("/nowhere/bin/my_program", {gone, gone / "share"}), gone / "share");
}

TEST(DataRoot, OfThisBuildHoldsWhatTheProgramReads) {
  for (const char* file : {"scenarios/undisturbed.toml", "scenarios/config/defaults.toml", "robot/dogbot/dogbot.urdf",
                           "results/paper_claims.toml", "results/paper_figures.toml", "results/report/template.html"}) {
    EXPECT_TRUE(fs::is_regular_file(data_root() / file)) << data_root() / file;
  }
}

}  // namespace
}  // namespace dob::data_root_test
