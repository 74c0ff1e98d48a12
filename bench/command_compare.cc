#include <memory>

#include <fmt/format.h>

#include "bench/commands.h"
#include "results/compare.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

const MetricField& find_metric(const std::string& name) {
  std::string there;
  for (const MetricField& field : kMetricFields) {
    if (field.name == name) return field;
    there += fmt::format("{}{}", there.empty() ? "" : ", ", field.name);
  }
  throw InputError(fmt::format("--metric {}: no such metric, allowed: {}", name, there));
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  struct CompareArguments {
    std::string a, b;
    std::string metric = "com_error_max_m";
  };
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "two run directories, run by run: exit code 1 when B is worse");
  command->add_option("A", arguments->a, "run directory: what was")->required();
  command->add_option("B", arguments->b, "run directory: what is")->required();
  command->add_option("--metric", arguments->metric, "what is compared besides falls (default com_error_max_m)");
  return [arguments] {
    const MetricField& metric = find_metric(arguments->metric);
    const Comparison comparison = compare_runs(read_run(arguments->a), read_run(arguments->b), metric);
    fmt::print("A: {}\nB: {}\n{}", arguments->a, arguments->b, comparison_text(comparison));
    return comparison.regression() ? kExitSaysNo : kExitOk;
  };
}

}  // namespace dob
