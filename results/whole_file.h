// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string>

#include "results/store.h"

namespace dob {

// What was asked for is sound, but a file cannot be written: no room, no permission, a limit.
class WriteError : public StoreError {
 public:
  using StoreError::StoreError;
};

// Writes beside the file and then takes its place: an older file stays until then, and what a link of either name
// points to is left alone. Throws WriteError.
void write_whole_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace dob
