// Every number that a scenario may have: its range is stated on docs/ranges.md, and nothing beyond it is taken.
#include <cmath>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/scenarios/schema_walk.h"
#include "test/support/ranges_page.h"

namespace dob::ranges_test {
namespace {

using testing::StartsWith;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool of_numbers(const std::string& allowed) {
  return allowed.find("number") != std::string::npos && allowed.find("true") == std::string::npos;
}

// `disturbance.3.ramp_s` stands on the page as `disturbance.ramp_s`.
std::string without_indices(const std::string& key) {
  return std::regex_replace(key, std::regex("\\.[0-9]+\\."), ".");
}

// The number in the form that the key takes.
std::string as_value(const std::string& allowed, const std::string& number) {
  if (allowed.starts_with("three")) return fmt::format("[0, {}, 1]", number);
  if (allowed.starts_with("a list")) return fmt::format("[{0}, {0}]", number);
  return number;
}

// The first numbers that the words exclude.
std::vector<double> beyond(const std::string& allowed) {
  std::smatch ends;
  const std::regex words("(from|above) (-?[0-9.e+-]+) to (below )?(-?[0-9.e+-]+)");
  if (!std::regex_search(allowed, ends, words)) return {};
  const double min = std::stod(ends[2]), max = std::stod(ends[4]);
  const bool whole = allowed.starts_with("a whole");
  return {ends[1] == "above" ? min
          : whole            ? min - 1.0
                             : std::nextafter(min, -kInfinity),
          ends[3].matched ? max
          : whole         ? max + 1.0
                          : std::nextafter(max, kInfinity)};
}

TEST(Ranges, AreStatedForEveryNumberAndForNothingElse) {
  test::Ranges ranges;
  for (const auto& [path, allowed] : SchemaWalk().keys()) {
    if (!of_numbers(allowed)) continue;
    const auto [row, added] = ranges.emplace(without_indices(path), allowed);
    EXPECT_EQ(row->second, allowed) << path << ": another range than in another element";
  }
  EXPECT_EQ(test::ranges_on_page("Scenarios"), ranges) << test::to_page(ranges);
}

TEST(Ranges, RefuseTheFirstNumberBeyondEachEnd) {
  const SchemaWalk schema;
  int numbers = 0;
  for (const auto& [path, allowed] : schema.keys()) {
    if (!of_numbers(allowed)) continue;
    ++numbers;
    ASSERT_EQ(beyond(allowed).size(), 2U) << path << ": " << allowed;
    for (const double number : beyond(allowed)) {
      const std::string value = as_value(allowed, fmt::format("{}", number));
      EXPECT_THAT(schema.answer(path, value), StartsWith("--set " + path + ": " + value + "; allowed: ")) << allowed;
    }
  }
  EXPECT_GT(numbers, 80);  // it did find the schema
}

TEST(Ranges, RefuseWhatIsNoFiniteNumber) {
  const SchemaWalk schema;
  for (const auto& [path, allowed] : schema.keys()) {
    if (!of_numbers(allowed)) continue;
    for (const char* number :
         {"nan", "-nan", "inf", "-inf", "1e400", "-1e400", "99999999999999999999", "true", "{}", "[]"}) {
      EXPECT_THAT(schema.answer(path, as_value(allowed, number)), StartsWith("--set " + path + ": "));
    }
  }
}

TEST(Ranges, OfAPostureAreTheJointsLimits) {
  const SchemaWalk schema;
  EXPECT_EQ(schema.answer("robot.posture_rad.front_left_knee", "0.03"),
            "--set robot.posture_rad.front_left_knee: 0.03; allowed: a number from -2.618 to 0.02");
  EXPECT_THAT(schema.answer("robot.posture_rad.front_left_knee", "nan"), StartsWith("--set robot.posture_rad."));
}

TEST(Ranges, OfATorqueLimitEndAtTheWeakestJoint) {
  const ScratchFiles files;
  const std::string urdf =
      std::regex_replace(read_text(std::string(DOB_SOURCE_DIR) + "/robot/dogbot/dogbot.urdf"),
                         std::regex("effort=\"60\""), "effort=\"33.5\"", std::regex_constants::format_first_only);
  files.write("weak.urdf", urdf);
  const std::string robot = "[robot]\nurdf = \"weak.urdf\"\n" + [] {
    const std::string defaults = read_text(std::string(DOB_SOURCE_DIR) + "/scenarios/config/defaults.toml");
    const std::size_t posture = defaults.find("[robot.posture_rad]");
    return defaults.substr(posture, defaults.find("[gait]") - posture);
  }();
  const auto error = [&](const std::string& limit) -> std::string {
    try {
      load_scenarios({.name = files.write("mine.toml", kSmallest + limit + robot)});
    } catch (const InputError& refused) {
      return refused.what();
    }
    return "no error";
  };
  EXPECT_EQ(error("[controller]\ntorque_limit_Nm = 33.5\n"), "no error");
  EXPECT_THAT(error("[controller]\ntorque_limit_Nm = 33.6\n"),
              testing::EndsWith("controller.torque_limit_Nm: 33.6; allowed: a number above 0 to 33.5"));
  EXPECT_EQ(error(""), "no error");
}

TEST(Ranges, OfATrialAreInTimeAndInTicks) {
  const std::string day = "[[path]]\nduration_s = 90000\nspeed_m_s = 0.1\n";
  EXPECT_EQ(error_with(day), "no error");
  EXPECT_EQ(error_with(day + day),
            "mine.toml:2:3: path: an array of tables; "
            "allowed: segments of at most 100000 s in all, these are 180010");
  EXPECT_THAT(error_with(day + "[sim]\ndt_s = 1e-5\n"),
              testing::EndsWith("allowed: segments of at most 1000 s in all, these are 90010"));
}

}  // namespace
}  // namespace dob::ranges_test
