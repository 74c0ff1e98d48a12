// Runs made by hand for the tests of store and tables.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include "results/store.h"

namespace dob::test {

inline CellKey key(std::string scenario, std::string variant, std::string observer, std::string profile, int seed) {
  return {
      std::move(scenario), std::move(variant), std::move(observer), std::move(profile), "paper", "spline", "", seed};
}

inline CellResult survived(CellKey key, double com_error_max_m) {
  CellResult cell;
  cell.key = std::move(key);
  cell.outcome = Outcome::kSurvived;
  cell.simulated_s = 46.0;
  cell.metrics.com_error_max_m = com_error_max_m;
  return cell;
}

inline CellResult fell(CellKey key, double time_s, double com_error_max_m) {
  CellResult cell = survived(std::move(key), com_error_max_m);
  cell.outcome = Outcome::kFell;
  cell.simulated_s = time_s;
  cell.reason = "trunk tilted";
  return cell;
}

inline CellResult failed(CellKey key, std::string reason) {
  CellResult cell;
  cell.key = std::move(key);
  cell.outcome = Outcome::kError;
  cell.reason = std::move(reason);
  return cell;
}

// A checkpoint of com_error_max_m, and of foot_error_max_m ten times that.
inline MetricsCheckpoint checkpoint(double t, double com_error_max_m) {
  return {.t = t,
          .com_error_max_m = com_error_max_m,
          .com_error_rms_m = {},
          .path_error_max_m = {},
          .foot_error_max_m = 10.0 * com_error_max_m,
          .grf_error_mean_N = {}};
}

// The run that consists of these cells, planned in this order.
inline Run run_of(std::vector<CellResult> cells) {
  Run run;
  for (const CellResult& cell : cells) run.info.cells.push_back(cell.key);
  run.cells = std::move(cells);
  return run;
}

// A directory of its own, gone with the object.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "dob-results-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

inline void append_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::app) << text;
}

// what() of the StoreError that `action` throws; "" if it throws none.
template <typename Action>
std::string store_error(Action action) {
  try {
    action();
  } catch (const StoreError& error) {
    return error.what();
  }
  return "";
}

}  // namespace dob::test
