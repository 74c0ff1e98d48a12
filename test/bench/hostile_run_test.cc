// Run directories and scenarios from somebody else: nothing is written outside the run directory, nothing runs.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/bench/command_line.h"

namespace dob::hostile_run_test {
namespace {

namespace fs = std::filesystem;
using test::Answer;
using ::testing::HasSubstr;

class HostileRun : public test::CommandLine {
 protected:
  fs::path outside = dir / "outside";

  void SetUp() override {
    CommandLine::SetUp();
    fs::create_directory(outside);
    std::ofstream(outside / "thesis.tex") << "years of work";
    std::ofstream(outside / "old.part") << "half of it";
  }

  // Everything below `outside`, by its name.
  std::map<std::string, std::string> what_is_outside() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(outside)) {
      files[entry.path().string()] = entry.is_regular_file() ? test::read(entry.path()) : "";
    }
    return files;
  }

  // A run of which one cell is left to be run.
  void make_run() const {
    ASSERT_EQ(dobbench("run undisturbed --observer none --set duration_s=0.6 --out run --keep none").exit_code, 0);
    SQLite::Database((dir / "run/run.sqlite").string(), SQLite::OPEN_READWRITE).exec("DELETE FROM result");
  }
  void replace_by_link(const std::string& name, const fs::path& target) const {
    fs::remove_all(dir / "run" / name);
    fs::create_symlink(target, dir / "run" / name);
  }
};

TEST_F(HostileRun, DirectoriesThatAreLinksAreRefused) {
  make_run();
  const auto before = what_is_outside();
  const std::map<std::string, std::string> commands{
      {"logs", "run --resume --log csv --out run"},
      {"traces", "run --resume --keep all --out run"},
      {"figures", "figures run"},
  };
  for (const auto& [name, command] : commands) {
    replace_by_link(name, outside);
    expect_refused(command, {"run/" + name + ": is a symbolic link; allowed in a run directory: a directory"});
    EXPECT_EQ(what_is_outside(), before) << name;
    fs::remove(dir / "run" / name);
  }
}

TEST_F(HostileRun, FilesThatAreLinksAreReplacedAndWhatTheyPointToStays) {
  make_run();
  const auto before = what_is_outside();
  const std::string cell = "00001_undisturbed__none_-_paper_zmp_seed1";
  const std::vector<std::string> files{"logs/" + cell + ".csv", "traces/" + cell + ".dobtrace", "report.html"};
  for (const std::string& file : files) {
    fs::create_directories((dir / "run" / file).parent_path());
    replace_by_link(file, outside / "thesis.tex");
    replace_by_link(file + ".part", outside / "new.tex");
  }
  const Answer rest = dobbench("run --resume --log csv --log-rate 10 --keep all --out run");
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(dobbench("report run").exit_code, 0);
  EXPECT_EQ(what_is_outside(), before);
  for (const std::string& file : files) {
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(dir / "run" / file))) << file;
  }
}

TEST_F(HostileRun, FiguresThatAreLinksAreReplacedAndWhatTheyPointToStays) {
  ASSERT_EQ(dobbench("run case1/tip_lateral --observer none --set duration_s=1 --out run").exit_code, 0);
  const auto before = what_is_outside();
  fs::create_directory(dir / "run/figures");
  const std::vector<std::string> files{"fig01.svg", "fig01.gp", "errors.svg", "errors.gp", "errors.dat", "index.md"};
  for (const std::string& file : files) replace_by_link("figures/" + file, outside / "thesis.tex");
  const Answer figures = dobbench("figures run");
  EXPECT_EQ(figures.exit_code, 0) << figures.err;
  EXPECT_EQ(what_is_outside(), before);
  for (const std::string& file : files) {
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(dir / "run/figures" / file))) << file;
  }
}

TEST_F(HostileRun, TheDatabaseOrTheLockAsALinkIsRefused) {
  make_run();
  fs::copy_file(dir / "run/run.sqlite", outside / "run.sqlite");
  const auto before = what_is_outside();
  replace_by_link("run.sqlite", outside / "run.sqlite");
  for (const char* command : {"run --resume --out run", "table run", "report run", "timing --out run"}) {
    expect_refused(command, {"run/run.sqlite: is a symbolic link"});
  }
  fs::remove(dir / "run/run.sqlite");
  fs::copy_file(outside / "run.sqlite", dir / "run/run.sqlite");
  replace_by_link("run.lock", outside / "made.lock");
  expect_refused("run --resume --out run", {"run/run.lock: is a symbolic link"});
  EXPECT_EQ(what_is_outside(), before);
}

TEST_F(HostileRun, TriggersInItsDatabaseDoNotRun) {
  make_run();
  SQLite::Database((dir / "run/run.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("CREATE TRIGGER gift AFTER INSERT ON batch BEGIN DELETE FROM cell; END");
  for (const char* command : {"run --resume --out run", "table run", "report run", "figures run", "compare run run"}) {
    expect_refused(command, {"run/run.sqlite: holds the trigger 'gift'"});
  }
}

// Its scenarios are read again by report and figures, and may say anything.
TEST_F(HostileRun, NamesThatLeadElsewhereNameNothingElsewhere) {
  const auto before = what_is_outside();
  const auto names_of = [this] {
    std::map<std::string, bool> names;
    for (const auto& entry : fs::directory_iterator(dir)) names[entry.path().filename().string()] = true;
    return names;
  };
  const auto scenario = [this](const std::string& text) {
    std::ofstream(dir / "mine.toml") << text << "base = \"undisturbed\"\nduration_s = 0.1\n";
  };
  scenario("");
  const auto names = names_of();
  for (const std::string name : {"../../outside/evil", "/tmp/evil", "..", ".hidden", "a/b/c", "a\\nb"}) {
    scenario("name = \"" + name + "\"\n");
    const Answer answer = dobbench("run mine.toml --observer none --out run");
    EXPECT_EQ(answer.exit_code, 2) << name << answer.out;
    EXPECT_EQ(names_of(), names) << name;
  }
  scenario("");
  std::ofstream(dir / "mine.toml", std::ios::app) << "[[variant]]\nname = \"../../outside/evil\"\n";
  EXPECT_EQ(dobbench("run mine.toml --observer none --out run").exit_code, 2);
  EXPECT_EQ(names_of(), names);
  scenario("");
  for (const std::string observer :
       {"../../outside/evil", "momentum:gain_scale=../../outside/evil", "legs=../x,com=com_wrench"}) {
    expect_refused("run mine.toml --profile paper --observer '" + observer + "' --out run", {"--observer"});
    expect_refused("run mine.toml --observer none --shadow '" + observer + "' --out run", {"--shadow"});
    EXPECT_EQ(names_of(), names) << observer;
  }
  // A long name with everything in it that a shell or a path gives a meaning: a directory of its own, nothing else.
  EXPECT_EQ(dobbench("run mine.toml --observer none --out '$(touch evil); a b' --log csv --keep all").exit_code, 0);
  EXPECT_TRUE(is_run_directory(dir / "$(touch evil); a b"));
  fs::remove_all(dir / "$(touch evil); a b");
  EXPECT_EQ(names_of(), names);
  EXPECT_EQ(what_is_outside(), before);
}

TEST_F(HostileRun, ADirectoryInUseByOthersIsNoRunDirectory) {
  const auto before = what_is_outside();
  expect_refused("run undisturbed --observer none --out outside", {"outside: exists, is not empty"});
  expect_refused("run undisturbed --observer none --out outside/thesis.tex", {"outside/thesis.tex"});
  expect_refused("run undisturbed --observer none --out outside/thesis.tex/run", {"cannot create the directory"});
  expect_refused("run undisturbed --observer none --resume --out outside", {"outside: exists, is not empty"});
  EXPECT_EQ(what_is_outside(), before);
}

// What a run directory says about itself goes into a page and a drawing program's script.
TEST_F(HostileRun, TextsInItDoNotBecomePrograms) {
  make_run();
  const std::string evil = "</script><script>alert(1)</script>`touch evil`\"; system(\"touch evil\")";
  SQLite::Database database((dir / "run/run.sqlite").string(), SQLite::OPEN_READWRITE);
  SQLite::Statement name(database, "UPDATE cell SET observer = ?");
  name.bind(1, evil);
  name.exec();
  database.exec(
      "INSERT INTO result(cell, batch, outcome, state_hash, trace, com_error_max_m) "
      "VALUES(1, 1, 'survived', '0000000000000000', '', 0.01)");
  EXPECT_EQ(dobbench("report run").exit_code, 0);
  EXPECT_EQ(test::read(dir / "run/report.html").find("<script>alert(1)"), std::string::npos);
  dobbench("figures run");
  for (const char* format : {"text", "md", "csv", "latex", "json"}) {
    EXPECT_EQ(dobbench(std::string("table run --format ") + format).exit_code, 0) << format;
  }
  for (const fs::path& place : {dir, dir / "run", dir / "run/figures"}) EXPECT_FALSE(fs::exists(place / "evil"));
}

}  // namespace
}  // namespace dob::hostile_run_test
