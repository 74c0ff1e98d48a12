// Files of one test, in a directory of its own that goes away with it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "scenarios/loader.h"

namespace dob {

class ScratchFiles {
 public:
  ScratchFiles() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    directory_ =
        std::filesystem::path(testing::TempDir()) / (std::string(test->test_suite_name()) + "." + test->name());
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  ~ScratchFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  ScratchFiles(const ScratchFiles&) = delete;
  ScratchFiles& operator=(const ScratchFiles&) = delete;

  const std::filesystem::path& directory() const { return directory_; }

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = directory_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

 private:
  std::filesystem::path directory_;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The smallest scenario; what a test appends begins in line 5.
inline const std::string kSmallest = "summary = \"s\"\n[[path]]\nduration_s = 10.0\nspeed_m_s = 0.12\n";

// What loading the smallest scenario with this text behind it says, without the directory; "no error" where it loads.
inline std::string error_with(const std::string& appended) {
  const ScratchFiles files;
  try {
    load_scenarios({.name = files.write("mine.toml", kSmallest + appended)});
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string directory = files.directory().string() + "/";
    const std::size_t at = message.find(directory);
    return at == std::string::npos ? message : message.erase(at, directory.size());
  }
  return "no error";
}

}  // namespace dob
