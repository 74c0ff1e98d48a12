#include "results/database_guard.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <ios>
#include <iterator>
#include <sqlite3.h>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "results/plain_files.h"
#include "results/store.h"
#include "results/table_cells.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> kTables{
    "batch",  "scenario",         "observer", "cell",     "result",        "checkpoint", "shadow",
    "timing", "timing_histogram", "shard",    "campaign", "campaign_cell", "merged"};
constexpr std::string_view kView = "overview";

// Words with which a table's columns do more than hold values.
constexpr std::array<std::string_view, 7> kProgram{"AS",        "CHECK", "COLLATE", "DEFAULT",
                                                   "GENERATED", "USING", "VIRTUAL"};

bool exists(const fs::path& file) {
  std::error_code error;
  return fs::symlink_status(file, error).type() != fs::file_type::not_found;
}

// SQLite's file format: these eight bytes stand behind the name of a "super-journal" at a journal's end.
bool names_another_file(const fs::path& journal) {
  std::ifstream in(journal, std::ios::binary);
  in.seekg(-8, std::ios::end);
  std::string bytes(8, '\0');
  in.read(bytes.data(), 8);
  return in && bytes == "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
}

bool is_plain_table(std::string_view sql) {
  constexpr std::string_view kPunctuation = "_(), \t\r\n";
  std::string word;
  for (const char c : std::string(sql) + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      continue;
    }
    if (kPunctuation.find(c) == std::string_view::npos) return false;
    if (std::find(kProgram.begin(), kProgram.end(), word) != kProgram.end()) return false;
    word.clear();
  }
  return sql.starts_with("CREATE TABLE ");
}

bool is_known(const std::string& type, const std::string& name, const std::string& sql) {
  if (type == "view") return name == kView;
  if (type == "index") return sql.empty() && name.starts_with("sqlite_autoindex_");
  return type == "table" && std::find(kTables.begin(), kTables.end(), name) != kTables.end() && is_plain_table(sql);
}

}  // namespace

void require_harmless_files(const fs::path& file) {
  const std::string journal = file.string() + "-journal";
  require_plain_file(file);
  require_plain_file(journal);
  if (names_another_file(journal)) {
    throw StoreError(journal + ": names another file, which dobbench never does: it was not left by a dobbench");
  }
  for (const char* ending : {"-wal", "-shm"}) {
    if (exists(file.string() + ending)) {
      throw StoreError(file.string() + ending + ": a write-ahead log, which dobbench never makes");
    }
  }
}

void distrust(SQLite::Database& database, int attached) {
  sqlite3* handle = database.getHandle();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, attached);
  database.exec("PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0;");
}

void require_sound(SQLite::Database& database, const fs::path& file) {
  if (database.execAndGet("PRAGMA journal_mode").getString() != "delete") {
    throw StoreError(file.string() +
                     ": has a write-ahead log, which dobbench never makes; in sqlite3: PRAGMA journal_mode = DELETE");
  }
  SQLite::Statement object(database, "SELECT type, name, sql FROM sqlite_schema");
  while (object.executeStep()) {
    const std::string type = object.getColumn(0).getString(), name = object.getColumn(1).getString();
    if (is_known(type, name, object.getColumn(2).getString())) continue;
    throw StoreError(fmt::format("{}: holds the {} '{}', which no dobbench makes so; nothing of it is read",
                                 file.string(), on_one_line(type), on_one_line(name)));
  }
  SQLite::Statement check(database, "PRAGMA quick_check(1)");
  if (!check.executeStep()) throw StoreError(file.string() + ": cannot be checked");
  const std::string found = check.getColumn(0).getString();
  if (found != "ok")
    throw StoreError(fmt::format("{}: database disk image is malformed: {}", file.string(), on_one_line(found)));
}

}  // namespace dob
