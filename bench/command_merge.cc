#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/commands.h"
#include "results/merge.h"

namespace dob {
namespace {

struct MergeArguments {
  std::vector<std::filesystem::path> dirs;
  std::filesystem::path out;
};

void print_missing(const std::vector<int>& shards, int count, std::string_view what) {
  if (shards.empty()) return;
  fmt::print("  {} of {} shards {}: {}\n", shards.size(), count, what, fmt::join(shards, ", "));
}

int run(const MergeArguments& arguments) {
  const MergeSummary merged = merge_runs(arguments.dirs, arguments.out);
  const int count = merged.shards.front().count;
  fmt::print("{}: {} of {} shards, {} of {} planned cells, {} finished{}\n", arguments.out.string(),
             merged.shards.size(), count, merged.cells, merged.planned, merged.finished,
             merged.errors > 0 ? fmt::format(", {} of them could not be run", merged.errors) : "");
  print_missing(merged.missing, count, "are missing");
  print_missing(merged.unfinished, count, "are not finished");
  return merged.complete() && merged.errors == 0 ? kExitOk : kExitCellErrors;
}

}  // namespace

Command add_merge_command(CLI::App& app) {
  auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand("merge", "shards of a run or of a campaign as one run directory");
  command->add_option("dir", arguments->dirs, "run directories made with --shard, or merged from such")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--out", arguments->out,
                   "run directory: new, empty, or an earlier merge of the same plan, to which what is new is added")
      ->required()
      ->type_name("DIR");
  command->footer(
      "Shards of another plan, another program or another number of shards are refused; an incomplete set is merged,\n"
      "and what is missing is said. When nothing is missing, tables are those of a run that was never divided.\n"
      "Exit codes: 0 complete, 2 refused, 3 something is missing or could not be run.");
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
