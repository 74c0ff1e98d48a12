// What stands in a run directory may come from anybody. Nothing in it may lead out of it whoever reads or writes there:
// no links, no pipes, no devices, only files and directories. Private to results/ and bench/.
#pragma once

#include <filesystem>
#include <string_view>

namespace dob {

// Throw StoreError if something else than that stands there; nothing may.
void require_plain_file(const std::filesystem::path& file);
void require_plain_directory(const std::filesystem::path& dir);

// Makes it if need be. Throws StoreError as above, WriteError when it cannot be made.
void make_plain_directory(const std::filesystem::path& dir);

// Letters, digits, '_', '-' and '.', the first one not a '.': a name that stays in its directory.
bool is_plain_name(std::string_view name) noexcept;

}  // namespace dob
