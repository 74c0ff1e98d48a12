#include "bench/batch.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/cell_files.h"
#include "bench/cell_runs.h"
#include "bench/progress.h"
#include "bench/tick_log.h"
#include "observers/pair.h"
#include "observers/plugin.h"
#include "results/fingerprint.h"
#include "results/plain_files.h"
#include "scenarios/input_error.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr double kTraceRate = 100.0;  // [Hz]: 11 samples of a swing of 0.115 s, 1.6 MB for 46 s

class Batch {
 public:
  Batch(const BatchPlan& plan, const BatchOptions& options) : plan_(plan), options_(options), store_(open_store()) {
    if (options.log_csv) make_plain_directory(store_.dir() / "logs");
    if (options.keep != Keep::kNone) make_trace_directory();
    choose_cells();
  }

  BatchSummary run() {
    double cost = 0.0;
    for (const std::size_t cell : cells_) cost += expected_cost(cell);
    Progress progress(plan_.cells.size(), plan_.cells.size() - cells_.size(), cost, options_.progress);
    std::vector<CellKey> keys;
    for (const std::size_t cell : cells_) keys.push_back(plan_.cells[cell].key);
    const auto compute = [&](std::size_t i) { return run_with_files(cells_[i]); };
    const auto done = [&](std::size_t i, CellResult result) {
      // Its own process is not asked where it wrote.
      result.trace = result.outcome != Outcome::kError && keeps(cells_[i]) ? trace_file(cells_[i]) : "";
      store_.append(result);
      if (result.outcome == Outcome::kError) ++summary_.errors;
      progress.add(result, expected_cost(cells_[i]));
    };
    const WorkerOptions limits{options_.jobs, options_.timeout_s, options_.memory_limit_MB};
    summary_.stop_signal = run_cells(keys, limits, compute, done);
    return summary_;
  }

 private:
  RunStore open_store() const {
    const RunInfo info = run_info(plan_, options_.command_line);
    if (options_.out.empty()) {
      if (options_.resume) throw InputError("--resume: needs --out DIR");
      return RunStore::create_numbered("dobbench-results", info, plan_.resolved);
    }
    return options_.resume && is_run_directory(options_.out) ? RunStore::resume(options_.out, info, plan_.resolved)
                                                             : RunStore::create(options_.out, info, plan_.resolved);
  }

  // Without what processes that were killed have left there.
  void make_trace_directory() const {
    make_plain_directory(store_.dir() / "traces");
    for (const fs::path& file : fs::directory_iterator(store_.dir() / "traces")) {
      if (file.extension() == ".part") fs::remove(file);
    }
  }

  // Those that are not finished, the longest first: the last ones to end are short, and no job waits long for another.
  void choose_cells() {
    summary_.dir = store_.dir();
    const std::vector<CellState> states = store_.states();
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i] == CellState::kPending || (states[i] == CellState::kError && options_.retry_errors)) {
        cells_.push_back(i);
      } else if (states[i] == CellState::kError) {
        ++summary_.errors;
      }
    }
    std::stable_sort(cells_.begin(), cells_.end(),
                     [&](std::size_t a, std::size_t b) { return expected_cost(a) > expected_cost(b); });
    std::set<CellKey> rows;
    for (const PlannedCell& cell : plan_.cells) {
      CellKey row = cell.key;
      row.seed = 0;
      first_seed_.push_back(rows.insert(row).second);
    }
  }

  double expected_cost(std::size_t cell) const { return plan_.scenarios[plan_.cells[cell].scenario].duration; }

  bool keeps(std::size_t cell) const {
    return options_.keep == Keep::kAll || (options_.keep == Keep::kFirstSeed && first_seed_[cell]);
  }

  std::string trace_file(std::size_t cell) const {
    return "traces/" + cell_file_name(cell, plan_.cells[cell].key) + ".dobtrace";
  }

  // In the cell's own process.
  CellResult run_with_files(std::size_t index) const {
    const PlannedCell& cell = plan_.cells[index];
    const Scenario& scenario = plan_.scenarios[cell.scenario];
    const std::string name = cell_file_name(index, cell.key);
    std::optional<TickLog> log;
    std::optional<TraceRecorder> trace;
    if (options_.log_csv) log.emplace(store_.dir() / "logs" / (name + ".csv"), options_.log_rate, scenario.sim.dt);
    if (keeps(index)) trace.emplace(kTraceRate, scenario.sim.dt);
    CellResult result = run_cell(scenario, cell, [&](const TickRecord& tick) {
      if (log) log->add(tick);
      if (trace) trace->add(tick);
    });
    if (log) log->close();
    if (trace) write_trace(store_.dir() / trace_file(index), trace->trace());
    return result;
  }

  const BatchPlan& plan_;
  const BatchOptions& options_;
  RunStore store_;
  BatchSummary summary_;
  std::vector<std::size_t> cells_;  // to be run, in the order of their start: indices into plan_.cells
  std::vector<bool> first_seed_;    // of its row in the tables, for every cell of the plan
};

// How a cell's observers are made, with fingerprints of the libraries they come from: one that has been built anew is
// another observer.
class ObserverSources {
 public:
  std::string source_of(const PlannedCell& cell) {
    std::string source;
    add_libraries(source, cell.observer);
    for (const ObserverConfig& shadow : cell.shadows) add_libraries(source, shadow);
    return source + observer_toml(cell.observer, cell.shadows);
  }

 private:
  void add_libraries(std::string& source, const ObserverConfig& observer) {
    const auto pair = parse_pair_name(observer.observer);
    const auto parts = pair ? std::vector{pair->legs, pair->com} : std::vector{std::string_view(observer.observer)};
    for (const std::string_view part : parts) {
      if (is_plugin_path(part)) source += fmt::format("# {} holds {}\n", part, held_by(std::string(part)));
    }
  }

  const std::string& held_by(const std::string& library) {
    const auto [it, added] = held_.emplace(library, "");
    if (added) it->second = file_fingerprint(library);
    return it->second;
  }

  std::map<std::string, std::string> held_;  // library -> fingerprint
};

}  // namespace

RunInfo run_info(const BatchPlan& plan, const std::string& command_line) {
  const BuildInfo build = build_info();
  RunInfo info{.command_line = command_line,
               .version = build.version,
               .commit = build.commit,
               .build = build.build_type,
               .compiler = build.compiler,
               .flags = build.flags,
               .machine = this_machine(),
               .date = utc_now(),
               .cells = {},
               .sources = {},
               .code_path = this_code_path()};
  ObserverSources observers;
  for (const PlannedCell& cell : plan.cells) {
    info.cells.push_back(cell.key);
    info.sources.push_back({plan.resolved[cell.scenario].name, observers.source_of(cell)});
  }
  return info;
}

BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options) {
  return Batch(plan, options).run();
}

}  // namespace dob
