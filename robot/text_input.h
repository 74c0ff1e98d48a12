// Text from outside: files that may be anything, and what messages may repeat of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace dob {

// A file that cannot be read as text. what() is the reason, without the file's name.
class TextFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The bytes of a regular file. Throws TextFileError: no such file, no right to read it, a directory, a pipe or a device
// (which might never end), more than `most` bytes.
std::string read_text_file(const std::filesystem::path& file, std::size_t most);

// The text as one line that a terminal shows as it is: control characters, line separators and bytes that are not UTF-8
// are written \xNN; of more than `longest` bytes (at least 16) the middle is left out.
std::string printable_line(std::string_view text, std::size_t longest);

}  // namespace dob
