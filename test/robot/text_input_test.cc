#include "robot/text_input.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::text_input_test {
namespace {

TEST(PrintableLine, LeavesPrintableTextAsItIs) {
  EXPECT_EQ(printable_line("", 16), "");
  EXPECT_EQ(printable_line("Fu\u00df \u2014 \U0001F415 ~", 100), "Fu\u00df \u2014 \U0001F415 ~");
}

TEST(PrintableLine, WritesWhatATerminalWouldObeyAsNumbers) {
  EXPECT_EQ(printable_line("a\nb\tc\x1b[31m\x7f", 100), "a\\x0ab\\x09c\\x1b[31m\\x7f");
  EXPECT_EQ(printable_line(std::string("\0", 1), 100), "\\x00");
  EXPECT_EQ(printable_line("\u009b31m", 100), "\\xc2\\x9b31m");     // a control sequence of one character
  EXPECT_EQ(printable_line("a\u2028b", 100), "a\\xe2\\x80\\xa8b");  // a line separator
}

TEST(PrintableLine, WritesBytesThatAreNoUtf8AsNumbers) {
  EXPECT_EQ(printable_line("\xff", 100), "\\xff");
  EXPECT_EQ(printable_line("\xc3", 100), "\\xc3");                             // cut
  EXPECT_EQ(printable_line("\xc0\xaf", 100), "\\xc0\\xaf");                    // overlong
  EXPECT_EQ(printable_line("\xe0\x80\xaf", 100), "\\xe0\\x80\\xaf");           // overlong
  EXPECT_EQ(printable_line("\xed\xa0\x80", 100), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(printable_line("\xf4\x90\x80\x80", 100), "\\xf4\\x90\\x80\\x80");  // beyond the last code point
}

TEST(PrintableLine, LeavesOutTheMiddleOfALongTextAndCutsNoCharacter) {
  EXPECT_EQ(printable_line("0123456789abcdefghij", 20), "0123456789abcdefghij");
  EXPECT_EQ(printable_line("0123456789abcdefghijk", 20), "0123456 ... defghijk");
  for (std::size_t longest = 16; longest < 40; ++longest) {
    std::string dogs;
    while (dogs.size() < 100) dogs += "\U0001F415";
    const std::string line = printable_line(dogs, longest);
    EXPECT_LE(line.size(), longest);
    EXPECT_THAT(line, testing::Not(testing::HasSubstr("\\x")));
    EXPECT_LE(printable_line(std::string(1000, '\n'), longest).size(), longest);
  }
}

class TextFile : public testing::Test {
 protected:
  std::filesystem::path dir =
      std::filesystem::path(testing::TempDir()) / ("dob_text_file_" + std::to_string(::getpid()));
  void SetUp() override { std::filesystem::create_directories(dir); }
  void TearDown() override { std::filesystem::remove_all(dir); }

  static std::string error_of(const std::filesystem::path& file, std::size_t most = 100) {
    try {
      read_text_file(file, most);
    } catch (const TextFileError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(TextFile, IsReadToItsLastByteAndNotBeyondWhatIsAllowed) {
  std::ofstream(dir / "file", std::ios::binary) << std::string(50000, 'x') + std::string("\0end", 4);
  EXPECT_EQ(read_text_file(dir / "file", 50004), std::string(50000, 'x') + std::string("\0end", 4));
  EXPECT_EQ(error_of(dir / "file", 50003), "is larger than 50003 bytes");
  std::ofstream(dir / "empty");
  EXPECT_EQ(read_text_file(dir / "empty", 1), "");
}

TEST_F(TextFile, ThatIsNoneSaysWhatItIs) {
  EXPECT_EQ(error_of(dir), "is a directory");
  EXPECT_EQ(error_of(dir / "none"), "cannot be opened: No such file or directory");
  EXPECT_EQ(error_of("/dev/zero"), "is no regular file");
  EXPECT_EQ(error_of(dir / std::string(300, 'x')), "cannot be opened: File name too long");
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(error_of(dir / "pipe"), "is no regular file");  // opening it would wait for a writer
}

}  // namespace
}  // namespace dob::text_input_test
