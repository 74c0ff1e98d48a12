#include "results/whole_file.h"

#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "results/store.h"

namespace dob {

namespace fs = std::filesystem;

void write_whole_file(const fs::path& file, const std::string& bytes) {
  const fs::path part = file.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out << bytes;
  out.close();
  std::error_code error;
  if (out) fs::rename(part, file, error);
  if (out && !error) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  throw StoreError(fmt::format("{}: cannot be written{}", file.string(), error ? ": " + error.message() : ""));
}

}  // namespace dob
