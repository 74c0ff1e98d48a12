#include "results/store.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "results/store_json.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error = errno) {
  throw StoreError(fmt::format("{}: {}: {}", path.string(), what, std::generic_category().message(error)));
}

// All of `text` by one write(2); on failure what was written of it is taken back.
void append_text(int fd, const fs::path& path, const std::string& text) {
  const off_t before = ::lseek(fd, 0, SEEK_END);
  const ssize_t written = ::write(fd, text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size())) return;
  const int error = written < 0 ? errno : ENOSPC;
  if (before < 0 || ::ftruncate(fd, before) != 0) fail(path, "cannot take back an incomplete line", error);
  fail(path, "cannot write", error);
}

int open_for_append(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (fd < 0) fail(path, "cannot open for writing");
  return fd;
}

// Removes what follows the last line end.
void remove_torn_line(int fd, const fs::path& path) {
  off_t size = ::lseek(fd, 0, SEEK_END);
  for (char last = 0; size > 0; --size) {
    if (::pread(fd, &last, 1, size - 1) != 1) fail(path, "cannot read");
    if (last == '\n') break;
  }
  if (::ftruncate(fd, size) != 0) fail(path, "cannot remove an incomplete last line");
}

// Complete or absent, never half written.
void write_file(const fs::path& path, const std::string& text) {
  const fs::path part = path.string() + ".part";
  const int fd = open_for_append(part);
  try {
    append_text(fd, part, text);
  } catch (const StoreError&) {
    ::close(fd);
    throw;
  }
  ::close(fd);
  std::error_code error;
  fs::rename(part, path, error);
  if (error) fail(path, "cannot write", error.value());
}

void check_names(const std::vector<ResolvedScenario>& scenarios) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  for (const ResolvedScenario& scenario : scenarios) {
    const std::string& name = scenario.name;
    if (name.empty() || name.front() == '.' || name.find_first_not_of(kAllowed) != std::string::npos) {
      throw StoreError(fmt::format(
          "scenarios/{}.toml: a scenario's name consists of letters, digits, '_', '-' and '.', not first", name));
    }
    const auto same = [&](const ResolvedScenario& other) { return other.name == name; };
    if (std::count_if(scenarios.begin(), scenarios.end(), same) > 1) {
      throw StoreError(fmt::format("scenarios/{}.toml: two scenarios of this name", name));
    }
  }
}

void make_directories(const fs::path& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) fail(dir, "cannot create the directory", error.value());
}

// run.json comes last: a directory that has it is complete.
void fill(const fs::path& dir, const RunInfo& info, const std::vector<ResolvedScenario>& scenarios) {
  make_directories(dir / "scenarios");
  for (const ResolvedScenario& scenario : scenarios) {
    write_file(dir / "scenarios" / (scenario.name + ".toml"), scenario.toml);
  }
  write_file(dir / "run.json", to_json(info).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

// The number that a directory's name is, 0 for any other name.
int run_number(const std::string& name) {
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc{} && end == name.data() + name.size() ? std::max(number, 0) : 0;
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

}  // namespace

RunStore RunStore::create(const fs::path& dir, const RunInfo& info, const std::vector<ResolvedScenario>& scenarios) {
  check_names(scenarios);
  std::error_code error;
  if (fs::exists(dir / "run.json", error)) throw StoreError(dir.string() + ": holds a run already");
  make_directories(dir);
  const bool empty = fs::is_empty(dir, error);
  if (error) fail(dir, "cannot read the directory", error.value());
  if (!empty) throw StoreError(dir.string() + ": exists, is not empty, and is not a run directory");
  fill(dir, info, scenarios);
  return RunStore(dir);
}

RunStore RunStore::create_numbered(const fs::path& root, const RunInfo& info,
                                   const std::vector<ResolvedScenario>& scenarios) {
  check_names(scenarios);
  const fs::path dir = make_numbered(root);
  fill(dir, info, scenarios);
  return RunStore(dir);
}

RunStore RunStore::open(const fs::path& dir) {
  std::error_code error;
  if (!fs::exists(dir / "run.json", error)) {
    throw StoreError(dir.string() + ": is not a run directory (it has no run.json)");
  }
  return RunStore(dir);
}

RunStore::RunStore(fs::path dir) : dir_(std::move(dir)) {
  cells_fd_ = open_for_append(dir_ / "cells.jsonl");
  try {
    timing_fd_ = open_for_append(dir_ / "timing.jsonl");
    remove_torn_line(cells_fd_, dir_ / "cells.jsonl");
    remove_torn_line(timing_fd_, dir_ / "timing.jsonl");
  } catch (const StoreError&) {
    ::close(cells_fd_);
    if (timing_fd_ >= 0) ::close(timing_fd_);
    throw;
  }
}

RunStore::~RunStore() {
  ::close(cells_fd_);
  ::close(timing_fd_);
}

void RunStore::append(const CellResult& cell) {
  const std::lock_guard lock(mutex_);
  // The cell last: once it stands there, it is finished.
  append_text(timing_fd_, dir_ / "timing.jsonl", one_line(timing_to_json(cell)) + "\n");
  append_text(cells_fd_, dir_ / "cells.jsonl", one_line(to_json(cell)) + "\n");
}

}  // namespace dob
