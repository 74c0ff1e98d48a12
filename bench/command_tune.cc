#include <algorithm>
#include <memory>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/commands.h"
#include "bench/tuning.h"
#include "results/whole_file.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

struct TuneArguments {
  std::vector<std::string> observers;
  int budget = 24;
  std::filesystem::path out;
  BatchOptions options;
};

std::string search_log(const std::vector<TuningResult>& results) {
  std::string text = "specification;runs;falls;score;com_error_max_mean_m;foot_error_max_mean_m\n";
  for (const TuningResult& r : results) {
    text += fmt::format("{};{};{};{};{};{}\n", r.specification, r.runs, r.falls, r.score, r.com_error_max,
                        r.foot_error_max);
  }
  return text;
}

int run(TuneArguments& arguments) {
  for (const std::string& observer : arguments.observers) load_tuning_space(observer);  // all or nothing
  const TuningProcedure procedure = load_tuning_procedure();
  const BuildInfo build = build_info();
  std::filesystem::create_directories(arguments.out);
  arguments.options.progress = ::isatty(STDERR_FILENO) == 1;
  std::vector<ObserverConfig> best;
  for (const std::string& observer : arguments.observers) {
    arguments.options.out = arguments.out / observer;
    int stop_signal = 0;
    const std::vector<TuningResult> results = tune(observer, arguments.budget, arguments.options, stop_signal);
    if (stop_signal != 0) return kExitSignal + stop_signal;
    write_whole_file(arguments.out / (observer + ".csv"), search_log(results));
    const TuningResult& winner = *std::min_element(
        results.begin(), results.end(), [](const TuningResult& a, const TuningResult& b) { return a.better_than(b); });
    fmt::print(
        "{}: {} of {} candidates: {}\n  falls {} of {}, CoM {:.2f} mm, foot {:.2f} mm (profile {}: falls {}, CoM "
        "{:.2f} mm, foot {:.2f} mm)\n",
        observer, &winner - results.data() + 1, results.size(), winner.specification, winner.falls, winner.runs,
        1e3 * winner.com_error_max, 1e3 * winner.foot_error_max, procedure.profile, results.front().falls,
        1e3 * results.front().com_error_max, 1e3 * results.front().foot_error_max);
    best.push_back(load_observer(winner.specification, procedure.profile));
    // After every observer, so that an interrupted search keeps what it has found.
    write_whole_file(
        arguments.out / "tuned.toml",
        fmt::format("# Each observer's best of {} candidates by the procedure in config/tuning.toml. Written by\n"
                    "#   {}\n# with dobbench {}, commit {}; the searches' logs: results/tuning/.\n\n{}",
                    arguments.budget, arguments.options.command_line, build.version, build.commit,
                    profile_toml(best, procedure.profile)));
  }
  fmt::print("profile: {}\n", (arguments.out / "tuned.toml").string());
  return kExitOk;
}

}  // namespace

Command add_tune_command(CLI::App& app, const std::string& command_line) {
  auto arguments = std::make_shared<TuneArguments>();
  arguments->options.command_line = command_line;
  arguments->options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("tune", "search an observer's gains and routing on the training seeds");
  command->add_option("observer", arguments->observers, "those that scenarios/config/tuning.toml has a table for")
      ->required();
  command->add_option("--budget", arguments->budget, "candidates for each observer (default 24)")
      ->check(CLI::Range(1, 100000));
  command->add_option("--out", arguments->out, "directory for run directories, search logs and tuned.toml")->required();
  command->add_option("--jobs", arguments->options.jobs, "cells at a time (default: the cores)")
      ->check(CLI::Range(1, 1024));
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
