#include "observers/factory.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "observers/momentum.h"
#include "observers/none.h"

namespace dob {
namespace {

std::unique_ptr<DisturbanceObserver> make_none(const ObserverOptions& options, double /*dt*/) {
  OptionReader("none", options).refuse_unknown();
  return std::make_unique<NoObserver>();
}

std::unique_ptr<DisturbanceObserver> make_momentum(const ObserverOptions& options, double dt) {
  return std::make_unique<MomentumObserver>(read_momentum_options(options), dt);
}

constexpr std::array<ObserverInfo, 2> kBuiltIn{{
    {.name = "none",
     .summary = "no observer: the undisturbed controller as it is",
     .source = "baseline",
     .make = make_none},
    {.name = "momentum",
     .summary = "momentum of all legs, any order r: disturbance forces at the leg tips",
     .source = "Morlando et al. 2021, section 3.2, eqs (6)-(9)",
     .estimates_legs = true,
     .make = make_momentum},
}};

}  // namespace

std::span<const ObserverInfo> built_in_observers() noexcept {
  return kBuiltIn;
}

std::unique_ptr<DisturbanceObserver> make_observer(std::string_view name, const ObserverOptions& options, double dt) {
  const auto found =
      std::find_if(kBuiltIn.begin(), kBuiltIn.end(), [&](const auto& info) { return info.name == name; });
  if (found != kBuiltIn.end()) return found->make(options, dt);
  std::array<std::string_view, kBuiltIn.size()> names;
  std::transform(kBuiltIn.begin(), kBuiltIn.end(), names.begin(), [](const auto& info) { return info.name; });
  throw OptionError(fmt::format("no observer \"{}\"; there are: {}", name, fmt::join(names, ", ")));
}

}  // namespace dob
