#include "test/fuzz/harness.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

#include "robot/text_input.h"
#include "scenarios/document_limits.h"
#include "scenarios/laid_terrain.h"

namespace dob::fuzz {
namespace {

std::filesystem::path make_directory() {
  std::error_code missing;
  const bool memory = std::filesystem::is_directory("/dev/shm", missing);
  const std::filesystem::path base = memory ? "/dev/shm" : std::filesystem::temp_directory_path();
  const std::filesystem::path made = base / ("dobbench-fuzz-" + std::to_string(::getpid()));
  std::filesystem::create_directories(made);
  return made;
}

const std::filesystem::path& directory() {
  static const std::filesystem::path instance = make_directory();
  return instance;
}

void remove_directory() {
  std::error_code ignored;
  std::filesystem::remove_all(directory(), ignored);
}

}  // namespace

InputFile::InputFile(const std::string& name) : path_((directory() / name).string()) {
  static const int registered = std::atexit(remove_directory);
  static_cast<void>(registered);
}

const std::string& InputFile::write(std::string_view text) const {
  std::ofstream(path_, std::ios::binary | std::ios::trunc) << text;
  return path_;
}

void finding(const std::string& what) {
  std::fprintf(stderr, "FINDING: %s\n", what.c_str());
  std::abort();
}

void check_refusal(const std::string& message, std::initializer_list<std::string_view> places) {
  if (message.size() > kLongestMessage) finding("a message of " + std::to_string(message.size()) + " bytes");
  if (printable_line(message, 2 * kLongestMessage) != message) finding("not one printable line: " + message);
  const auto begins = [&](std::string_view place) { return message.starts_with(place); };
  const auto* place = std::find_if(places.begin(), places.end(), begins);
  if (place == places.end()) finding("no place: " + message);
  const std::size_t reason = message.find(": ", place->size());
  if (reason == std::string::npos || reason + 2 == message.size()) finding("no reason: " + message);
}

void load_and_resolve(const ScenarioRequest& request) {
  static const InputFile file("resolved.toml");
  constexpr int kOtherSeed = 2;
  for (const Scenario& scenario : load_scenarios(request)) {
    laid_terrain(scenario, kOtherSeed);
    const std::string text = resolved_toml(request, scenario.variant);
    try {
      if (resolved_toml({.name = file.write(text)}, scenario.variant) != text)
        finding("the resolved form loads to another one:\n" + text);
    } catch (const InputError& error) {
      finding("the resolved form is refused: " + std::string(error.what()) + "\n" + text);
    }
  }
}

}  // namespace dob::fuzz
