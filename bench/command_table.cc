#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "bench/claims_report.h"
#include "bench/commands.h"
#include "results/campaign_table.h"
#include "results/table.h"

namespace dob {

namespace {

std::string campaign_table(const std::string& dir, TableFormat format) {
  const std::optional<Campaign> campaign = read_campaign(dir);
  if (!campaign) throw StoreError(dir + ": is a run, not a campaign; `dobbench table` without --campaign shows it");
  return render_campaign(campaign_result(*campaign, read_run(dir)), format);
}

}  // namespace

Command add_table_command(CLI::App& app) {
  struct TableArguments {
    std::string dir;
    TableOptions options;
    bool claims = false;
    bool campaign = false;
    std::vector<std::string> recorded;
  };
  const std::map<std::string, TableFormat> formats{{"text", TableFormat::kText},
                                                   {"md", TableFormat::kMarkdown},
                                                   {"csv", TableFormat::kCsv},
                                                   {"latex", TableFormat::kLatex},
                                                   {"json", TableFormat::kJson}};
  const std::map<std::string, TableOrder> orders{{"scenario", TableOrder::kByScenario},
                                                 {"observer", TableOrder::kByObserver}};
  auto arguments = std::make_shared<TableArguments>();
  CLI::App* command = app.add_subcommand("table", "the comparison table of a run directory");
  command->add_option("dir", arguments->dir, "run directory")->required();
  command->add_option("--format", arguments->options.format, "text, md, csv, latex or json")
      ->transform(CLI::CheckedTransformer(formats));
  CLI::Option* by = command->add_option("--by", arguments->options.order, "scenario or observer")
                        ->transform(CLI::CheckedTransformer(orders));
  CLI::Option* reference =
      command->add_option("--reference", arguments->options.reference,
                          "OBSERVER[@PROFILE] that the others are compared with, run by run (default none)");
  CLI::Option* shadow =
      command->add_flag("--shadow", arguments->options.shadow, "the estimates of the shadow observers instead");
  CLI::Option* timing =
      command->add_flag("--timing", arguments->options.timing, "with what a serial timing pass has measured");
  CLI::Option* claims = command->add_flag("--claims", arguments->claims, "the paper's claims beside what was measured");
  CLI::Option* campaign =
      command->add_flag("--campaign", arguments->campaign, "what the campaign has found: thresholds, shares of falls");
  for (CLI::Option* of_comparison : {by, reference, shadow, timing}) {
    claims->excludes(of_comparison);
    campaign->excludes(of_comparison);
  }
  campaign->excludes(claims);
  command
      ->add_option("--recorded", arguments->recorded,
                   "with --claims: further run directories that may show why a claim does not hold")
      ->needs(claims);
  return [arguments] {
    if (arguments->claims) {
      fmt::print("{}", claims_report(read_run(arguments->dir), arguments->options.format, arguments->recorded));
      return kExitOk;
    }
    if (arguments->campaign) {
      fmt::print("{}", campaign_table(arguments->dir, arguments->options.format));
      return kExitOk;
    }
    fmt::print("{}", render_table(read_run(arguments->dir), arguments->options));
    return kExitOk;
  };
}

}  // namespace dob
