#include "bench/batch.h"

#include <cstdio>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/tick_log.h"
#include "bench/trial.h"
#include "bench/worker_pool.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

std::string label(const CellKey& key) {
  return fmt::format("{}{}{} {} {}", key.scenario, key.variant.empty() ? "" : "/", key.variant, key.observer,
                     key.profile);
}

CellResult run_cell(const BatchPlan& plan, const PlannedCell& cell, const std::filesystem::path& log_dir) {
  Trial trial(plan.scenarios[cell.scenario], cell.observer, cell.key.seed);
  CellResult result;
  if (log_dir.empty()) {
    result = trial.run();
  } else {
    TickLog log(log_dir / log_name(cell.key));
    result = trial.run([&log](const TickRecord& tick) { log.add(tick); });
    log.close();
  }
  result.key = cell.key;
  return result;
}

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
               .cells = {}};
  for (const PlannedCell& cell : plan.cells) {
    info.cells.push_back(cell.key);
    info.sources.push_back({plan.resolved[cell.scenario].name, profile_toml({cell.observer})});
  }
  return info;
}

}  // namespace

BatchSummary run_batch(const BatchPlan& plan, const BatchOptions& options) {
  const RunInfo info = run_info(plan, options.command_line);
  RunStore store = options.out.empty() ? RunStore::create_numbered("dobbench-results", info, plan.resolved)
                                       : RunStore::create(options.out, info, plan.resolved);
  std::filesystem::path log_dir;
  if (options.log_csv) {
    log_dir = store.dir() / "logs";
    std::filesystem::create_directory(log_dir);
  }
  BatchSummary summary{.dir = store.dir(), .errors = 0, .stop_signal = 0};
  std::size_t finished = 0;
  const auto task = [&](std::size_t i) { return cell_to_line(run_cell(plan, plan.cells[i], log_dir)); };
  const auto done = [&](std::size_t i, const TaskOutcome& outcome) {
    CellResult result;
    if (outcome.ok) {
      result = cell_from_line(outcome.output);
    } else {
      result.key = plan.cells[i].key;
      result.outcome = Outcome::kError;
      result.reason = outcome.reason;
      ++summary.errors;
    }
    store.append(result);
    ++finished;
    if (options.progress) {
      fmt::print(stderr, "\r\033[K{}/{} cells, last: {}", finished, plan.cells.size(), label(result.key));
      std::fflush(stderr);
    }
  };
  summary.stop_signal = run_in_processes(plan.cells.size(), {options.jobs, options.timeout_s}, task, done);
  if (options.progress) fmt::print(stderr, "\r\033[K");
  return summary;
}

}  // namespace dob
