// Every number of a description has a range, and the page that states them is true.
#include "robot/urdf_ranges.h"

#include <cmath>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/robot/urdf_text.h"
#include "test/support/ranges_page.h"

namespace dob::urdf_ranges_test {
namespace {

using test::dogbot_text;
using test::load_error;
using test::TemporaryUrdf;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// DogBot with another first number in the first such attribute; an rpy, which it has nowhere, in the first origin.
std::string with_number(const UrdfRange& range, const std::string& number) {
  const std::string element(range.element);
  const std::string attribute(range.attribute);
  if (attribute == "rpy") return test::replaced(dogbot_text(), "<origin", "<origin rpy=\"" + number + " 0 0\"");
  const std::regex first("(<" + element + " [^>]*" + attribute + "=\")[^\" ]+");
  return std::regex_replace(dogbot_text(), first, "$01" + number, std::regex_constants::format_first_only);
}

std::string error_with(const UrdfRange& range, const std::string& number) {
  const TemporaryUrdf file(with_number(range, number));
  return load_error(file.path());
}

TEST(UrdfRanges, RefuseTheFirstNumberBeyondEachEndWithItsPlace) {
  for (const UrdfRange& range : kUrdfRanges) {
    const double below = range.without_min ? range.min : std::nextafter(range.min, -kInfinity);
    for (const double number : {below, std::nextafter(range.max, kInfinity)}) {
      EXPECT_THAT(error_with(range, fmt::format("{}", number)),
                  testing::AllOf(testing::ContainsRegex("line [0-9]+, column [0-9]+: (link|joint) '"),
                                 testing::HasSubstr(fmt::format(
                                     "{} {} is {}; allowed: {} {} to {} {}", range.element, range.attribute, number,
                                     range.without_min ? "above" : "from", range.min, range.max, range.unit))));
    }
  }
}

TEST(UrdfRanges, RefuseWhatIsNoFiniteNumber) {
  for (const UrdfRange& range : kUrdfRanges) {
    for (const char* number : {"nan", "-nan", "inf", "-inf", "1e400", "-1e400", "0x10", "1,5", "many"})
      EXPECT_THAT(error_with(range, number),
                  testing::AllOf(testing::HasSubstr(": line "),
                                 testing::HasSubstr(
                                     fmt::format("{} {} is {}; allowed: ", range.element, range.attribute, number))));
  }
}

TEST(UrdfRanges, TakeTheEndsThatTheyName) {
  for (const UrdfRange& range : kUrdfRanges) {
    for (const double number : {range.min, range.max}) {
      if (number == range.min && range.without_min) continue;
      EXPECT_THAT(error_with(range, fmt::format("{}", number)), testing::Not(testing::HasSubstr("allowed:")));
    }
  }
}

TEST(UrdfRanges, DoNotApplyToLimitsThatNobodyReads) {
  const std::string text = test::replaced(
      dogbot_text(), "type=\"fixed\">", "type=\"fixed\"><limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>");
  EXPECT_EQ(load_error(TemporaryUrdf(text).path()), "");
}

TEST(UrdfRanges, AreWhatThePageSays) {
  test::Ranges ranges;
  for (const UrdfRange& range : kUrdfRanges) {
    ranges[fmt::format("{} {}", range.element, range.attribute)] =
        fmt::format("{} {} to {} {}", range.without_min ? "above" : "from", range.min, range.max, range.unit);
  }
  EXPECT_EQ(test::ranges_on_page("Robot descriptions"), ranges) << test::to_page(ranges);
}

}  // namespace
}  // namespace dob::urdf_ranges_test
