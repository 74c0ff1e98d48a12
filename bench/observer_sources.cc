#include "bench/observer_sources.h"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "observers/pair.h"
#include "observers/plugin.h"
#include "results/fingerprint.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

class ObserverSources {
 public:
  std::string source_of(const PlannedObserver& planned) {
    std::string source;
    add_libraries(source, planned.observer);
    for (const ObserverConfig& shadow : planned.shadows) add_libraries(source, shadow);
    return source + observer_toml(planned.observer, planned.shadows);
  }

 private:
  void add_libraries(std::string& source, const ObserverConfig& observer) {
    const auto pair = parse_pair_name(observer.observer);
    const auto parts = pair ? std::vector{pair->legs, pair->com} : std::vector{std::string_view(observer.observer)};
    for (const std::string_view part : parts) {
      if (is_plugin_path(part)) source += fmt::format("# {} holds {}\n", part, held_by(std::string(part)));
    }
  }

  const std::string& held_by(const std::string& library) {
    const auto [it, added] = held_.emplace(library, "");
    if (added) it->second = file_fingerprint(library);
    return it->second;
  }

  std::map<std::string, std::string> held_;  // library -> fingerprint
};

}  // namespace

std::vector<std::string> observer_sources(const BatchPlan& plan) {
  ObserverSources sources;
  std::vector<std::string> texts;
  for (const PlannedObserver& observer : plan.observers) texts.push_back(sources.source_of(observer));
  return texts;
}

}  // namespace dob
