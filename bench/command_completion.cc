#include <memory>

#include <fmt/format.h>

#include "bench/commands.h"
#include "bench/completion.h"
#include "controller/motion_planner.h"
#include "observers/factory.h"
#include "results/metric_fields.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

// Each asks the program itself for what fits, so that nothing in it can go stale. A file name where nothing does.
constexpr const char* kBash = R"(# bash completion of dobbench; written by `dobbench completion bash`
_dobbench() {
  local IFS=$'\n'
  COMPREPLY=($("${COMP_WORDS[0]}" __complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
}
complete -o default -F _dobbench dobbench
)";

constexpr const char* kZsh = R"(#compdef dobbench
# zsh completion of dobbench; written by `dobbench completion zsh`
_dobbench() {
  local -a fitting
  fitting=("${(@f)$("${words[1]}" __complete "${(@)words[2,CURRENT]}" 2>/dev/null)}")
  if [[ -n "${fitting[1]}" ]]; then compadd -a fitting; else _files; fi
}
if [[ "${funcstack[1]}" = _dobbench ]]; then _dobbench "$@"; else compdef _dobbench dobbench; fi
)";

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  for (const ScenarioInfo& info : list_scenarios()) {
    names.push_back(info.name);
    for (const std::string& variant : info.variants) names.push_back(info.name + "/" + variant);
  }
  return names;
}

std::vector<std::string> observer_names() {
  std::vector<std::string> names;
  for (const ObserverInfo& info : built_in_observers()) names.emplace_back(info.name);
  return names;
}

std::vector<std::string> metrics() {
  std::vector<std::string> names;
  names.reserve(kMetricFields.size());
  for (const MetricField& field : kMetricFields) names.emplace_back(field.name);
  return names;
}

// The sets, and the scenario's own.
std::vector<std::string> gains() {
  std::vector<std::string> names = list_gain_sets();
  names.emplace_back("own");
  return names;
}

std::vector<std::string> planners() {
  std::vector<std::string> names;
  for (const PlannerKind kind : {PlannerKind::kZmp, PlannerKind::kSpline, PlannerKind::kPaperSplit}) {
    names.emplace_back(to_string(kind));
  }
  return names;
}

}  // namespace

int print_completions(const CLI::App& app, const std::vector<std::string>& words) {
  const NameSources names{{"scenario", scenario_names}, {"observer", observer_names}, {"--observer", observer_names},
                          {"--shadow", observer_names}, {"--profile", list_profiles}, {"--gains", gains},
                          {"--planner", planners},      {"--metric", metrics},        {"--reference", observer_names}};
  for (const std::string& word : completions(app, words, names)) fmt::print("{}\n", word);
  return kExitOk;
}

Command add_completion_command(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "what a shell needs to complete dobbench's command line");
  command->add_option("shell", *shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  return [shell] {
    fmt::print("{}", *shell == "bash" ? kBash : kZsh);
    return kExitOk;
  };
}

}  // namespace dob
