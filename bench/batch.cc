#include "bench/batch.h"

#include <algorithm>
#include <malloc.h>
#include <optional>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/cell_files.h"
#include "bench/cell_runs.h"
#include "bench/observer_sources.h"
#include "bench/progress.h"
#include "bench/tick_log.h"
#include "results/plain_files.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr double kTraceRate = 100.0;  // [Hz]: 11 samples of a swing of 0.115 s, 1.6 MB for 46 s

// The process of every cell begins by copying the page tables of all that is resident here, and planning has left much
// behind that nobody needs any more.
void give_back_free_memory() {
  ::malloc_trim(0);
}

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
      : plan_(plan),
        options_(options),
        choice_(choice),
        store_(open_store()),
        was_stored_(store_.outcomes()),
        stored_(was_stored_) {
    if (options.log_csv) make_plain_directory(store_.dir() / "logs");
    if (options.keep != Keep::kNone) make_trace_directory();
    if (options.retry_errors) std::replace(stored_.begin(), stored_.end(), error_, std::optional<Outcome>());
  }

  BatchSummary run() {
    BatchSummary summary{.dir = store_.dir()};
    Progress progress = begin_progress();
    store_.set_complete(false);
    give_back_free_memory();
    std::vector<std::optional<Outcome>> outcomes(plan_.cells.size());  // of the cells that were wanted so far
    while (summary.stop_signal == 0) {
      const std::vector<std::size_t> wanted = choice_.next(outcomes);
      if (wanted.empty()) {
        forget_all_but(outcomes);
        store_.set_complete(true);
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

  // What was chosen when a cell could not be run, and is not when it could be, is no part of the result.
  void forget_all_but(const std::vector<std::optional<Outcome>>& outcomes) {
    std::vector<CellKey> others;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (was_stored_[i] && !outcomes[i]) others.push_back(plan_.cells[i].key);
    }
    store_.remove(others);
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
    CellKeys keys;
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

  double expected_cost(std::size_t cell) const { return plan_.scenarios[plan_.cells.row(cell).scenario].duration; }

  bool keeps(std::size_t cell) const {
    return options_.keep == Keep::kAll || (options_.keep == Keep::kFirstSeed && plan_.cells[cell].is_first());
  }

  std::string trace_file(std::size_t cell) const { return "traces/" + file_name(cell) + ".dobtrace"; }

  // By its place in the whole plan.
  std::string file_name(std::size_t cell) const {
    const std::size_t place = plan_.ids.empty() ? cell : static_cast<std::size_t>(plan_.ids[cell] - 1);
    return cell_file_name(place, plan_.cells[cell].key);
  }

  // In the cell's own process.
  CellResult run_with_files(std::size_t index) const {
    const PlannedCell cell = plan_.cells[index];
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
  std::vector<std::optional<Outcome>> was_stored_;  // of every cell of the plan, when this began
  std::vector<std::optional<Outcome>> stored_;      // the same now, without those that are to be run again
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
  const std::vector<std::string> observers = observer_sources(plan);
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
