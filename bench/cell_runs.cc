#include "bench/cell_runs.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "results/whole_file.h"

namespace dob {
namespace {

constexpr char kResult = '=';       // first byte of what a cell's process sends home: a line of a cell follows,
constexpr char kCannotWrite = '!';  // or why its files cannot be written

CellResult error_row(const CellKey& key, const std::string& reason) {
  CellResult result;
  result.key = key;
  result.outcome = Outcome::kError;
  result.reason = reason;
  return result;
}

// What has come from a cell's process is looked at before it is believed.
CellResult result_from(const CellKey& key, const TaskOutcome& outcome) {
  if (!outcome.ok) return error_row(key, outcome.reason);
  const std::string text = outcome.output.substr(std::min<std::size_t>(1, outcome.output.size()));
  if (outcome.output.starts_with(kCannotWrite)) throw WriteError(text);
  try {
    CellResult result = cell_from_line(text);
    return result.key == key ? result : error_row(key, "sent home the result of another cell");
  } catch (const StoreError& error) {
    return error_row(key, error.what());
  }
}

}  // namespace

CellResult run_cell(const CellKey& key, const Scenario& scenario, const PlannedObserver& observer,
                    const Trial::Sink& sink) {
  const auto start = std::chrono::steady_clock::now();
  CellResult result = Trial(scenario, observer.observer, key.seed, observer.shadows).run(sink);
  result.key = key;
  // With what it takes to build robot, simulator and controller, and to stand the robot up.
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

int run_cells(const CellKeys& keys, const WorkerOptions& options, const std::function<CellResult(std::size_t)>& compute,
              const std::function<void(std::size_t, const CellResult&)>& done) {
  const auto task = [&](std::size_t i) {
    try {
      return kResult + cell_to_line(compute(i));
    } catch (const WriteError& error) {
      return kCannotWrite + std::string(error.what());
    }
  };
  const auto ended = [&](std::size_t i, const TaskOutcome& outcome) { done(i, result_from(keys[i], outcome)); };
  return run_in_processes(keys.size(), options, task, ended);
}

}  // namespace dob
