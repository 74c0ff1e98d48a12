// DogBot's URDF as text, to be damaged, and files to load it from.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>

#include "robot/description.h"

namespace dob::test {

inline std::filesystem::path dogbot_urdf() {
  return std::filesystem::path(DOB_SOURCE_DIR) / "robot" / "dogbot" / "dogbot.urdf";
}

inline std::string dogbot_text() {
  std::ifstream in(dogbot_urdf(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Replaces the first occurrence of `from` after the first `after`; throws where there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to,
                            const std::string& after = "") {
  const std::size_t start = text.find(after);
  const std::size_t at = start == std::string::npos ? start : text.find(from, start);
  if (at == std::string::npos) {
    throw std::logic_error("test text has no '" + from + "' after '" + after + "'");
  }
  return text.replace(at, from.size(), to);
}

// A file of this test's own, removed at the end of its life.
class TemporaryUrdf {
 public:
  explicit TemporaryUrdf(const std::string& text, const std::string& suffix = "") : path_(unique_path(suffix)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryUrdf() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryUrdf(const TemporaryUrdf&) = delete;
  TemporaryUrdf& operator=(const TemporaryUrdf&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  static std::filesystem::path unique_path(const std::string& suffix) {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "_" + info->name() + suffix + std::to_string(getpid());
    for (char& c : name) {
      c = c == '/' ? '_' : c;
    }
    return std::filesystem::path(testing::TempDir()) / (name + ".urdf");
  }
  std::filesystem::path path_;
};

// The message of the error, or "" when the file loads.
inline std::string load_error(const std::filesystem::path& file) {
  try {
    load_robot(file, Forward::kMinusY);
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return "";
}

inline RobotDescription load_text(const std::string& text, Forward forward = Forward::kPlusX) {
  const TemporaryUrdf file(text);
  return load_robot(file.path(), forward);
}

}  // namespace dob::test
