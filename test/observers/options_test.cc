#include "observers/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::options_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using List = std::vector<double>;

TEST(ParseOptionValue, TellsTypesApart) {
  EXPECT_EQ(parse_option_value("true"), OptionValue(true));
  EXPECT_EQ(parse_option_value("false"), OptionValue(false));
  EXPECT_EQ(parse_option_value("-2.5e3"), OptionValue(-2500.0));
  EXPECT_EQ(parse_option_value("2.25;6.28;17.5"), OptionValue(List{2.25, 6.28, 17.5}));
  EXPECT_EQ(parse_option_value("exact"), OptionValue(std::string("exact")));
}

TEST(ParseOptionValue, TakesWhatIsNoNumberAsText) {
  for (const std::string text : {"", "1.0x", "1;", ";1", "1;;2", "1;two", "1,5", "True", " 1"}) {
    EXPECT_EQ(parse_option_value(text), OptionValue(text)) << '"' << text << '"';
  }
}

TEST(FormatOptionValue, IsTheInverseOfParsing) {
  for (const char* text : {"true", "false", "0.1", "-2500", "2.25;6.28;17.5"}) {
    EXPECT_EQ(format_option_value(parse_option_value(text)), text);
  }
  EXPECT_EQ(format_option_value(std::string("exact")), "\"exact\"");
}

TEST(OptionReader, ReadsWhatIsThere) {
  const ObserverOptions options{{"flag", true},           {"number", 2.0}, {"count", 3.0}, {"word", std::string("b")},
                                {"list", List{1.0, 2.0}}, {"one", 7.0}};
  OptionReader reader("x", options);
  EXPECT_TRUE(reader.flag("flag", false));
  EXPECT_EQ(reader.number("number", 0.0, {}), 2.0);
  EXPECT_EQ(reader.integer("count", 1, 1, 8), 3);
  EXPECT_EQ(reader.choice("word", {"a", "b"}), "b");
  EXPECT_THAT(reader.list("list", {}, {}, 2), ElementsAre(1.0, 2.0));
  EXPECT_THAT(reader.list("one", {}, {}, 2), ElementsAre(7.0));
  EXPECT_NO_THROW(reader.refuse_unknown());
}

TEST(OptionReader, FallsBackWhenAbsent) {
  const ObserverOptions options;
  OptionReader reader("x", options);
  EXPECT_TRUE(reader.flag("flag", true));
  EXPECT_EQ(reader.number("number", 4.0, {}), 4.0);
  EXPECT_EQ(reader.integer("count", 5, 1, 8), 5);
  EXPECT_EQ(reader.choice("word", {"a", "b"}), "a");
  EXPECT_THAT(reader.list("list", {6.0}, {}, 2), ElementsAre(6.0));
}

TEST(OptionReader, RefusesAnotherType) {
  const ObserverOptions options{{"k", std::string("oops")}, {"n", 1.0}};
  OptionReader reader("x", options);
  EXPECT_THROW(reader.flag("n", true), OptionError);
  EXPECT_THROW(reader.choice("n", {"a"}), OptionError);
  EXPECT_THROW(reader.number("k", 1.0, {}), OptionError);
  EXPECT_THROW(reader.integer("k", 1, 0, 2), OptionError);
  EXPECT_THROW(reader.list("k", {}, {}, 2), OptionError);
}

TEST(OptionReader, RefusesValuesOutOfRange) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const NumberRange range{.above = 0.0, .max = 2.0};
  const auto number = [&](double x) { return OptionReader("x", {{"k", x}}).number("k", 1.0, range); };
  const auto list = [&](const List& x) { return OptionReader("x", {{"k", x}}).list("k", {}, range, 2); };
  const auto integer = [&](double x) { return OptionReader("x", {{"k", x}}).integer("k", 1, 1, 8); };
  EXPECT_EQ(number(2.0), 2.0);
  for (const double bad : {0.0, -1.0, 2.0000001, kInf, kNan}) {
    EXPECT_THROW(number(bad), OptionError) << bad;
    EXPECT_THROW(list({1.0, bad}), OptionError) << bad;
  }
  EXPECT_THROW(list({}), OptionError);
  EXPECT_THROW(list({1.0, 1.0, 1.0}), OptionError);
  for (const double bad : {0.0, 9.0, 1.5, kInf, kNan}) EXPECT_THROW(integer(bad), OptionError) << bad;
  EXPECT_THROW(OptionReader("x", {{"k", kInf}}).number("k", 1.0, {}), OptionError);
}

TEST(OptionReader, ErrorsNameObserverKeyValueAndWhatIsAllowed) {
  const ObserverOptions options{{"gain_scale", -3.5}, {"coriolis", std::string("none")}, {"typo", List{1.0, 2.0}}};
  OptionReader reader("momentum", options);
  EXPECT_THAT([&] { reader.number("gain_scale", 1.0, {.above = 0.0, .max = 10.0}); },
              ThrowsMessage<OptionError>("observer momentum: option gain_scale = -3.5 is refused: "
                                         "allowed is a number in (0, 10]"));
  EXPECT_THAT(
      [&] {
        reader.choice("coriolis", {"exact", "neglected"});
      },
      ThrowsMessage<OptionError>(AllOf(HasSubstr("coriolis = \"none\""), HasSubstr("exact, neglected"))));
  EXPECT_THAT([&] { reader.refuse_unknown(); },
              ThrowsMessage<OptionError>(
                  AllOf(HasSubstr("momentum"), HasSubstr("typo = 1;2"), HasSubstr("there are: coriolis, gain_scale"))));
}

}  // namespace
}  // namespace dob::options_test
