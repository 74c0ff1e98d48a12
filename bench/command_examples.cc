#include "bench/command_examples.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/completion.h"

namespace dob {

const std::vector<CommandExample>& command_examples() {
  static const std::vector<CommandExample> examples{
      {"list", "dobbench list", "scenarios, observers, profiles, gain sets and solvers"},
      {"list", "dobbench list observers --json", "for a program"},
      {"run", "dobbench run case1/tip_lateral --observer none --observer momentum --profile tuned --seeds 2",
       "one variant of a scenario, two observers, seeds 1 and 2"},
      {"run",
       "dobbench run undisturbed --observer momentum:gain_scale=10 --profile paper --set duration_s=5 --out fast",
       "options of an observer, a key of the scenario, a directory of one's own"},
      {"run", "dobbench run --resume --out fast", "goes on with a run that was stopped"},
      {"run", "dobbench run undisturbed --observer none --set duration_s=1 --seeds 2 --shard 1/2 --out parts/1",
       "the first half of a run; the other one with"},
      {"run", "dobbench run undisturbed --observer none --set duration_s=1 --seeds 2 --shard 2/2 --out parts/2",
       "and then: dobbench merge"},
      {"table", "dobbench table dobbench-results/0001 --format csv", "the table as a file for another program"},
      {"table", "dobbench table dobbench-results/0001 --claims", "the paper's claims beside what was measured"},
      {"report", "dobbench report dobbench-results/0001", "one page for a browser: report.html in that directory"},
      {"figures", "dobbench figures dobbench-results/0001 --format svg",
       "the paper's figures of this run; needs gnuplot"},
      {"campaign", "dobbench campaign limits --plan",
       "how much there is to do; without --plan: the force at which trials begin to fall"},
      {"merge", "dobbench merge parts/1 parts/2 --out merged", "both halves as one run"},
      {"compare", "dobbench compare dobbench-results/0001 dobbench-results/0001 --metric foot_error_max_m",
       "exit code 1 when the second is worse"},
      {"verify", "dobbench verify dobbench-results/0001 --sample 2", "runs two of its cells again: the same bits?"},
      {"timing", "dobbench timing --seconds 1 --out dobbench-results/0001",
       "how long a tick takes, one cell after the other; then: table --timing"},
      {"analyse", "dobbench analyse momentum --profile paper", "poles, bandwidth, delay, noise gain"},
      {"check", "dobbench check dobbench-results/0001/scenarios/*.toml", "says what is wrong with a file, and where"},
      {"tune", "dobbench tune momentum --budget 1 --out tuned",
       "the first candidate alone; 24 made the profile 'tuned'"},
      {"slurm", "dobbench slurm limit.toml --tasks 4 --cpus 2 --time 01:00:00 --out on_slurm",
       "the campaign limit.toml as four tasks; then: on_slurm/submit"},
      {"completion", "dobbench completion bash > dobbench.bash", "then: source dobbench.bash"},
      {"manual", "dobbench manual > dobbench.1", "then: man -l dobbench.1"},
  };
  return examples;
}

namespace {

void show_choices(CLI::Option& option) {
  const std::vector<std::string> choices = choices_of(option);
  if (choices.empty()) return;
  option.option_text(fmt::format("{{{}}}{}", fmt::join(choices, ","), option.get_required() ? " REQUIRED" : ""));
}

}  // namespace

void finish_help(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    for (CLI::Option* option : command->get_options()) show_choices(*option);
    std::string text;
    for (const CommandExample& example : command_examples()) {
      if (example.command == command->get_name()) text += fmt::format("  {}\n      {}\n", example.line, example.what);
    }
    if (text.empty()) continue;
    const std::string more = command->get_footer();
    command->footer("Examples:\n" + text + (more.empty() ? "" : "\n" + more));
  }
}

}  // namespace dob
