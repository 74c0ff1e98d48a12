#include "bench/plugin_consent.h"

#include <algorithm>
#include <functional>
#include <system_error>

#include <fmt/format.h>

#include "bench/batch.h"
#include "bench/worker_pool.h"
#include "scenarios/input_error.h"
#include "scenarios/loader.h"
#include "scenarios/plugin_files.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeToLoad = 60.0;  // [s]

std::vector<std::string> specifications_of(const BatchRequest& request) {
  std::vector<std::string> all = request.observers;
  all.insert(all.end(), request.shadows.begin(), request.shadows.end());
  return all;
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

void load_with_every_profile(const std::string& specification, const std::vector<std::string>& profiles) {
  for (const std::string& profile : profiles) {
    try {
      load_observer(specification, profile);
    } catch (const std::exception&) {
      // said when the batch is planned
    }
  }
}

}  // namespace

void require_consent(const BatchRequest& of_run, const std::vector<fs::path>& named, const std::string& source) {
  for (const std::string& specification : specifications_of(of_run)) {
    for (const std::string& file : plugin_files(specification)) {
      const auto same = [&](const fs::path& other) { return same_file(file, other); };
      if (std::any_of(named.begin(), named.end(), same)) continue;
      throw InputError(
          fmt::format("{}: the run was begun with the plugin {}, code that would run here; if you trust it, "
                      "name it again: --plugin {}",
                      source, file, file));
    }
  }
}

void try_plugins(const BatchRequest& request) {
  const std::vector<std::string> profiles = request.profiles.empty() ? list_profiles() : request.profiles;
  for (const std::string& specification : specifications_of(request)) {
    if (plugin_files(specification).empty()) continue;
    std::string reason;
    const int signal = run_in_processes(
        1, {.jobs = 1, .timeout_s = kTimeToLoad, .memory_limit_MB = kDefaultMemoryLimit_MB},
        [&](std::size_t) {
          load_with_every_profile(specification, profiles);
          return std::string();
        },
        [&](std::size_t, const TaskOutcome& outcome) { reason = outcome.reason; });
    if (signal != 0) reason = "interrupted";
    if (!reason.empty()) throw InputError(fmt::format("--observer {}: while it was loaded: {}", specification, reason));
  }
}

}  // namespace dob
