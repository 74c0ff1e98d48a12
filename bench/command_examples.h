// What each command is used for, as lines that run. They end its --help and stand in the manual page; a test runs them.
#pragma once

#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace dob {

struct CommandExample {
  std::string_view command;  // "run", "table", ...
  std::string_view line;     // what is typed; from above to below each finds what those before it have left
  std::string_view what;
};

const std::vector<CommandExample>& command_examples();

// Puts its examples below the help of every command, and the values that an option takes in words behind its name.
void finish_help(CLI::App& app);

}  // namespace dob
