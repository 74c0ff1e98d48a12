#include "results/whole_file.h"

#include <fstream>
#include <system_error>

#include <fmt/format.h>

namespace dob {

namespace fs = std::filesystem;

void write_whole_file(const fs::path& file, const std::string& bytes) {
  const fs::path part = file.string() + ".part";
  std::error_code error;
  fs::remove(part, error);  // a link too, rather than what it points to
  std::ofstream out(part, std::ios::binary);
  out << bytes;
  out.close();
  error.clear();
  if (out) fs::rename(part, file, error);
  if (out && !error) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  throw WriteError(fmt::format("{}: cannot be written{}", file.string(), error ? ": " + error.message() : ""));
}

}  // namespace dob
