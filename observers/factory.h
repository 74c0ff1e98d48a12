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
  bool oracle = false;  // the trial puts the truth in the place of its estimate: a bound, never ranked
  std::unique_ptr<DisturbanceObserver> (*make)(const ObserverOptions& options, double dt) = nullptr;
};

std::span<const ObserverInfo> built_in_observers() noexcept;

// nullptr: none of that name.
const ObserverInfo* find_built_in_observer(std::string_view name) noexcept;

// Whether it is a built-in oracle.
bool is_oracle(std::string_view name) noexcept;

// The observer of that name or plugin (plugin.h), or the pair `legs=NAME,com=NAME` of one that estimates the legs and
// one that estimates the CoM (pair.h; options `legs.KEY` and `com.KEY`), ready for ticks of dt [s]. Throws OptionError:
// no such observer (what() lists those there are), a part that does not estimate its part, an oracle in a pair, or an
// option that it does not take.
std::unique_ptr<DisturbanceObserver> make_observer(std::string_view name, const ObserverOptions& options, double dt);

}  // namespace dob
