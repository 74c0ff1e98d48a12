#include "bench/campaign_estimators.h"

#include <fmt/format.h>

#include "bench/plugin_consent.h"
#include "scenarios/loader.h"
#include "scenarios/scenario_source.h"

namespace dob {
namespace {

// An estimator on the wrong side of a factorial would be a factor that does not do what it says.
void require_roles(const CampaignSpec& spec) {
  const auto require = [&](const std::string& key, const Place& place, const std::string& name, const char* pair) {
    if (name == "none") return;
    try {
      load_observer(fmt::format(fmt::runtime(pair), name), spec.profiles.front());
    } catch (const InputError& error) {
      throw InputError(place, key, fmt::format("'{}' cannot stand here: {}", name, error.what()));
    }
  };
  for (const std::string& name : spec.legs) require("legs", spec.observers_place, name, "legs={},com=com_wrench");
  for (const std::string& name : spec.com) require("com", spec.com_place, name, "legs=momentum,com={}");
}

void load_plugins_apart(const CampaignSpec& spec) {
  BatchRequest request;
  for (const auto* names : {&spec.observers, &spec.legs, &spec.com}) {
    request.observers.insert(request.observers.end(), names->begin(), names->end());
  }
  request.profiles = spec.profiles;
  try_plugins(request);
}

}  // namespace

void require_estimators(const CampaignSpec& spec) {
  for (const std::string& profile : spec.profiles) {
    require_known(profile, list_profiles(), spec.profiles_place, "profiles");
  }
  load_plugins_apart(spec);
  require_roles(spec);
}

}  // namespace dob
