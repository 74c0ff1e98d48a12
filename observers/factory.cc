#include "observers/factory.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "observers/com_wrench.h"
#include "observers/contact_consistent.h"
#include "observers/direct.h"
#include "observers/eso.h"
#include "observers/kalman.h"
#include "observers/momentum.h"
#include "observers/momentum_exact.h"
#include "observers/none.h"
#include "observers/nonlinear_dob.h"
#include "observers/oracle.h"
#include "observers/pair.h"
#include "observers/plugin.h"
#include "observers/sliding_mode.h"

namespace dob {
namespace {

using Made = std::unique_ptr<DisturbanceObserver>;

Made make_none(const ObserverOptions& options, double /*dt*/) {
  OptionReader("none", options).refuse_unknown();
  return std::make_unique<NoObserver>();
}

Made make_oracle(std::string_view name, bool com, const ObserverOptions& options) {
  OptionReader(name, options).refuse_unknown();
  return std::make_unique<OracleObserver>(name, true, com);
}

Made make_oracle_legs(const ObserverOptions& options, double /*dt*/) {
  return make_oracle("oracle_legs", false, options);
}

Made make_oracle_full(const ObserverOptions& options, double /*dt*/) {
  return make_oracle("oracle_full", true, options);
}

Made make_momentum(const ObserverOptions& options, double dt) {
  return std::make_unique<MomentumObserver>(read_momentum_options(options), dt);
}

Made make_com_wrench(const ObserverOptions& options, double dt) {
  return std::make_unique<ComWrenchObserver>(read_com_wrench_options(options), dt);
}

Made make_momentum_com(const ObserverOptions& options, double dt) {
  return make_pair_observer("momentum_com", make_momentum, make_com_wrench, options, dt);
}

Made make_nonlinear_dob(const ObserverOptions& options, double dt) {
  return std::make_unique<NonlinearDobObserver>(read_nonlinear_dob_options(options), dt);
}

Made make_direct(const ObserverOptions& options, double dt) {
  return std::make_unique<DirectObserver>(read_direct_options(options), dt);
}

Made make_contact_consistent(const ObserverOptions& options, double dt) {
  return std::make_unique<ContactConsistentObserver>(options, dt);
}

Made make_momentum_exact(const ObserverOptions& options, double dt) {
  return std::make_unique<MomentumExactObserver>("momentum_exact", options, dt);
}

Made make_kalman(const ObserverOptions& options, double dt) {
  return std::make_unique<KalmanObserver>("kalman", options, dt);
}

Made make_eso(const ObserverOptions& options, double dt) {
  return std::make_unique<EsoObserver>("eso", options, dt);
}

Made make_sliding_mode(const ObserverOptions& options, double dt) {
  return std::make_unique<SlidingModeObserver>("sliding_mode", options, dt);
}

Made make_com_momentum_exact(const ObserverOptions& options, double dt) {
  return std::make_unique<ComMomentumExactObserver>("com_momentum_exact", options, dt);
}

Made make_com_kalman(const ObserverOptions& options, double dt) {
  return std::make_unique<ComKalmanObserver>("com_kalman", options, dt);
}

Made make_com_eso(const ObserverOptions& options, double dt) {
  return std::make_unique<ComEsoObserver>("com_eso", options, dt);
}

Made make_com_sliding_mode(const ObserverOptions& options, double dt) {
  return std::make_unique<ComSlidingModeObserver>("com_sliding_mode", options, dt);
}

constexpr std::array kBuiltIn{
    ObserverInfo{.name = "none",
                 .summary = "no observer: the undisturbed controller as it is",
                 .source = "baseline",
                 .make = make_none},
    ObserverInfo{.name = "momentum",
                 .summary = "momentum of all legs, any order r: disturbance forces at the leg tips",
                 .source = "Morlando et al. 2021, section 3.2, eqs (6)-(9)",
                 .estimates_legs = true,
                 .make = make_momentum},
    ObserverInfo{.name = "com_wrench",
                 .summary = "momentum of the whole robot, first order: disturbance wrench about the CoM",
                 .source = "Focchi et al. 2020, the paper's baseline [2]",
                 .estimates_com = true,
                 .make = make_com_wrench},
    ObserverInfo{.name = "momentum_com",
                 .summary = "momentum for the legs and com_wrench for the CoM, side by side",
                 .source = "ours (leg and CoM momentum together)",
                 .estimates_legs = true,
                 .estimates_com = true,
                 .make = make_momentum_com},
    ObserverInfo{.name = "nonlinear_dob",
                 .summary = "nonlinear disturbance observer on the legs' accelerations: forces at the leg tips",
                 .source = "Dini & Majd 2019, the paper's baseline [24]; Chen et al. 2000",
                 .estimates_legs = true,
                 .make = make_nonlinear_dob},
    ObserverInfo{.name = "momentum_exact",
                 .summary = "momentum of all legs, first order, exact at any tick",
                 .source = "De Luca et al. 2006; Haddadin et al. 2017",
                 .estimates_legs = true,
                 .make = make_momentum_exact},
    ObserverInfo{.name = "kalman",
                 .summary = "Kalman filter on the momentum of all legs, disturbance a random walk",
                 .source = "Wahrburg et al. 2018",
                 .estimates_legs = true,
                 .make = make_kalman},
    ObserverInfo{.name = "eso",
                 .summary = "linear extended-state observer on the momentum of all legs",
                 .source = "Gao 2003",
                 .estimates_legs = true,
                 .make = make_eso},
    ObserverInfo{.name = "sliding_mode",
                 .summary = "super-twisting observer on the momentum of all legs, implicit in time",
                 .source = "Garofalo et al. 2019",
                 .estimates_legs = true,
                 .make = make_sliding_mode},
    ObserverInfo{.name = "direct",
                 .summary = "equation of motion of the legs with differenced accelerations, low-passed",
                 .source = "textbook",
                 .estimates_legs = true,
                 .make = make_direct},
    ObserverInfo{.name = "contact_consistent",
                 .summary = "stance forces projected out, no force sensors: swinging legs and CoM",
                 .source = "after Lee et al. 2018",
                 .estimates_legs = true,
                 .estimates_com = true,
                 .make = make_contact_consistent},
    ObserverInfo{.name = "com_momentum_exact",
                 .summary = "com_wrench, exact at any tick",
                 .source = "as momentum_exact, on the CoM",
                 .estimates_com = true,
                 .make = make_com_momentum_exact},
    ObserverInfo{.name = "com_kalman",
                 .summary = "Kalman filter on the momentum of the whole robot",
                 .source = "as kalman, on the CoM",
                 .estimates_com = true,
                 .make = make_com_kalman},
    ObserverInfo{.name = "com_eso",
                 .summary = "linear extended-state observer on the momentum of the whole robot",
                 .source = "as eso, on the CoM",
                 .estimates_com = true,
                 .make = make_com_eso},
    ObserverInfo{.name = "com_sliding_mode",
                 .summary = "super-twisting observer on the momentum of the whole robot",
                 .source = "as sliding_mode, on the CoM",
                 .estimates_com = true,
                 .make = make_com_sliding_mode},
    ObserverInfo{.name = "oracle_legs",
                 .summary = "the true disturbance as the legs' estimate: a bound, no observer",
                 .source = "simulator",
                 .estimates_legs = true,
                 .oracle = true,
                 .make = make_oracle_legs},
    ObserverInfo{.name = "oracle_full",
                 .summary = "the true disturbance as estimate of legs and CoM: a bound, no observer",
                 .source = "simulator",
                 .estimates_legs = true,
                 .estimates_com = true,
                 .oracle = true,
                 .make = make_oracle_full},
};

const ObserverInfo& find(std::string_view name) {
  if (const ObserverInfo* info = find_built_in_observer(name)) return *info;
  std::array<std::string_view, kBuiltIn.size()> names;
  std::transform(kBuiltIn.begin(), kBuiltIn.end(), names.begin(), [](const auto& info) { return info.name; });
  throw OptionError(fmt::format("no observer \"{}\"; there are: {}", name, fmt::join(names, ", ")));
}

// How a pair makes one of its parts.
MakeObserver part(std::string_view pair, std::string_view name, bool ObserverInfo::*estimates,
                  std::string_view part_name) {
  const bool plugin = is_plugin_path(name);
  const ObserverInfo info = plugin ? load_plugin(name) : find(name);
  if (info.*estimates && !info.oracle) {
    if (!plugin) return info.make;
    return [file = std::string(name)](const ObserverOptions& options, double dt) {
      return make_from_plugin(file, options, dt);
    };
  }
  std::vector<std::string_view> names;
  for (const ObserverInfo& other : kBuiltIn) {
    if (other.*estimates && !other.oracle) names.push_back(other.name);
  }
  throw OptionError(
      fmt::format("observer {}: {} cannot be {}; there are: {}", pair, name, part_name, fmt::join(names, ", ")));
}

}  // namespace

std::span<const ObserverInfo> built_in_observers() noexcept {
  return kBuiltIn;
}

const ObserverInfo* find_built_in_observer(std::string_view name) noexcept {
  const auto found =
      std::find_if(kBuiltIn.begin(), kBuiltIn.end(), [&](const auto& info) { return info.name == name; });
  return found == kBuiltIn.end() ? nullptr : &*found;
}

bool is_oracle(std::string_view name) noexcept {
  const ObserverInfo* info = find_built_in_observer(name);
  return info != nullptr && info->oracle;
}

std::unique_ptr<DisturbanceObserver> make_observer(std::string_view name, const ObserverOptions& options, double dt) {
  if (const auto pair = parse_pair_name(name)) {
    return make_pair_observer(name, part(name, pair->legs, &ObserverInfo::estimates_legs, "legs"),
                              part(name, pair->com, &ObserverInfo::estimates_com, "com"), options, dt);
  }
  if (is_plugin_path(name)) return make_from_plugin(name, options, dt);
  return find(name).make(options, dt);
}

}  // namespace dob
