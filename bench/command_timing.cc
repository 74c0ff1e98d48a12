#include <cstdlib>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "bench/batch.h"
#include "bench/commands.h"
#include "bench/number_between.h"
#include "bench/plugin_consent.h"
#include "bench/timing.h"
#include "bench/worker_pool.h"
#include "results/store.h"

namespace dob {
namespace {

struct TimingArguments {
  BatchRequest request;
  std::filesystem::path out;                   // a run; empty: the figures are printed only
  std::vector<std::filesystem::path> plugins;  // of that run
  double seconds = 10.0;
  std::string command_line;
};

// Nothing that was not asked for: then it is the run's own plan.
bool is_empty(const BatchRequest& r) {
  return r.scenarios.empty() && r.observers.empty() && r.profiles.empty() && r.gains.empty() && r.planner.empty() &&
         r.overrides.empty();
}

void warn_of_other_load() {
  double load = 0.0;
  if (::getloadavg(&load, 1) == 1 && load > 0.5) {
    fmt::print(stderr, "dobbench: other programs load this machine (load average {:.1f}): the figures are too high\n",
               load);
  }
}

void print(const CellTiming& t) {
  fmt::print("{:<44} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.2f} {:>8.2f} {:>8.1f} {:>8.1f}\n",
             fmt::format("{}{}{} {} {}", t.key.scenario, t.key.variant.empty() ? "" : "/", t.key.variant,
                         t.key.observer, t.key.profile),
             t.tick_p50_us, t.tick_p99_us, t.tick_max_us, t.qp_p50_us, t.qp_p99_us, t.qp_max_us, t.real_time_factor);
  std::fflush(stdout);
}

void print_heading() {
  const auto line = [](auto... texts) { fmt::print("{:<44} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", texts...); };
  line("", "tick p50", "p99", "max", "QP p50", "p99", "max", "speed");
  line("", "[us]", "[us]", "[us]", "[us]", "[us]", "[us]", "[x real]");
}

// What has come from the cell's process; false, with the reason, if it is not the timing of this cell.
bool read(const std::string& line, const CellKey& key, CellTiming& timing, std::string& reason) {
  try {
    timing = timing_from_line(line);
    reason = "sent home the timing of another cell";
    return timing.key == key;
  } catch (const StoreError& error) {
    reason = error.what();
    return false;
  }
}

// One cell after the other. `store` may be null.
int measure(const BatchPlan& plan, double seconds, RunStore* store) {
  const std::vector<PlannedCell> cells = first_seeds(plan);
  int failed = 0;
  const auto task = [&](std::size_t i) {
    const ObserverConfig& observer = plan.observers[cells[i].observer].observer;
    return timing_to_line(time_cell(cells[i].key, plan.scenarios[cells[i].scenario], observer, seconds));
  };
  const auto done = [&](std::size_t i, const TaskOutcome& outcome) {
    CellTiming timing;
    std::string reason = outcome.reason;
    if (!outcome.ok || !read(outcome.output, cells[i].key, timing, reason)) {
      ++failed;
      fmt::print("{} {} {}: {}\n", cells[i].key.scenario, cells[i].key.observer, cells[i].key.profile, reason);
      return;
    }
    if (store != nullptr) store->append(timing);
    print(timing);
  };
  warn_of_other_load();
  print_heading();
  const int signal = run_in_processes(cells.size(), {.jobs = 1, .memory_limit_MB = kDefaultMemoryLimit_MB}, task, done);
  if (signal != 0) return kExitSignal + signal;
  return failed > 0 ? kExitCellErrors : kExitOk;
}

void require_cells_of(const std::filesystem::path& dir, const BatchPlan& plan) {
  const CellKeys of_run = read_run_info(dir).cells;
  const std::set<CellKey> keys(of_run.begin(), of_run.end());
  for (const PlannedCell& cell : first_seeds(plan)) {
    if (keys.contains(cell.key)) continue;
    throw StoreError(fmt::format("{}: a cell of {} with {} ({}) does not belong to the run", dir.string(),
                                 cell.key.scenario, cell.key.observer, cell.key.profile));
  }
}

int run(const TimingArguments& arguments) {
  const bool plan_of_run = !arguments.out.empty() && is_empty(arguments.request);
  const BatchRequest request = plan_of_run ? request_of_run(arguments.out, arguments.plugins) : arguments.request;
  try_plugins(request);
  const BatchPlan plan = plan_batch(request);
  if (arguments.out.empty()) return measure(plan, arguments.seconds, nullptr);
  require_cells_of(arguments.out, plan);
  RunStore store = RunStore::open(arguments.out, run_info(plan, arguments.command_line));
  return measure(plan, arguments.seconds, &store);
}

}  // namespace

Command add_timing_command(CLI::App& app, const std::string& command_line) {
  auto arguments = std::make_shared<TimingArguments>();
  arguments->command_line = command_line;
  BatchRequest& request = arguments->request;
  CLI::App* command =
      app.add_subcommand("timing", "how long control ticks and their QP take: one cell after the other, first seeds");
  command->add_option("scenario", request.scenarios, "as for `run`; with --out and nothing else: those of the run");
  command->add_option("--observer", request.observers, "as for `run`")->allow_extra_args(false);
  command->add_option("--profile", request.profiles, "as for `run`")->allow_extra_args(false);
  command->add_option("--gains", request.gains, "as for `run`")->allow_extra_args(false);
  command->add_option("--planner", request.planner, "as for `run`");
  command->add_option("--set", request.overrides, "as for `run`")->allow_extra_args(false);
  command->add_option("--seconds", arguments->seconds, "simulated time of each cell [s] (default 10); 0: all of it")
      ->check(number_between(0.0, 1e6));
  command
      ->add_option("--out", arguments->out, "run directory, by this program, that keeps the figures: `table --timing`")
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("--plugin", arguments->plugins,
                   "a plugin of the run in --out that may be loaded again; it is code that runs here")
      ->allow_extra_args(false)
      ->type_name("FILE.so");
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
