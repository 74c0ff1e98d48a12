#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/commands.h"
#include "bench/number_between.h"
#include "results/report.h"
#include "results/whole_file.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  fs::path dir, out;
  ReportOptions options;
};

// So that a slip does not replace what a run consists of.
fs::path page_file(const ReportArguments& arguments) {
  if (arguments.out.empty()) return arguments.dir / "report.html";
  if (arguments.out.extension() == ".html" || arguments.out.extension() == ".htm") return arguments.out;
  throw InputError(fmt::format("-o {}: allowed: a file name that ends in .html", arguments.out.string()));
}

// A place where no page can be is a wrong answer to -o: nothing is lost.
ReportSummary write_page(const ReportArguments& arguments, const fs::path& file) {
  try {
    return write_report(arguments.dir, file, arguments.options);
  } catch (const WriteError& error) {
    throw InputError(error.what());
  }
}

int run(const ReportArguments& arguments) {
  const fs::path file = page_file(arguments);
  const ReportSummary summary = write_page(arguments, file);
  fmt::print("{}: {:.2f} MB, time series of {} cells\n", file.string(), 1e-6 * static_cast<double>(summary.bytes),
             summary.traces);
  for (const std::string& left_out : summary.left_out) fmt::print("left out: {}\n", left_out);
  for (const std::string& missing : summary.missing) fmt::print("{}\n", missing);
  return kExitOk;
}

}  // namespace

Command add_report_command(CLI::App& app) {
  auto arguments = std::make_shared<ReportArguments>();
  const BuildInfo build = build_info();
  arguments->options.version = build.version;
  arguments->options.commit = build.commit;
  CLI::App* command = app.add_subcommand("report", "a run directory as one page with plots and replays, for a browser");
  command->add_option("dir", arguments->dir, "run directory; a batch may still be writing it")->required();
  command->add_option("-o,--out", arguments->out, "the page (default DIR/report.html)");
  command
      ->add_option("--max-size", arguments->options.max_megabytes,
                   "size of the page [MB] (default 12); time series that do not fit are left out")
      ->check(number_between(0.0, 1e4));
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
