#include "observers/factory.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "observers/com_wrench.h"
#include "observers/momentum.h"
#include "observers/none.h"
#include "observers/pair.h"
#include "observers/plugin.h"

namespace dob {
namespace {

std::unique_ptr<DisturbanceObserver> make_none(const ObserverOptions& options, double /*dt*/) {
  OptionReader("none", options).refuse_unknown();
  return std::make_unique<NoObserver>();
}

std::unique_ptr<DisturbanceObserver> make_momentum(const ObserverOptions& options, double dt) {
  return std::make_unique<MomentumObserver>(read_momentum_options(options), dt);
}

std::unique_ptr<DisturbanceObserver> make_com_wrench(const ObserverOptions& options, double dt) {
  return std::make_unique<ComWrenchObserver>(read_com_wrench_options(options), dt);
}

std::unique_ptr<DisturbanceObserver> make_momentum_com(const ObserverOptions& options, double dt) {
  return make_pair_observer("momentum_com", make_momentum, make_com_wrench, options, dt);
}

constexpr std::array<ObserverInfo, 4> kBuiltIn{{
    {.name = "none",
     .summary = "no observer: the undisturbed controller as it is",
     .source = "baseline",
     .make = make_none},
    {.name = "momentum",
     .summary = "momentum of all legs, any order r: disturbance forces at the leg tips",
     .source = "Morlando et al. 2021, section 3.2, eqs (6)-(9)",
     .estimates_legs = true,
     .make = make_momentum},
    {.name = "com_wrench",
     .summary = "momentum of the whole robot, first order: disturbance wrench about the CoM",
     .source = "Focchi et al. 2020, the paper's baseline [2]",
     .estimates_com = true,
     .make = make_com_wrench},
    {.name = "momentum_com",
     .summary = "momentum for the legs and com_wrench for the CoM, side by side",
     .source = "ours (leg and CoM momentum together)",
     .estimates_legs = true,
     .estimates_com = true,
     .make = make_momentum_com},
}};

}  // namespace

std::span<const ObserverInfo> built_in_observers() noexcept {
  return kBuiltIn;
}

std::unique_ptr<DisturbanceObserver> make_observer(std::string_view name, const ObserverOptions& options, double dt) {
  const auto found =
      std::find_if(kBuiltIn.begin(), kBuiltIn.end(), [&](const auto& info) { return info.name == name; });
  if (found != kBuiltIn.end()) return found->make(options, dt);
  if (is_plugin_path(name)) return make_from_plugin(name, options, dt);
  std::array<std::string_view, kBuiltIn.size()> names;
  std::transform(kBuiltIn.begin(), kBuiltIn.end(), names.begin(), [](const auto& info) { return info.name; });
  throw OptionError(fmt::format("no observer \"{}\"; there are: {}", name, fmt::join(names, ", ")));
}

}  // namespace dob
