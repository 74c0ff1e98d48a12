#include "bench/completion.h"

#include <algorithm>

namespace dob {
namespace {

using Words = std::vector<std::string>;

const CLI::Option* find_option(const CLI::App& command, const std::string& word) {
  if (word.size() < 2 || word[0] != '-') return nullptr;
  return command.get_option_no_throw(word);
}

bool takes_a_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

Words values_of(const CLI::Option& option, const std::string& name, const NameSources& names) {
  if (Words choices = choices_of(option); !choices.empty()) return choices;
  const auto source = names.find(name);
  return source == names.end() ? Words{} : source->second();
}

Words option_names_of(const CLI::App& command) {
  Words options;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() && !option->get_group().empty()) options.push_back(option->get_name());
  }
  return options;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

Words names_of_commands(const CLI::App& app) {
  Words names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  return names;
}

const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  const auto commands = commands_of(app);
  const auto it = std::find_if(commands.begin(), commands.end(), [&](const auto* c) { return c->get_name() == name; });
  return it == commands.end() ? nullptr : *it;
}

// Of a command that takes several positional arguments, each has its own; the last may be repeated.
Words positionals_of(const CLI::App& command, std::size_t before, const NameSources& names) {
  const auto positionals = command.get_options([](const CLI::Option* option) { return option->get_positional(); });
  if (positionals.empty()) return {};
  const CLI::Option& option = *positionals[std::min(before, positionals.size() - 1)];
  if (before >= positionals.size() && option.get_items_expected_max() <= 1) return {};
  return values_of(option, option.get_name(true), names);
}

Words of_command(const CLI::App& command, const Words& before, const std::string& begun, const NameSources& names) {
  const CLI::Option* waiting = nullptr;
  std::size_t positionals = 0;
  for (const std::string& word : before) {
    const CLI::Option* option = waiting == nullptr ? find_option(command, word) : nullptr;
    if (option == nullptr && waiting == nullptr) ++positionals;
    waiting = option != nullptr && takes_a_value(*option) ? option : nullptr;
  }
  if (waiting != nullptr) return values_of(*waiting, waiting->get_name(), names);
  if (begun.starts_with("-")) return option_names_of(command);
  return positionals_of(command, positionals, names);
}

}  // namespace

std::vector<std::string> choices_of(const CLI::Option& option) {
  // The library keeps them only as the description of the check: `{a,b}`, or `value in {a->0,b->1} OR {0,1}`.
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open == std::string::npos ? 0 : open);
  if (open == std::string::npos || close == std::string::npos) return {};
  Words choices;
  for (const std::string& choice : CLI::detail::split(type.substr(open + 1, close - open - 1), ',')) {
    choices.push_back(choice.substr(0, choice.find("->")));
  }
  return choices;
}

std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words,
                                     const NameSources& names) {
  Words before;
  std::copy_if(words.begin(), words.end(), std::back_inserter(before), [](const auto& word) { return word != "="; });
  std::string begun;
  if (!words.empty() && words.back() != "=") {
    begun = before.back();
    before.pop_back();
  }
  Words fitting;
  if (before.empty()) {
    fitting = begun.starts_with("-") ? option_names_of(app) : names_of_commands(app);
  } else if (const CLI::App* command = find_command(app, before.front()); command != nullptr) {
    fitting = of_command(*command, {before.begin() + 1, before.end()}, begun, names);
  }
  std::erase_if(fitting, [&](const std::string& word) { return !word.starts_with(begun); });
  std::sort(fitting.begin(), fitting.end());
  return fitting;
}

}  // namespace dob
