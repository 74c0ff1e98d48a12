#include <algorithm>
#include <memory>
#include <unistd.h>

#include <fmt/format.h>

#include "bench/batch.h"
#include "bench/campaign_plan.h"
#include "bench/campaign_search.h"
#include "bench/commands.h"
#include "bench/shard.h"
#include "bench/worker_options.h"
#include "results/campaign_result.h"
#include "results/campaign_table.h"
#include "results/whole_file.h"

namespace dob {
namespace {

struct CampaignArguments {
  std::string file;
  std::vector<std::string> overrides;
  long trials = 0;
  std::string shard = "1/1";
  bool plan_only = false;
  BatchOptions options;
};

void print_plan(const CampaignPlan& plan, std::size_t most) {
  double simulated = 0.0;
  for (std::size_t i = 0; i < plan.batch.cells.size(); ++i) {
    simulated += plan.batch.scenarios[plan.batch.cells.row(i).scenario].duration;
  }
  simulated /= static_cast<double>(std::max<std::size_t>(1, plan.batch.cells.size()));
  fmt::print("{} curves, {} cells of which at most {} are run, up to {} on one curve; {:.3g} simulated seconds each\n",
             plan.batch.campaign->curves.size(), plan.batch.cells.size(), most, plan.trials_per_curve, simulated);
}

BatchSummary run_or_say_how_to_go_on(const CampaignPlan& plan, const BatchOptions& options, const CellChoice& choice) {
  try {
    return run_batch(plan.batch, options, choice);
  } catch (const WriteError& error) {
    throw WriteError(
        fmt::format("{}; what was finished is kept: the same command with --resume goes on", error.what()));
  }
}

int run(CampaignArguments& arguments) {
  const CampaignSpec spec = read_campaign_spec(arguments.file, arguments.overrides, arguments.trials);
  CampaignPlan plan = plan_campaign(spec);
  take_shard(plan.batch, parse_shard(arguments.shard));
  const CellChoice choice = campaign_choice(plan);
  if (arguments.plan_only) {
    print_plan(plan, choice.most);
    return kExitOk;
  }
  arguments.options.progress = ::isatty(STDERR_FILENO) == 1;
  const BatchSummary summary = run_or_say_how_to_go_on(plan, arguments.options, choice);
  const Run finished = read_run(summary.dir);
  fmt::print("{}", render_campaign(campaign_result(*read_campaign(summary.dir), finished), TableFormat::kText));
  for (const std::string& note : finished.notes) fmt::print("note: {}\n", note);
  fmt::print("\nrun directory: {}\n", summary.dir.string());
  if (summary.stop_signal != 0) return kExitSignal + summary.stop_signal;
  return summary.errors > 0 ? kExitCellErrors : kExitOk;
}

void add_batch_options(CLI::App& command, BatchOptions& options) {
  add_worker_options(command, options, "cell");
  CLI::Option* out =
      command.add_option("--out", options.out, "run directory, new or empty (default dobbench-results/NNNN)");
  CLI::Option* resume = command.add_flag(
      "--resume", options.resume,
      "go on with the campaign in --out, by the same program and with the same arguments, or begin it");
  resume->needs(out);
  command.add_flag("--retry-errors", options.retry_errors, "run cells that could not be run again")->needs(resume);
}

}  // namespace

Command add_campaign_command(CLI::App& app, const std::string& command_line) {
  auto arguments = std::make_shared<CampaignArguments>();
  arguments->options.command_line = command_line;
  CLI::App* command = app.add_subcommand(
      "campaign", "how much an observer can take: limits, maps, breakdown curves, factorials over many trials");
  command->add_option("file", arguments->file, "FILE.toml, or the NAME of a shipped campaign")->required();
  command->add_option("--budget", arguments->trials, "trials of the whole campaign, in place of the file's")
      ->check(CLI::Range(1L, 1'000'000'000L))
      ->type_name("N");
  command->add_option("--set", arguments->overrides, "KEY=VALUE laid over every scenario")->allow_extra_args(false);
  command->add_option("--shard", arguments->shard, "only part I of N of the curves, to be merged with the others later")
      ->type_name("I/N");
  command->add_flag("--plan", arguments->plan_only, "only check everything, and say how much there is to do");
  add_batch_options(*command, arguments->options);
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
