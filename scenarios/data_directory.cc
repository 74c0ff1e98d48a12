#include "scenarios/data_directory.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "scenarios/data_root.h"

namespace dob {
namespace {

std::filesystem::path profile_directory() {
  return data_directory() / "config" / "profiles";
}

std::vector<std::string> toml_files(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& file : std::filesystem::directory_iterator(directory, missing)) {
    if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::filesystem::path data_directory() {
  const char* chosen = std::getenv("DOBBENCH_SCENARIOS");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  return chosen != nullptr && *chosen != '\0' ? chosen : data_root() / "scenarios";
}

std::filesystem::path defaults_file() {
  return data_directory() / "config" / "defaults.toml";
}
std::filesystem::path gains_file() {
  return data_directory() / "config" / "gains.toml";
}
std::filesystem::path tuning_file() {
  return data_directory() / "config" / "tuning.toml";
}
std::filesystem::path profile_file(const std::string& name) {
  return profile_directory() / (name + ".toml");
}
std::filesystem::path scenario_file(const std::string& name) {
  return data_directory() / (name + ".toml");
}

std::vector<std::string> scenario_names() {
  return toml_files(data_directory());
}
std::vector<std::string> profile_names() {
  return toml_files(profile_directory());
}

}  // namespace dob
