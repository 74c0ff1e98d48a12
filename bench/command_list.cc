#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "bench/campaign_spec.h"
#include "bench/commands.h"
#include "controller/wbc_solver.h"
#include "observers/factory.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

using Json = nlohmann::ordered_json;

Json scenarios() {
  Json list = Json::array();
  for (const ScenarioInfo& info : list_scenarios()) {
    Json observers = Json::array();
    for (const WrittenText& specification : info.observers) observers.push_back(specification.text);
    list.push_back({{"name", info.name},
                    {"set", to_string(info.set)},
                    {"summary", info.summary},
                    {"variants", info.variants},
                    {"observers", observers}});
  }
  return list;
}

Json observers() {
  Json list = Json::array();
  for (const ObserverInfo& info : built_in_observers()) {
    list.push_back({{"name", info.name},
                    {"summary", info.summary},
                    {"estimates_legs", info.estimates_legs},
                    {"estimates_com", info.estimates_com},
                    {"oracle", info.oracle},
                    {"source", info.source}});
  }
  return list;
}

Json named(const std::vector<std::string>& names) {
  Json list = Json::array();
  for (const std::string& name : names) list.push_back({{"name", name}});
  return list;
}

Json campaigns() {
  Json list = Json::array();
  for (const auto& [name, summary] : list_campaigns()) list.push_back({{"name", name}, {"summary", summary}});
  return list;
}

Json solvers() {
  Json list = Json::array();
  for (const WbcSolverInfo& info : wbc_solvers()) list.push_back({{"name", info.name}, {"summary", info.summary}});
  return list;
}

void print_section(const std::string& title, const Json& list) {
  fmt::print("{}\n", title);
  for (const Json& item : list) {
    const std::string set = item.contains("set") ? fmt::format("{:<6} ", item["set"].get<std::string>()) : "";
    fmt::print("  {:<18} {}{}\n", item["name"].get<std::string>(), set, item.value("summary", ""));
    const auto variants = item.value("variants", std::vector<std::string>{});
    if (!variants.empty()) fmt::print("  {:<18} variants: {}\n", "", fmt::join(variants, ", "));
  }
}

}  // namespace

Command add_list_command(CLI::App& app) {
  struct ListArguments {
    std::string what;
    bool json = false;
  };
  auto arguments = std::make_shared<ListArguments>();
  CLI::App* command = app.add_subcommand("list", "what there is to run");
  command
      ->add_option("what", arguments->what,
                   "scenarios, observers, profiles (with gain sets), solvers or campaigns; all by default")
      ->check(CLI::IsMember({"scenarios", "observers", "profiles", "solvers", "campaigns"}));
  command->add_flag("--json", arguments->json, "as JSON");
  return [arguments] {
    const Json all{{"scenarios", scenarios()},         {"observers", observers()}, {"profiles", named(list_profiles())},
                   {"gains", named(list_gain_sets())}, {"solvers", solvers()},     {"campaigns", campaigns()}};
    const auto wanted = [&](const std::string& section) {
      return arguments->what.empty() || section == arguments->what ||
             (section == "gains" && arguments->what == "profiles");
    };
    Json chosen = Json::object();
    for (const auto& [section, list] : all.items()) {
      if (!wanted(section)) continue;
      chosen[section] = list;
      if (!arguments->json) print_section(section, list);
    }
    if (arguments->json) fmt::print("{}\n", chosen.dump(2));
    return kExitOk;
  };
}

}  // namespace dob
