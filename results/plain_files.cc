#include "results/plain_files.h"

#include <string>
#include <system_error>

#include <fmt/format.h>

#include "results/whole_file.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

std::string describe(fs::file_type type) {
  switch (type) {
    case fs::file_type::symlink:
      return "a symbolic link";
    case fs::file_type::directory:
      return "a directory";
    case fs::file_type::regular:
      return "a file";
    default:
      return "a special file";
  }
}

void require(const fs::path& path, fs::file_type allowed) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == allowed || type == fs::file_type::not_found) return;
  if (type == fs::file_type::none) throw StoreError(fmt::format("{}: {}", path.string(), error.message()));
  throw StoreError(fmt::format("{}: is {}; allowed in a run directory: {} of its own", path.string(), describe(type),
                               describe(allowed)));
}

}  // namespace

void require_plain_file(const fs::path& file) {
  require(file, fs::file_type::regular);
}

void require_plain_directory(const fs::path& dir) {
  require(dir, fs::file_type::directory);
}

void make_plain_directory(const fs::path& dir) {
  require_plain_directory(dir);
  std::error_code error;
  fs::create_directory(dir, error);
  if (error) throw WriteError(fmt::format("{}: cannot create the directory: {}", dir.string(), error.message()));
}

bool is_plain_name(std::string_view name) noexcept {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return !name.empty() && name.front() != '.' && name.find_first_not_of(kAllowed) == std::string_view::npos;
}

}  // namespace dob
