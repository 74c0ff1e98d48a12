#include "bench/shell_words.h"

#include <gtest/gtest.h>

namespace dob::shell_words_test {
namespace {

TEST(ShellWords, ALineSplitsIntoTheWordsThatItWasMadeOf) {
  const std::vector<std::string> words{"dobbench",           "run", "", "--set", "a=\"b c\"", "it's",
                                       "momentum:gains=1;2", "\\",  "'"};
  EXPECT_EQ(split_words(join_words(words)), words);
}

TEST(ShellWords, PlainWordsStayAsTheyAre) {
  EXPECT_EQ(join_words({"build/bin/dobbench", "--seeds", "1..3"}), "build/bin/dobbench --seeds 1..3");
  EXPECT_EQ(join_words({"a b"}), "'a b'");
  EXPECT_TRUE(split_words("").empty());
}

}  // namespace
}  // namespace dob::shell_words_test
