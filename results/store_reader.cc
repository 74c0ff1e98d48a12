#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "results/store.h"
#include "results/store_json.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

std::ifstream open_file(const fs::path& path) {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || fs::is_directory(path, error)) throw StoreError(path.string() + ": cannot be read");
  return in;
}

RunInfo read_info(const fs::path& dir) {
  std::error_code error;
  if (!fs::is_directory(dir, error)) throw StoreError(dir.string() + ": no such directory");
  const fs::path path = dir / "run.json";
  if (!fs::exists(path, error)) {
    throw StoreError(dir.string() + ": is not a run directory (it has no run.json)");
  }
  std::ifstream in = open_file(path);
  try {
    return run_info_from_json(Json::parse(in));
  } catch (const std::exception& e) {
    throw StoreError(fmt::format("{}: {}", path.string(), e.what()));
  }
}

// Calls `use` with every complete line. A file that is not there has no lines.
void for_each_line(const fs::path& path, std::vector<std::string>& notes, const std::function<void(const Json&)>& use) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  std::ifstream in = open_file(path);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string place = fmt::format("{}:{}: ", path.string(), number);
    if (in.eof()) {  // no line end: it was cut short
      notes.push_back(place + "incomplete last line ignored; the run was interrupted there");
      return;
    }
    try {
      use(Json::parse(line));
    } catch (const std::exception& e) {
      throw StoreError(place + e.what());
    }
  }
}

}  // namespace

Run read_run(const fs::path& dir) {
  Run run;
  run.info = read_info(dir);
  std::map<CellKey, std::optional<CellResult>> cells;
  for (const CellKey& key : run.info.cells) cells.emplace(key, std::nullopt);
  const auto slot = [&](const CellKey& key) -> std::optional<CellResult>& {
    const auto found = cells.find(key);
    if (found == cells.end()) throw std::invalid_argument("a cell that run.json does not name");
    return found->second;
  };
  for_each_line(dir / "cells.jsonl", run.notes, [&](const Json& json) {
    CellResult cell = cell_from_json(json);
    slot(cell.key) = cell;
  });
  for_each_line(dir / "timing.jsonl", run.notes, [&](const Json& json) {
    std::optional<CellResult>& cell = slot(key_from_json(json));
    if (cell) json.at("wall_s").get_to(cell->wall_s);
  });
  for (const CellKey& key : run.info.cells) {
    std::optional<CellResult> cell = std::exchange(cells.at(key), std::nullopt);
    if (cell) run.cells.push_back(*std::move(cell));
  }
  return run;
}

std::vector<CellResult> read_cells(const fs::path& dir) {
  return read_run(dir).cells;
}

}  // namespace dob
