#include <cerrno>
#include <csignal>
#include <cstdio>
#include <map>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/command_examples.h"
#include "bench/commands.h"
#include "bench/shell_words.h"
#include "results/whole_file.h"
#include "robot/text_input.h"
#include "scenarios/input_error.h"

namespace {

// What messages repeat of the command line or of a file is not to reach the terminal as it is.
void print_error(const std::exception& error) {
  constexpr std::size_t kLongest = 4000;  // [bytes]
  fmt::print(stderr, "dobbench: {}\n", dob::printable_line(error.what(), kLongest));
}

std::string command_line(int argc, char** argv) {
  return dob::join_words({argv, argv + argc});
}

int run(int argc, char** argv) {
  CLI::App app("Compares disturbance observers on a torque-controlled quadruped in the Open Dynamics Engine.");
  app.require_subcommand(1);
  const dob::BuildInfo build = dob::build_info();
  app.set_version_flag("--version", fmt::format("dobbench {} ({}, {}, {})", build.version, build.commit,
                                                build.build_type, build.compiler));
  const std::map<std::string, dob::Command> commands{
      {"analyse", dob::add_analyse_command(app)},
      {"campaign", dob::add_campaign_command(app, command_line(argc, argv))},
      {"check", dob::add_check_command(app)},
      {"compare", dob::add_compare_command(app)},
      {"completion", dob::add_completion_command(app)},
      {"figures", dob::add_figures_command(app)},
      {"list", dob::add_list_command(app)},
      {"manual", dob::add_manual_command(app)},
      {"merge", dob::add_merge_command(app)},
      {"report", dob::add_report_command(app)},
      {"run", dob::add_run_command(app, command_line(argc, argv))},
      {"slurm", dob::add_slurm_command(app)},
      {"table", dob::add_table_command(app)},
      {"timing", dob::add_timing_command(app, command_line(argc, argv))},
      {"tune", dob::add_tune_command(app, command_line(argc, argv))},
      {"verify", dob::add_verify_command(app)},
  };
  dob::finish_help(app);
  if (argc > 1 && std::string_view(argv[1]) == "__complete")
    return dob::print_completions(app, {argv + 2, argv + argc});
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    print_error(error);
    return dob::kExitBadInput;
  }
  return commands.at(app.get_subcommands().front()->get_name())();
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing it, not the end of the program
  try {
    const int code = run(argc, argv);
    if (std::fflush(stdout) == 0) return code;
    throw dob::WriteError("standard output: " + std::generic_category().message(errno));
  } catch (const dob::WriteError& error) {
    print_error(error);
    return dob::kExitCannotWrite;
  } catch (const std::exception& error) {
    print_error(error);
    return std::ferror(stdout) != 0 ? dob::kExitCannotWrite : dob::kExitBadInput;
  }
}
