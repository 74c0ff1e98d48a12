// docs/ranges.md as data: what the page states is compared with what the program says.
#pragma once

#include <fstream>
#include <map>
#include <string>

namespace dob::test {

using Ranges = std::map<std::string, std::string>;  // by key, what is allowed

// The rows | `key` | what is allowed | below the heading "## SECTION".
inline Ranges ranges_on_page(const std::string& section) {
  std::ifstream page(std::string(DOB_SOURCE_DIR) + "/docs/ranges.md");
  Ranges ranges;
  bool here = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) here = line == "## " + section;
    if (!here || !line.starts_with("| `")) continue;
    const std::size_t key_end = line.find("` | ");
    const std::size_t end = line.rfind(" |");
    if (key_end != std::string::npos && end > key_end + 4)
      ranges[line.substr(3, key_end - 3)] = line.substr(key_end + 4, end - key_end - 4);
  }
  return ranges;
}

// As it would stand on the page.
inline std::string to_page(const Ranges& ranges) {
  std::string text;
  for (const auto& [key, allowed] : ranges) text += "| `" + key + "` | " + allowed + " |\n";
  return text;
}

}  // namespace dob::test
