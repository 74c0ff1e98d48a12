// What can stand next on the command line: the words that a shell offers. Read from the command line's own description,
// so that it knows every option there is.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace dob {

// Where names come from that the command line's description does not hold: of an option ("--observer") or of a
// positional argument ("scenario"), in every command. Called only when such a word is to be completed.
using NameSources = std::map<std::string, std::function<std::vector<std::string>()>>;

// Of `words`, what stands behind the program's name, the last is the beginning of the one to complete; the shell may
// hand over `=` as a word of its own. Sorted; empty where a file is meant, or nothing fits.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words,
                                     const NameSources& names);

// The values that an option takes, if it takes only some: of CLI::IsMember and CLI::CheckedTransformer.
std::vector<std::string> choices_of(const CLI::Option& option);

}  // namespace dob
