// Observers by name: one explicit table of the built-in ones, nothing registers itself; or by the path of a plugin.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

struct ObserverInfo {
  std::string_view name;
  std::string_view summary;  // one line
  std::string_view source;   // where the method comes from
  bool estimates_legs = false;
  bool estimates_com = false;
  std::unique_ptr<DisturbanceObserver> (*make)(const ObserverOptions& options, double dt) = nullptr;
};

std::span<const ObserverInfo> built_in_observers() noexcept;

// The observer of that name or plugin (plugin.h), ready for ticks of dt [s]. Throws OptionError: no such observer
// (what() lists those there are), or an option that it does not take.
std::unique_ptr<DisturbanceObserver> make_observer(std::string_view name, const ObserverOptions& options, double dt);

}  // namespace dob
