#include <algorithm>
#include <map>
#include <memory>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "bench/commands.h"
#include "bench/number_between.h"
#include "bench/verify.h"

namespace dob {
namespace {

struct VerifyArguments {
  std::string dir;
  VerifyOptions options;
  TableFormat format = TableFormat::kText;
};

int run(VerifyArguments& arguments) {
  arguments.options.progress = ::isatty(STDERR_FILENO) == 1;
  const VerifyResult result = verify_run(arguments.dir, arguments.options);
  const Verification& v = result.verification;
  fmt::print("{}", verification_text(v, arguments.format));
  if (result.stop_signal != 0) return kExitSignal + result.stop_signal;
  const bool bits_differ = v.across.empty() && v.count(Reproduced::kDifferent) > 0;
  if (bits_differ || v.count(Reproduced::kFlipped) > 0) return kExitSaysNo;
  return v.count(Reproduced::kNotVerified) > 0 ? kExitCellErrors : kExitOk;
}

}  // namespace

Command add_verify_command(CLI::App& app) {
  const std::map<std::string, TableFormat> formats{
      {"text", TableFormat::kText}, {"md", TableFormat::kMarkdown}, {"csv", TableFormat::kCsv}};
  auto arguments = std::make_shared<VerifyArguments>();
  VerifyOptions& options = arguments->options;
  options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("verify", "computes cells of a run again and compares them bit for bit");
  command->add_option("dir", arguments->dir, "run directory")->required()->type_name("DIR");
  command->add_option("--sample", options.sample, "finished cells, drawn at random (default 20); 0: all")
      ->check(CLI::Range(0, 1'000'000))
      ->type_name("N");
  command->add_option("--seed", options.seed, "of the drawing (default 1)")
      ->check(CLI::Range(1L, 1'000'000'000L))
      ->type_name("N");
  command->add_option("--jobs", options.jobs, "cells at a time (default: the cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->add_option("--timeout", options.timeout_s, "wall time for one cell [s]; 0: none")
      ->check(number_between(0.0, 1e9))
      ->type_name("S");
  command->add_option("--format", arguments->format, "of the answer (default text); csv has every cell")
      ->transform(CLI::CheckedTransformer(formats))
      ->type_name("text|md|csv");
  command->add_flag(
      "--across", options.across,
      "also rows of another program, code path or processor: outcomes, and how far the metrics lie apart");
  command
      ->add_option("--plugin", options.plugins,
                   "observer's library that may be loaded; without, cells of plugins are not verified")
      ->allow_extra_args(false)
      ->check(CLI::ExistingFile)
      ->type_name("FILE.so");
  command->footer(
      "Exit codes: 0 all equal (--across: no outcome flipped), 1 a difference, 2 bad input, or rows of another\n"
      "program or code path, 3 some cells could not be computed again, 130 and 143 stopped by a signal.");
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
