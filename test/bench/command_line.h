// The program as a user starts it, in a directory of its own.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace dob::test {

struct Answer {
  int exit_code = -1;
  std::string out, err;
};

inline std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class CommandLine : public ::testing::Test {
 protected:
  std::filesystem::path dir = std::filesystem::temp_directory_path() / ("dobbench_cli_" + std::to_string(::getpid()));

  void SetUp() override { std::filesystem::create_directories(dir); }
  void TearDown() override { std::filesystem::remove_all(dir); }

  Answer dobbench(const std::string& arguments) const {
    const std::filesystem::path err = dir / "stderr";
    const std::string command =
        "cd '" + dir.string() + "' && '" DOBBENCH "' " + arguments + " 2>'" + err.string() + "'";
    Answer answer;
    FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
      answer.out.append(buffer.data(), n);
    }
    answer.exit_code = WEXITSTATUS(::pclose(pipe));
    answer.err = read(err);
    std::filesystem::remove(err);
    return answer;
  }

  // Bad input: exit code 2, one line that holds every given part, nothing on stdout, nothing written.
  void expect_refused(const std::string& arguments, const std::vector<std::string>& parts) const {
    const Answer answer = dobbench(arguments);
    EXPECT_EQ(answer.exit_code, 2) << arguments;
    EXPECT_EQ(answer.out, "") << arguments;
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    for (const std::string& part : parts)
      EXPECT_NE(answer.err.find(part), std::string::npos) << part << ": " << answer.err;
    EXPECT_FALSE(std::filesystem::exists(dir / "dobbench-results")) << arguments;
  }
};

}  // namespace dob::test
