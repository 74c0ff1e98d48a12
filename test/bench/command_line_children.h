// The program as a child process that a test may stop while it is at work.
#pragma once

#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "results/store.h"
#include "test/bench/command_line.h"

namespace dob::test {

class CommandLineChildren : public CommandLine {
 protected:
  // Starts dobbench; what it prints is dropped.
  pid_t start(const std::string& arguments) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const std::string command = "cd '" + dir.string() + "' && exec '" DOBBENCH "' " + arguments + " >/dev/null 2>&1";
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    return child;
  }

  // Its exit code, 128 + n for signal n.
  static int wait_for(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  // State hashes of the cells of a run.
  std::map<CellKey, std::uint64_t> hashes(const std::string& run) const {
    std::map<CellKey, std::uint64_t> hash;
    for (const CellResult& cell : read_cells(dir / run)) hash[cell.key] = cell.state_hash;
    return hash;
  }

  // Until it is so, a minute at most; whether it is.
  static bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 6000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
};

}  // namespace dob::test
