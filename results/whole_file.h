// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace dob {

// Writes beside the file and then takes its place: an older file stays until then. Throws StoreError.
void write_whole_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace dob
