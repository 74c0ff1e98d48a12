#include "observers/plugin.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/momentum.h"
#include "test/observers/ideal_plant.h"

namespace dob::plugin_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace fs = std::filesystem;

fs::path plugin(const std::string& name) {
  return fs::path(DOB_PLUGIN_DIR) / (name + ".so");
}

std::string error_of(const fs::path& file, const ObserverOptions& options = {}) {
  try {
    make_observer(file.string(), options, 1e-3);
  } catch (const OptionError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "no error";
}

TEST(Plugin, SaysWhatItIs) {
  const ObserverInfo info = load_plugin(plugin("first_order"));
  EXPECT_EQ(info.name, "first_order");
  EXPECT_EQ(info.summary, "for tests");
  EXPECT_TRUE(info.estimates_legs);
  EXPECT_FALSE(info.estimates_com);
}

TEST(Plugin, GivesBitForBitWhatTheSameObserverGivesBuiltIn) {
  const auto observer = make_observer(plugin("first_order").string(), {{"gain_rad_s", 30.0}}, 1e-3);
  MomentumObserver twin({.gains = {{30.0}}}, 1e-3);
  test::IdealPlant plant;
  plant.disturbance.setLinSpaced(-3.0, 3.0);
  for (int k = 0; k < 200; ++k) {
    plant.torque.setConstant(std::sin(0.1 * k));
    const ObserverInput input = plant.advance(1e-3);
    const Vec12 expected = twin.update(input).leg_torque;
    ASSERT_TRUE(observer->update(input).leg_torque.isApprox(expected, 1e-12));
  }
}

TEST(Plugin, RefusesOptionsInItsOwnWords) {
  EXPECT_THAT(error_of(plugin("first_order"), {{"gian", 1.0}}),
              AllOf(HasSubstr("first_order"), HasSubstr("gain_rad_s")));
  EXPECT_THAT(error_of(plugin("first_order"), {{"gain_rad_s", -1.0}}), HasSubstr("gain_rad_s = -1"));
}

TEST(Plugin, IsRefusedInOneLineForEveryWayToBeWrong) {
  const std::string interface = "built for plugin interface 0, this program needs 1";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"no_entry", "it exports no function dob_observer_plugin()"},
      {"nothing", "dob_observer_plugin() returned nothing"},
      {"old_interface", interface},
      {"other_layout", "built for ModelTerms of size"},
      {"name_with_space", "its name is 'my observer'; allowed: lower-case letters, digits and _"},
      {"built_in_name", "its name 'momentum' is that of a built-in observer"},
      {"no_factory", "it has no function that makes the observer"},
      {"throws", "its factory threw: out of ideas"},
      {"throws_number", "its factory threw something that is no std::exception"},
      {"makes_nothing", "its factory returned no observer"},
      {"unresolved", "cannot be loaded: undefined symbol"},
  };
  for (const auto& [name, reason] : wrong) {
    const fs::path file = plugin(name);
    EXPECT_THAT(error_of(file), StartsWith("plugin " + file.string() + ": " + reason));
  }
}

TEST(Plugin, IsRefusedWhenItIsNoLibraryAtAll) {
  EXPECT_THAT(error_of("/nowhere/mine.so"), HasSubstr("plugin /nowhere/mine.so: there is no such file"));
  EXPECT_THAT(error_of("mine.so"), HasSubstr("there is no such file"));
  EXPECT_THAT(error_of(DOB_PLUGIN_DIR), HasSubstr("there is no such file")) << "a directory";
  const fs::path text = fs::temp_directory_path() / ("dob_text_" + std::to_string(::getpid()) + ".so");
  std::ofstream(text) << std::string(4096, 'x');
  EXPECT_THAT(error_of(text), AllOf(HasSubstr("cannot be loaded"), HasSubstr("ELF")));
  std::ofstream(text, std::ios::trunc).close();
  EXPECT_THAT(error_of(text), HasSubstr("cannot be loaded: file too short"));
  fs::remove(text);
}

TEST(Plugin, IsToldFromANameByItsPath) {
  EXPECT_TRUE(is_plugin_path("mine.so"));
  EXPECT_TRUE(is_plugin_path("./mine"));
  EXPECT_FALSE(is_plugin_path("momentum_com"));
}

}  // namespace
}  // namespace dob::plugin_test
