#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "bench/batch_plan.h"
#include "bench/commands.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

std::string check_robot(const std::string& file) {
  const RobotDescription robot = load_robot(file, Forward::kPlusX);
  return fmt::format("robot description '{}', {:.3f} kg", robot.name, robot.total_mass());
}

// With its own gains, then as a batch plans it: its own observers, a pose that the legs can reach.
std::string check_scenario(const std::string& file) {
  const ScenarioInfo info = scenario_info(file);
  for (const Scenario& scenario : load_scenarios({.name = file})) {
    const std::vector<std::string> late = late_loads({.name = file}, scenario.variant, true);
    if (!late.empty()) throw InputError(late.front());
  }
  BatchRequest request{.scenarios = {file}};
  if (info.observers.empty()) request.observers = {"none"};
  const BatchPlan plan = plan_batch(request);
  return fmt::format("scenario '{}' of set {}, {} to run", info.name, to_string(info.set), plan.scenarios.size());
}

// What the file holds; throws when something in it is wrong.
std::string check_file(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".urdf") return check_robot(file);
  if (extension != ".toml")
    throw InputError({file}, "", "neither a scenario or a profile (.toml) nor a robot description (.urdf)");
  if (!is_profile(file)) return check_scenario(file);
  const std::vector<ObserverConfig> observers = load_profile(file);
  const auto mentioned = [](const ObserverConfig& observer) { return observer.profile != "-"; };
  return fmt::format("profile for {} observers", std::count_if(observers.begin(), observers.end(), mentioned));
}

int check(const std::vector<std::string>& files) {
  int exit_code = kExitOk;
  for (const std::string& file : files) {
    try {
      fmt::print("{}: OK, {}\n", file, check_file(file));
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}\n", error.what());
      exit_code = kExitBadInput;
    }
  }
  return exit_code;
}

}  // namespace

Command add_check_command(CLI::App& app) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("check", "say what is wrong with scenarios, profiles and robot descriptions");
  command->add_option("file", *files, "FILE.toml or FILE.urdf; all are checked, whatever the others are")->required();
  return [files] { return check(*files); };
}

}  // namespace dob
