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

// All at once.
CellChoice every_cell(std::size_t cells) {
  const auto next = [](const std::vector<std::optional<Outcome>>& outcomes) {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (!outcomes[i]) wanted.push_back(i);
    }
    return wanted;
  };
  return {next, cells};
}

class Batch {
 public:
  Batch(const BatchPlan& plan, const BatchOptions& options, const CellChoice& choice)
      : plan_(plan), options_(options), choice_(choice), store_(open_store()), stored_(store_.outcomes()) {
    if (options.log_csv) make_plain_directory(store_.dir() / "logs");
    if (options.keep != Keep::kNone) make_trace_directory();
    if (options.retry_errors) std::replace(stored_.begin(), stored_.end(), error_, std::optional<Outcome>());
  }

  BatchSummary run() {
    BatchSummary summary{.dir = store_.dir()};
    Progress progress = begin_progress();
    std::vector<std::optional<Outcome>> outcomes(plan_.cells.size());  // of the cells that were wanted so far
    while (summary.stop_signal == 0) {
      const std::vector<std::size_t> wanted = choice_.next(outcomes);
      if (wanted.empty()) {
        store_.complete();
        break;
      }
      summary.stop_signal = run_round(wanted, progress);
      for (const std::size_t cell : wanted) outcomes[cell] = stored_[cell];
    }
    summary.errors = static_cast<std::size_t>(std::count(outcomes.begin(), outcomes.end(), error_));
    return summary;
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

  // What is expected of the cells that are left: of those that may be wanted, nobody knows which they will be.
  Progress begin_progress() const {
    double cost = 0.0;
    std::size_t left = 0, done = 0;
    for (std::size_t i = 0; i < stored_.size(); ++i) {
      stored_[i] ? ++done : ++left;
      if (!stored_[i]) cost += expected_cost(i);
    }
    const std::size_t open = choice_.most - std::min(choice_.most, done);
    if (left > 0) cost *= static_cast<double>(std::min(open, left)) / static_cast<double>(left);
    return {choice_.most, done, cost, options_.progress};
  }

  // Those of the cells that are not stored yet, the longest first: the last ones to end are short, and no job waits
  // long for another.
  int run_round(const std::vector<std::size_t>& wanted, Progress& progress) {
    std::vector<std::size_t> cells;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(cells), [&](std::size_t i) { return !stored_[i]; });
    std::stable_sort(cells.begin(), cells.end(),
                     [&](std::size_t a, std::size_t b) { return expected_cost(a) > expected_cost(b); });
    std::vector<CellKey> keys;
    for (const std::size_t cell : cells) keys.push_back(plan_.cells[cell].key);
    const auto compute = [&](std::size_t i) { return run_with_files(cells[i]); };
    const auto done = [&](std::size_t i, CellResult result) {
      // Its own process is not asked where it wrote.
      result.trace = result.outcome != Outcome::kError && keeps(cells[i]) ? trace_file(cells[i]) : "";
      store_.append(result);
      stored_[cells[i]] = result.outcome;
      progress.add(result, expected_cost(cells[i]));
    };
    return run_cells(keys, {options_.jobs, options_.timeout_s, options_.memory_limit_MB}, compute, done);
  }

  double expected_cost(std::size_t cell) const { return plan_.scenarios[plan_.cells[cell].scenario].duration; }

  bool keeps(std::size_t cell) const {
    return options_.keep == Keep::kAll || (options_.keep == Keep::kFirstSeed && plan_.cells[cell].first_seed);
  }

  std::string trace_file(std::size_t cell) const { return "traces/" + file_name(cell) + ".dobtrace"; }

  // By its place in the whole plan.
  std::string file_name(std::size_t cell) const {
    const std::size_t place = plan_.ids.empty() ? cell : static_cast<std::size_t>(plan_.ids[cell] - 1);
    return cell_file_name(place, plan_.cells[cell].key);
  }

  // In the cell's own process.
  CellResult run_with_files(std::size_t index) const {
    const PlannedCell& cell = plan_.cells[index];
    const Scenario& scenario = plan_.scenarios[cell.scenario];
    const std::string name = file_name(index);
    std::optional<TickLog> log;
    std::optional<TraceRecorder> trace;
    if (options_.log_csv) log.emplace(store_.dir() / "logs" / (name + ".csv"), options_.log_rate, scenario.sim.dt);
    if (keeps(index)) trace.emplace(kTraceRate, scenario.sim.dt);
    CellResult result = run_cell(cell.key, scenario, plan_.observers[cell.observer], [&](const TickRecord& tick) {
      if (log) log->add(tick);
      if (trace) trace->add(tick);
    });
    if (log) log->close();
    if (trace) write_trace(store_.dir() / trace_file(index), trace->trace());
    return result;
  }

  static constexpr std::optional<Outcome> error_ = Outcome::kError;

  const BatchPlan& plan_;
  const BatchOptions& options_;
  const CellChoice& choice_;
  RunStore store_;
  std::vector<std::optional<Outcome>> stored_;  // of every cell of the plan
};

// How observers are made, with fingerprints of the libraries they come from: one that has been built anew is
// another observer.
class ObserverSources {
 public:
  std::string source_of(const PlannedObserver& planned) {
    std::string source;
    add_libraries(source, planned.observer);
    for (const ObserverConfig& shadow : planned.shadows) add_libraries(source, shadow);
    return source + observer_toml(planned.observer, planned.shadows);
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
               .code_path = this_code_path(),
               .ids = plan.ids,
               .shards = {},
               .campaign = plan.campaign};
  if (plan.shard.planned > 0) info.shards = {plan.shard};
  ObserverSources libraries;
  std::vector<std::string> observers;
  for (const PlannedObserver& observer : plan.observers) observers.push_back(libraries.source_of(observer));
  for (const PlannedCell& cell : plan.cells) {
    info.cells.push_back(cell.key);
    info.sources.push_back({plan.resolved[cell.scenario].name, observers[cell.observer]});
  }
  return info;
}

BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options) {
  return run_batch(plan, options, every_cell(plan.cells.size()));
}

BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options, const CellChoice& choice) {
  return Batch(plan, options, choice).run();
}

}  // namespace dob
