#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <map>
#include <memory>
#include <unistd.h>

#include <fmt/format.h>

#include "bench/batch.h"
#include "bench/claims_report.h"
#include "bench/commands.h"
#include "bench/number_between.h"
#include "bench/plugin_consent.h"
#include "bench/shard.h"
#include "bench/shell_words.h"
#include "bench/worker_options.h"
#include "results/table.h"
#include "results/whole_file.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

constexpr int kMaxSeed = 1'000'000;

// What was asked for is data; what it is done with, and which time series it leaves behind, is not.
constexpr std::array kOperational{"--resume", "--retry-errors", "--out",      "--jobs",         "--timeout", "--claims",
                                  "--keep",   "--log",          "--log-rate", "--memory-limit", "--plugin"};

struct RunArguments {
  BatchRequest request;
  BatchOptions options;
  std::vector<std::string> shadows;
  std::vector<std::filesystem::path> plugins;  // of the run that is gone on with
  std::string seeds = "1";
  std::string log = "none";
  std::string shard = "1/1";
  bool claims = false;
  Keep keep = Keep::kFirstSeed;
};

int parse_seed(std::string_view text, const std::string& whole) {
  int seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size() || seed < 1 || seed > kMaxSeed) {
    throw InputError(fmt::format("--seeds {}: allowed: N for the seeds 1 to N, or A..B with 1 <= A <= B; up to {}",
                                 whole, kMaxSeed));
  }
  return seed;
}

// "N" is 1..N; "a..b" is that range.
void read_seeds(const std::string& text, BatchRequest& request) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    request.first_seed = 1;
    request.last_seed = parse_seed(text, text);
  } else {
    request.first_seed = parse_seed(std::string_view(text).substr(0, dots), text);
    request.last_seed = parse_seed(std::string_view(text).substr(dots + 2), text);
  }
  if (request.last_seed < request.first_seed) parse_seed("", text);
}

void split_shadows(RunArguments& arguments) {
  for (const std::string& list : arguments.shadows) {
    for (std::string& shadow : split_specifications(list)) arguments.request.shadows.push_back(std::move(shadow));
  }
}

CLI::App* add_options(CLI::App& app, RunArguments* arguments);

// The arguments of the command line that began the run in `dir`.
RunArguments arguments_of_run(const std::filesystem::path& dir) {
  std::vector<std::string> words = split_words(read_run_info(dir).command_line);
  if (words.size() < 2 || words[1] != "run") {
    throw StoreError(
        fmt::format("{}: was not begun by `dobbench run`; give the arguments that began it", dir.string()));
  }
  RunArguments stored;
  CLI::App app;
  add_options(app, &stored);
  std::reverse(words.begin(), words.end());
  words.pop_back();
  app.parse(words);
  read_seeds(stored.seeds, stored.request);
  split_shadows(stored);
  return stored;
}

bool asks_for_nothing(const CLI::App& command) {
  const auto options = command.get_options([](const CLI::Option* option) {
    return option->count() > 0 && std::none_of(kOperational.begin(), kOperational.end(),
                                               [&](const char* name) { return option->get_name() == name; });
  });
  return options.empty();
}

// `run --resume --out DIR` alone goes on with what began the run, and with the time series that were asked for then.
void take_plan_of_run(RunArguments& arguments, const CLI::App& command) {
  const std::filesystem::path& dir = arguments.options.out;
  if (dir.empty()) throw InputError("--resume: needs --out DIR");
  if (!is_run_directory(dir)) {
    throw InputError(
        fmt::format("--resume: {} holds no run to go on with; to begin one there, say what to run", dir.string()));
  }
  RunArguments stored = arguments_of_run(dir);
  require_consent(stored.request, arguments.plugins, "--resume: " + dir.string());
  if (command.count("--keep") == 0) arguments.keep = stored.keep;
  if (command.count("--log") == 0) arguments.log = stored.log;
  if (command.count("--log-rate") == 0) arguments.options.log_rate = stored.options.log_rate;
  arguments.request = std::move(stored.request);
  arguments.seeds = std::move(stored.seeds);
  arguments.shard = std::move(stored.shard);
}

void warn(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return;
  const std::string more = warnings.size() > 1 ? fmt::format(" (and {} more)", warnings.size() - 1) : "";
  fmt::print(stderr, "dobbench: a disturbance that never acts: {}{}\n", warnings.front(), more);
}

BatchSummary run_or_say_how_to_go_on(const BatchPlan& plan, const BatchOptions& options) {
  try {
    return run_batch(plan, options);
  } catch (const WriteError& error) {
    throw WriteError(
        fmt::format("{}; what was finished is kept: `dobbench run --resume --out DIR` goes on", error.what()));
  }
}

// The plan is gone when the results are read: of a large batch either is large.
BatchSummary plan_and_run(const RunArguments& arguments) {
  try_plugins(arguments.request);
  BatchPlan plan = plan_batch(arguments.request);
  take_shard(plan, parse_shard(arguments.shard));
  warn(plan.warnings);
  return run_or_say_how_to_go_on(plan, arguments.options);
}

int run(RunArguments& arguments, const CLI::App& command) {
  if (arguments.options.resume && asks_for_nothing(command)) take_plan_of_run(arguments, command);
  if (command.count("--log-rate") > 0 && arguments.log != "csv") throw InputError("--log-rate: needs --log csv");
  read_seeds(arguments.seeds, arguments.request);
  split_shadows(arguments);
  arguments.options.log_csv = arguments.log == "csv";
  arguments.options.keep = arguments.keep;
  arguments.options.progress = ::isatty(STDERR_FILENO) == 1;
  const BatchSummary summary = plan_and_run(arguments);
  const Run finished = read_run(summary.dir);
  fmt::print("{}", render_table(finished, {}));
  if (!arguments.request.shadows.empty()) fmt::print("\n{}", render_table(finished, {.shadow = true}));
  if (arguments.claims) fmt::print("\n{}", claims_report(finished, TableFormat::kText));
  fmt::print("\nrun directory: {}\n", summary.dir.string());
  if (summary.stop_signal != 0) return kExitSignal + summary.stop_signal;
  return summary.errors > 0 ? kExitCellErrors : kExitOk;
}

CLI::App* add_options(CLI::App& app, RunArguments* arguments) {
  const std::map<std::string, Keep> keeps{{"none", Keep::kNone}, {"first-seed", Keep::kFirstSeed}, {"all", Keep::kAll}};
  BatchRequest& request = arguments->request;
  BatchOptions& options = arguments->options;
  CLI::App* command = app.add_subcommand("run", "run scenarios with observers and print the comparison table");
  command->add_option("scenario", request.scenarios, "NAME, NAME/VARIANT or FILE.toml; the paper's set by default");
  command
      ->add_option("--observer", request.observers, "NAME[:key=value,...]; the scenario's own, else every built-in one")
      ->allow_extra_args(false);
  command->add_option("--shadow", arguments->shadows, "NAME[:key=value,...],...: watch every cell; `table --shadow`")
      ->allow_extra_args(false);
  command->add_option("--profile", request.profiles, "gains and routing of the observers; every one by default")
      ->allow_extra_args(false);
  command
      ->add_option("--gains", request.gains,
                   "gain set of the controller, or own (default: the scenario's own, else paper)")
      ->allow_extra_args(false);
  command->add_flag("--claims", arguments->claims, "also print the paper's claims beside what was measured");
  command->add_option("--planner", request.planner, "planner of the motion (default: the scenario's)");
  command->add_option("--seeds", arguments->seeds, "N for the seeds 1 to N, or A..B (default 1)");
  command->add_option("--set", request.overrides, "KEY=VALUE laid over every scenario")->allow_extra_args(false);
  command->add_option("--shard", arguments->shard, "only part I of N of the cells, to be merged with the others later")
      ->type_name("I/N");
  add_worker_options(*command, options, "cell");
  CLI::Option* out =
      command->add_option("--out", options.out, "run directory, new or empty (default dobbench-results/NNNN)");
  CLI::Option* resume = command->add_flag(
      "--resume", options.resume,
      "go on with the run in --out, by the same program and with the same arguments, or begin it; without arguments, "
      "only go on, with those that began it; cells that could not be run stay as they are");
  resume->needs(out);
  command
      ->add_option("--plugin", arguments->plugins,
                   "with --resume alone: a plugin of the run that may be loaded again; it is code that runs here")
      ->allow_extra_args(false)
      ->type_name("FILE.so")
      ->needs(resume);
  command->add_flag("--retry-errors", options.retry_errors, "run those cells again")->needs(resume);
  command->add_option("--log", arguments->log, "csv: time series of every cell as a file, for PlotJuggler")
      ->check(CLI::IsMember({"none", "csv"}));
  command->add_option("--log-rate", options.log_rate, "of these [Hz] (default 1000)")->check(number_between(1e-3, 1e6));
  command
      ->add_option("--keep", arguments->keep, "cells whose time series the run keeps: none, first-seed (default), all")
      ->transform(CLI::CheckedTransformer(keeps));
  return command;
}

}  // namespace

BatchRequest request_of_run(const std::filesystem::path& dir, const std::vector<std::filesystem::path>& plugins) {
  BatchRequest request = arguments_of_run(dir).request;
  require_consent(request, plugins, "--out " + dir.string());
  return request;
}

Command add_run_command(CLI::App& app, const std::string& command_line) {
  auto arguments = std::make_shared<RunArguments>();
  const CLI::App* command = add_options(app, arguments.get());
  arguments->options.command_line = command_line;
  return [arguments, command] { return run(*arguments, *command); };
}

}  // namespace dob
