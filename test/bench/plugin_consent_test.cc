// Plugins are code. Only the command line loads one: no scenario, no profile, no run directory.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "test/bench/command_line.h"

namespace dob::plugin_consent_test {
namespace {

namespace fs = std::filesystem;
using test::Answer;

const std::string kPlugin = DOB_PLUGIN_DIR "/leaves_a_mark.so";

class PluginConsent : public test::CommandLine {
 protected:
  bool was_loaded() const { return fs::exists(dir / "PLUGIN_WAS_LOADED"); }
  void forget() const { fs::remove(dir / "PLUGIN_WAS_LOADED"); }
  void write(const char* file, const std::string& text) const { std::ofstream(dir / file) << text; }

  void expect_refused_without_loading(const std::string& arguments, const std::vector<std::string>& parts) const {
    forget();
    expect_refused(arguments, parts);
    EXPECT_FALSE(was_loaded()) << arguments;
  }
};

TEST_F(PluginConsent, TheCommandLineLoadsOne) {
  EXPECT_EQ(dobbench("run undisturbed --set duration_s=0.1 --out run --observer '" + kPlugin + "'").exit_code, 0);
  EXPECT_TRUE(was_loaded());
  forget();
  const std::string shadow = "run undisturbed --set duration_s=0.1 --observer none --out shadow --shadow '";
  EXPECT_EQ(dobbench(shadow + kPlugin + "'").exit_code, 0);
  EXPECT_TRUE(was_loaded());
}

TEST_F(PluginConsent, AScenarioOrAProfileDoesNot) {
  const auto scenario = [](const std::string& observer) {
    return "base = \"undisturbed\"\nduration_s = 0.1\nobservers = [\"none\", \"" + observer + "\"]\n";
  };
  write("mine.toml", scenario(kPlugin));
  write("pair.toml", scenario("legs=momentum,com=" + kPlugin));
  for (const std::string name : {"mine.toml", "pair.toml"}) {
    const std::vector<std::string> parts{name + ":3:", "leaves_a_mark.so", "the file of a plugin", "--observer"};
    expect_refused_without_loading("run " + name, parts);
    expect_refused_without_loading("check " + name, parts);
    expect_refused_without_loading("timing " + name, parts);
  }
  write("profile.toml", "[momentum]\ngains = [2.25, 6.28, 17.5]\n[\"" + kPlugin + "\"]\ngain = 1\n");
  expect_refused_without_loading("check profile.toml", {"profile.toml:3:", "leaves_a_mark.so", "[plugin.NAME]"});
}

TEST_F(PluginConsent, ARunDirectoryThatWasBegunWithOneDoesNotUnlessItIsNamedAgain) {
  fs::copy_file(kPlugin, dir / "other.so");
  const std::string what = "run undisturbed --set duration_s=0.5 ";
  const std::string begin[] = {what + "--observer '" + kPlugin + "' --out own",
                               what + "--observer 'legs=" + kPlugin + ",com=com_wrench' --profile paper --out pair",
                               what + "--observer none --shadow momentum,'" + kPlugin + "' --out shadow"};
  for (const std::string& run : begin) ASSERT_EQ(dobbench(run).exit_code, 0) << run;
  for (const std::string run : {"own", "pair", "shadow"}) {
    for (const std::string command : {"run --resume --out ", "timing --seconds 0.2 --out "}) {
      expect_refused_without_loading(command + run, {"--plugin " + kPlugin, "code that would run here", run});
      expect_refused_without_loading(command + run + " --plugin other.so", {"--plugin " + kPlugin});
      EXPECT_EQ(dobbench(command + run + " --plugin '" + kPlugin + "'").exit_code, 0) << command << run;
      EXPECT_TRUE(was_loaded());
    }
  }
  expect_refused_without_loading("run undisturbed --plugin '" + kPlugin + "'", {"--plugin", "--resume"});
}

TEST_F(PluginConsent, ReadingARunDoesNot) {
  ASSERT_EQ(
      dobbench("run undisturbed --set duration_s=1 --out run --observer '" + kPlugin + "' --observer none").exit_code,
      0);
  forget();
  for (const char* command : {"table run", "table run --claims", "report run", "figures run", "compare run run",
                              "check run/scenarios/undisturbed_paper.toml"}) {
    const Answer answer = dobbench(command);
    EXPECT_LE(answer.exit_code, 2) << command << answer.err;
    EXPECT_FALSE(was_loaded()) << command;
  }
}

TEST_F(PluginConsent, OneThatCrashesOrLeavesWhileItIsLoadedIsRefusedInOneLine) {
  const std::string bad = DOB_PLUGIN_DIR "/misbehaves.so";
  const std::string how = "run undisturbed --observer '" + bad + ":how=";
  expect_refused(how + "crash_when_made'", {"misbehaves.so", "while it was loaded: crashed: Segmentation fault"});
  expect_refused(how + "exit_when_made'", {"misbehaves.so", "while it was loaded: ended without a result"});
  expect_refused("run undisturbed --observer none --shadow '" + bad + ":how=crash_when_made'", {"Segmentation fault"});
}

}  // namespace
}  // namespace dob::plugin_consent_test
