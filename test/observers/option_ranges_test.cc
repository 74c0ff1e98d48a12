// Every number among the observers' options: its range is stated on docs/ranges.md, and nothing beyond it is taken.
#include <cmath>
#include <limits>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/factory.h"
#include "test/support/ranges_page.h"

namespace dob::option_ranges_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string answer(std::string_view observer, const std::string& key, const OptionValue& value) {
  try {
    make_observer(observer, {{key, value}}, 1e-3);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "no error";
}

std::string after(const std::string& text, const std::string& mark) {
  const std::size_t at = text.find(mark);
  return at == std::string::npos ? "" : text.substr(at + mark.size());
}

struct NumberOption {
  std::string_view observer;
  std::string key, allowed;
};

// As the observers themselves say: an unknown option is answered with the known ones, a text with what is allowed.
std::vector<NumberOption> number_options() {
  std::vector<NumberOption> options;
  for (const ObserverInfo& info : built_in_observers()) {
    if (info.name == "momentum_com") continue;  // the options of its two observers
    std::string list = after(answer(info.name, "zzz", 1.0), "there are: ") + ", ";
    for (std::size_t comma = 0; (comma = list.find(", ")) != std::string::npos; list.erase(0, comma + 2)) {
      const std::string key = list.substr(0, comma);
      const std::string allowed = after(answer(info.name, key, std::string("zzz")), "is refused: ");
      if (std::regex_search(allowed, std::regex("^allowed (is|are) .*numbers?")))
        options.push_back({info.name, key, allowed});
    }
  }
  return options;
}

std::string place(const NumberOption& option) {
  return std::string(option.observer) + "." + option.key;
}

// The first numbers that the words exclude.
std::vector<double> beyond(const std::string& allowed) {
  std::smatch ends;
  if (std::regex_search(allowed, ends, std::regex("a whole number from ([0-9]+) to ([0-9]+)")))
    return {std::stod(ends[1]) - 1.0, std::stod(ends[2]) + 1.0, std::stod(ends[1]) + 0.5};
  if (std::regex_search(allowed, ends, std::regex("in \\((\\S+), (\\S+)\\]")))
    return {std::stod(ends[1]), std::nextafter(std::stod(ends[2]), kInfinity)};
  if (std::regex_search(allowed, ends, std::regex("from (\\S+) to (\\S+)")))
    return {std::nextafter(std::stod(ends[1]), -kInfinity), std::nextafter(std::stod(ends[2]), kInfinity)};
  return {};
}

TEST(ObserverOptionRanges, AreStatedForEveryNumberAndForNothingElse) {
  test::Ranges ranges;
  for (const NumberOption& option : number_options())
    ranges[place(option)] = std::regex_replace(option.allowed, std::regex("^allowed (is|are) "), "");
  EXPECT_EQ(test::ranges_on_page("Observers"), ranges) << test::to_page(ranges);
}

TEST(ObserverOptionRanges, HaveTwoEndsAndRefuseTheFirstNumberBeyondEach) {
  const std::vector<NumberOption> options = number_options();
  EXPECT_GT(options.size(), 15U);  // it did find them
  for (const NumberOption& option : options) {
    const std::vector<double> numbers = beyond(option.allowed);
    EXPECT_GE(numbers.size(), 2U) << place(option) << ": " << option.allowed;
    for (const double number : numbers)
      EXPECT_THAT(answer(option.observer, option.key, number), testing::HasSubstr(option.allowed)) << place(option);
  }
}

TEST(ObserverOptionRanges, RefuseWhatIsNoFiniteNumber) {
  for (const NumberOption& option : number_options()) {
    for (const OptionValue& value :
         {OptionValue(kNan), OptionValue(kInfinity), OptionValue(-kInfinity), OptionValue(true),
          OptionValue(std::vector<double>{1.0, kNan}), OptionValue(std::vector<double>{})})
      EXPECT_THAT(answer(option.observer, option.key, value), testing::HasSubstr(option.allowed)) << place(option);
  }
}

TEST(ObserverOptionRanges, OfTheTickAreFiniteAndPositive) {
  for (const ObserverInfo& info : built_in_observers()) {
    if (!info.estimates_legs && !info.estimates_com) continue;
    if (info.oracle) continue;
    for (const double dt : {0.0, -1e-3, kNan, kInfinity})
      EXPECT_THROW(make_observer(info.name, {}, dt), OptionError) << info.name << ' ' << dt;
  }
}

}  // namespace
}  // namespace dob::option_ranges_test
