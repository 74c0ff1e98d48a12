#include "results/run_directory.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <sys/stat.h>
#include <system_error>

#include <fmt/format.h>

#include "results/plain_files.h"
#include "results/run_database.h"
#include "results/run_lock.h"
#include "results/run_plan.h"
#include "results/whole_file.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error = errno) {
  throw StoreError(fmt::format("{}: {}: {}", path.string(), what, std::generic_category().message(error)));
}

void make_directories(const fs::path& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) fail(dir, "cannot create the directory", error.value());
}

// The number that a directory's name is, 0 for any other name.
int run_number(const std::string& name) {
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc{} && end == name.data() + name.size() ? std::max(number, 0) : 0;
}

}  // namespace

void check_names(const std::vector<ResolvedScenario>& scenarios) {
  for (const ResolvedScenario& scenario : scenarios) {
    const std::string& name = scenario.name;
    if (!is_plain_name(name)) {
      throw StoreError(fmt::format(
          "scenarios/{}.toml: a scenario's name consists of letters, digits, '_', '-' and '.', not first", name));
    }
    const auto same = [&](const ResolvedScenario& other) { return other.name == name; };
    if (std::count_if(scenarios.begin(), scenarios.end(), same) > 1) {
      throw StoreError(fmt::format("scenarios/{}.toml: two scenarios of this name", name));
    }
  }
}

void prepare_directory(const fs::path& dir) {
  if (is_run_directory(dir)) throw StoreError(dir.string() + ": holds a run already");
  make_directories(dir);
  std::error_code error;
  const bool empty = fs::is_empty(dir, error);
  if (error) fail(dir, "cannot read the directory", error.value());
  if (!empty && !fs::exists(dir / kLockFile, error)) {
    throw StoreError(dir.string() + ": exists, is not empty, and is not a run directory");
  }
}

fs::path make_numbered(const fs::path& root) {
  make_directories(root);
  int number = 0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(root, error)) {
    number = std::max(number, run_number(entry.path().filename().string()));
  }
  if (error) fail(root, "cannot read the directory", error.value());
  while (true) {
    fs::path dir = root / fmt::format("{:04}", ++number);
    if (::mkdir(dir.c_str(), 0777) == 0) return dir;  // atomic: the number belongs to this process
    if (errno != EEXIST) fail(dir, "cannot create the directory");
  }
}

void fill_directory(const fs::path& dir, const RunInfo& info, const std::vector<ResolvedScenario>& scenarios) {
  const RunLock lock(dir);
  std::error_code error;
  const fs::path unfinished = dir / kUnfinished;
  fs::remove(unfinished, error);
  for (const char* ending : {"-journal", "-wal", "-shm"}) {  // of a making that was cut short; a new database has none
    fs::remove(unfinished.string() + ending, error);
    fs::remove((dir / kDatabaseFile).string() + ending, error);
  }
  fs::remove_all(dir / "scenarios", error);
  make_plain_directory(dir / "scenarios");
  for (const ResolvedScenario& scenario : scenarios) {
    write_whole_file(dir / "scenarios" / (scenario.name + ".toml"), scenario.toml);
  }
  try {
    SQLite::Database database = create_database(unfinished);
    SQLite::Transaction transaction(database);
    write_plan(database, info, scenarios);
    transaction.commit();
  } catch (const SQLite::Exception& sqlite) {
    throw WriteError(fmt::format("{}: {}", unfinished.string(), sqlite.what()));
  }
  const fs::path file = dir / kDatabaseFile;
  fs::rename(unfinished, file, error);
  if (error) throw WriteError(fmt::format("{}: cannot be written: {}", file.string(), error.message()));
}

}  // namespace dob
