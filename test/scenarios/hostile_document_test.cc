// Files and options that were made to break a reader: one printable line of bounded length, never a crash or a hang.
#include <algorithm>
#include <string>
#include <sys/stat.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/text_input.h"
#include "scenarios/document.h"
#include "scenarios/document_limits.h"
#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::hostile_document_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

// What parsing the text says, without the directory.
std::string error_of(const std::string& text) {
  const ScratchFiles files;
  try {
    parse_file(files.write("mine.toml", text));
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find("mine.toml"));
  }
  return "no error";
}

std::string error_set(const std::string& text) {
  try {
    load_scenarios({.name = "undisturbed", .overrides = {text}});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(HostileDocument, IsNotNestedDeeperThanAnyFileNeeds) {
  EXPECT_EQ(error_of("a = " + repeated("[", 32) + repeated("]", 32)), "no error");
  EXPECT_EQ(error_of("a = " + repeated("[", 33) + repeated("]", 33)),
            "mine.toml:1:37: nested deeper than 32 levels; no file needs that");
  EXPECT_THAT(error_of("\n\na = " + repeated("[", 1000000)), HasSubstr("mine.toml:3:37: nested deeper"));
  EXPECT_THAT(error_of("a = " + repeated("{a = ", 100000)), HasSubstr("nested deeper"));
}

TEST(HostileDocument, HasNoKeysOfManyParts) {
  EXPECT_EQ(error_of(repeated("a.", 15) + "a = 1.5"), "no error");
  EXPECT_EQ(error_of(repeated("a.", 16) + "a = 1"), "mine.toml:1:32: a key of more than 16 parts; no file needs that");
  EXPECT_THAT(error_of("[" + repeated("a.", 1000000) + "a]"), HasSubstr("a key of more than 16 parts"));
  EXPECT_THAT(error_of("x = {" + repeated("a . ", 50) + "a = 1}"), HasSubstr("a key of more than 16 parts"));
  EXPECT_THAT(error_of(repeated("\"a\".", 50) + "a = 1"), HasSubstr("a key of more than 16 parts"));
}

TEST(HostileDocument, MayHaveBracketsDotsAndQuotesInTextsAndComments) {
  const std::string many = repeated("[.{", 50);
  for (const std::string& text : {"# " + many, "a = \"" + many + "\"", "a = '" + many + "'", "a = \"\\\"" + many + "\"",
                                  "a = \"\"\"" + many + "\"\n\"\" " + many + "\"\"\"\"\"", "a = '''" + many + "''\\'''",
                                  "a = \"\" # " + many, "a = [0.1, 0.2" + repeated(", 0.3", 50) + "]"}) {
    EXPECT_EQ(error_of(text), "no error") << text;
  }
  // A text ends where the library thinks so, and what comes behind it counts.
  const std::string deep = ", " + repeated("[", 40);
  for (const std::string text : {"'\\'", "\"\\\\\"", "\"\"", "''", "\"\"\"\"\"\"", "\"\"\"a\"\"\"\"\"", "'''a'''''"}) {
    EXPECT_THAT(error_of("a = [" + text + deep), HasSubstr("nested deeper")) << text;
  }
}

TEST(HostileDocument, IsOfBoundedWidth) {
  std::string keys;
  for (int i = 0; i < 1001; ++i) keys += fmt::format("k{} = 1\n", i);
  EXPECT_EQ(error_of(keys), "mine.toml:1:1: 1001 keys in one table; at most 1000 are allowed");
  EXPECT_EQ(error_of("a = [" + repeated("1,", 10001) + "]"),
            "mine.toml:1:1: 10001 elements in one list; at most 10000 are allowed");
  EXPECT_EQ(error_of(std::string(201, 'k') + " = 1"), "mine.toml:1:1: 201 bytes in one key; at most 200 are allowed");
  EXPECT_EQ(error_of("a = \"" + std::string(1001, 't') + "\""),
            "mine.toml:1:1: 1001 bytes in one text; at most 1000 are allowed");
  EXPECT_EQ(error_of(std::string(kMostBytes, ' ') + "#"),
            "mine.toml: is larger than 4194304 bytes; a TOML file is needed");
}

TEST(HostileDocument, OverridesAreBoundedAlike) {
  EXPECT_THAT(error_set(repeated("a.", 50000) + "a=1"), HasSubstr("a key of more than 16 parts"));
  EXPECT_THAT(error_set("a=" + repeated("[", 50000)), HasSubstr("nested deeper than 32 levels"));
  EXPECT_THAT(error_set("a={" + repeated("a.", 50000) + "a=1}"), HasSubstr("a key of more than 16 parts"));
  EXPECT_THAT(error_set(std::string(100000, 'k') + "=1"), HasSubstr("a part of the key is longer than 200 bytes"));
}

TEST(HostileDocument, TextsOfAScenarioAreOnePrintableLine) {
  const auto with_summary = [](const std::string& text) {
    const ScratchFiles files;
    try {
      load_scenarios({.name = files.write("mine.toml", "summary = " + text + "\n" + kSmallest.substr(14))});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(with_summary("\"Fu\u00df\""), "no error");
  EXPECT_THAT(with_summary("\"a\\nb\""), EndsWith("summary: \"a\\u000ab\"; allowed: one line of printable text"));
  EXPECT_THAT(with_summary("\"\\u001b[31m\""), EndsWith("allowed: one line of printable text"));
  EXPECT_THAT(with_summary("\"\\u009b31m\""), EndsWith("\"\\xc2\\x9b31m\"; allowed: one line of printable text"));
}

TEST(HostileDocument, ErrorsAreOnePrintableLineOfBoundedLength) {
  const std::string long_text = "\"" + std::string(900, 'x') + "\"";
  for (const std::string& text :
       {"gait.stance_s=" + long_text, "gait.stance_s=[" + repeated("1,", 9000) + "]", std::string("a\x1b[31m=1"),
        std::string("a\nb=1"), std::string("gait.stance_s=\"\xff\""), std::string("\xff=1"), std::string(50000, '\n'),
        "gait." + std::string(200, '\x01') + "=1"}) {
    const std::string error = error_set(text);
    EXPECT_THAT(error, testing::StartsWith("--set"));
    EXPECT_LE(error.size(), kLongestMessage);
    EXPECT_EQ(error, printable_line(error, 2 * kLongestMessage));
  }
  EXPECT_THAT(error_set("gait.stance_s=" + long_text), HasSubstr(" ... "));
  EXPECT_THAT(error_set("gait.stance_s=" + long_text), EndsWith("allowed: a number above 0 to 10"));
}

TEST(HostileDocument, NamesAreThoseOfFiles) {
  const std::string name(101, 'n');
  EXPECT_THAT(error_with("[variant." + name + "]\n"), EndsWith("letters, digits, _ and -, at most 100 of them"));
  EXPECT_THAT(error_with("[variant." + name.substr(1) + "]\n"), "no error");
}

TEST(HostileDocument, BasesDoNotMultiplyWithoutEnd) {
  const ScratchFiles files;
  const auto error = [&](const std::string& name) -> std::string {
    try {
      load_scenarios({.name = (files.directory() / name).string()});
    } catch (const InputError& refused) {
      return refused.what();
    }
    return "no error";
  };
  files.write("f0.toml", kSmallest);
  for (int i = 1; i < 40; ++i)
    files.write(fmt::format("f{}.toml", i), fmt::format("base = [\"f{0}.toml\", \"f{0}.toml\"]\n", i - 1));
  EXPECT_EQ(error("f6.toml"), "no error");
  EXPECT_THAT(error("f7.toml"), EndsWith("f1.toml:1:9: base: more than 6 files upon one another"));
  EXPECT_THAT(error("f39.toml"), EndsWith("base: more than 6 files upon one another"));
  files.write("wide.toml", "base = [" + repeated("\"f0.toml\", ", 5) + "]\n");
  EXPECT_THAT(error("wide.toml"), EndsWith("wide.toml:1:1: base: 5 of them; at most 4 are allowed"));
}

TEST(HostileDocument, PipesAndDevicesAreNotOpened) {
  EXPECT_THAT(error_with("[robot]\nurdf = \"/dev/zero\"\n"), HasSubstr("is no regular file"));
  const ScratchFiles files;
  const std::string pipe = (files.directory() / "pipe.toml").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);  // opening it would wait for a writer
  EXPECT_THROW(load_scenarios({.name = pipe}), InputError);
  EXPECT_THROW(load_scenarios({.name = files.write("mine.toml", "base = \"pipe.toml\"\n" + kSmallest)}), InputError);
}

TEST(HostileDocument, MinusZeroIsWrittenAsItself) {
  const ScratchFiles files;
  const Node document = parse_file(files.write("mine.toml", "a = -0.0\n"));
  EXPECT_EQ(to_toml(document), "a = -0.0\n");
  EXPECT_EQ(to_toml(parse_file(files.write("mine.toml", to_toml(document)))), "a = -0.0\n");
}

}  // namespace
}  // namespace dob::hostile_document_test
