// Where the shipped scenarios, gain sets and profiles are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dob {

// The environment variable DOBBENCH_SCENARIOS, else scenarios/ of what came with the program (scenarios/data_root.h).
std::filesystem::path data_directory();

std::filesystem::path defaults_file();  // config/defaults.toml
std::filesystem::path gains_file();     // config/gains.toml
std::filesystem::path tuning_file();    // config/tuning.toml
std::filesystem::path profile_file(const std::string& name);
std::filesystem::path scenario_file(const std::string& name);

// Names of the TOML files in the data directory, sorted; empty when it is not there.
std::vector<std::string> scenario_names();
std::vector<std::string> profile_names();

}  // namespace dob
