#include "bench/manual.h"

#include <fmt/format.h>

#include "bench/command_examples.h"

namespace dob {
namespace {

// Plain text as man(7) wants it: nothing at a line's start is a request, a hyphen is the one that is typed.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (out.empty() && (c == '.' || c == '\'')) {
      out += "\\&";
      out += c;
    } else {
      out += c;
    }
  }
  return out;
}

bool shown(const CLI::Option* option) {
  return !option->get_group().empty();
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return shown(o) && o->get_positional(); });
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return shown(o) && !o->get_positional(); });
}

// Behind the name of an option: the values that it takes, or their kind.
std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  if (!option.get_option_text().empty()) return fmt::format(" \\fI{}\\fR", escaped(option.get_option_text()));
  const std::string type = option.get_type_name();
  return fmt::format(" \\fI{}\\fR", escaped(type.substr(0, type.find(':'))));
}

std::string synopsis(const CLI::App& command) {
  std::string line = fmt::format("\\fBdobbench {}\\fR", escaped(command.get_name()));
  for (const CLI::Option* option : positionals_of(command)) {
    const std::string name = fmt::format("\\fI{}\\fR", escaped(option->get_name(true)));
    const char* more = option->get_items_expected_max() > 1 ? "..." : "";
    line += option->get_required() ? fmt::format(" {}{}", name, more) : fmt::format(" [{}{}]", name, more);
  }
  return line + " [\\fIOPTION\\fR...]";
}

std::string option_entries(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : positionals_of(command)) {
    text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", escaped(option->get_name(true)), escaped(option->get_description()));
  }
  for (const CLI::Option* option : options_of(command)) {
    text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", escaped(option->get_name(false, true)), value_of(*option),
                        escaped(option->get_description()));
  }
  return text;
}

std::string commands_section(const CLI::App& app) {
  std::string text = ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    text += fmt::format(".SS {}\n{}\n.PP\n{}.\n{}", escaped(command->get_name()), synopsis(*command),
                        escaped(command->get_description()), option_entries(*command));
  }
  return text;
}

std::string examples_section() {
  std::string text = ".SH EXAMPLES\n";
  for (const CommandExample& example : command_examples()) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}.\n", escaped(example.line), escaped(example.what));
  }
  return text;
}

constexpr std::string_view kRest = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
A comparison or a verification says no.
.TP
.B 2
Bad input, or something that is needed could not be read; one line on standard error says what and where.
.TP
.B 3
Some cells could not be run; they are rows of the table with their reason.
.TP
.B 4
A run, or standard output, could not be written; what was finished is kept.
.TP
.B 130\fR, \fB143
Stopped by SIGINT or SIGTERM; \fBdobbench run \-\-resume\fR goes on.
.SH ENVIRONMENT
.TP
.B DOBBENCH_SCENARIOS
Directory of the scenarios, gain sets and profiles, instead of the one that came with the program.
.SH FILES
.TP
.I PREFIX/share/dobbench
Scenarios, gain sets, profiles, the robot's description, the paper's claims and figures as data, for a program in
\fIPREFIX/bin\fR.
.TP
.I dobbench\-results/NNNN
Where a run goes that is told nothing else.
.SH SEE ALSO
.BR gnuplot (1),
which draws the figures.
)";

}  // namespace

std::string manual_page(const CLI::App& app, const std::string& version) {
  std::string text = fmt::format(".TH DOBBENCH 1 \"\" \"{}\" \"User Commands\"\n", escaped(version));
  text += ".nh\n.ad l\n";
  text += ".SH NAME\ndobbench \\- compares disturbance observers on a torque\\-controlled quadruped\n";
  text += ".SH SYNOPSIS\n\\fBdobbench\\fR \\fICOMMAND\\fR [\\fIARGUMENT\\fR...]\n";
  text += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}", escaped(app.get_description()), option_entries(app));
  return text + commands_section(app) + examples_section() + std::string(kRest);
}

}  // namespace dob
