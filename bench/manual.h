// The manual page, dobbench(1), written from the command line's own description.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace dob {

// In the language of man(7). `version`: as in the page's footer, "dobbench 0.1.0".
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace dob
