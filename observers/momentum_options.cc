// The options of the momentum observer, above all the ways to give its gains.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "observers/filter_family.h"
#include "observers/momentum.h"

namespace dob {
namespace {

constexpr std::string_view kOptionsOf = "momentum";
constexpr NumberRange kGains{.above = 0.0, .max = 1e6};          // [rad/s], far above what any tick holds
constexpr NumberRange kCoefficients{.above = 0.0, .max = 1e48};  // the same to the power of the largest order

FilterFamily family_of(std::string_view word) {
  if (word == "bessel") return FilterFamily::kBessel;
  return word == "butterworth" ? FilterFamily::kButterworth : FilterFamily::kBinomial;
}

// The one of kMomentumGainKeys that is there, or "gains".
std::string_view way_to_give_gains(const ObserverOptions& options) {
  std::string_view way;
  for (const std::string_view key : kMomentumGainKeys) {
    const auto it = options.find(std::string(key));
    if (it == options.end()) continue;
    if (!way.empty()) {
      throw OptionError(
          kOptionsOf, key, it->second,
          fmt::format("{} is given as well; allowed is one of {}", way, fmt::join(kMomentumGainKeys, ", ")));
    }
    way = key;
  }
  return way.empty() ? kMomentumGainKeys.front() : way;
}

void refuse(const ObserverOptions& options, const std::string& key, const std::string& reason) {
  if (const auto it = options.find(key); it != options.end()) throw OptionError(kOptionsOf, key, it->second, reason);
}

void require(const ObserverOptions& options, const std::string& key) {
  if (options.contains(key)) return;
  throw OptionError(kOptionsOf, "family", options.at("family"), fmt::format("it needs {}, too", key));
}

}  // namespace

MomentumOptions read_momentum_options(const ObserverOptions& options) {
  OptionReader reader(kOptionsOf, options);
  MomentumOptions result;
  const std::string_view way = way_to_give_gains(options);
  std::vector<double> K = reader.list("gains", result.gains.K, kGains, kMaxMomentumOrder);
  const std::vector<double> c = reader.list("coefficients", {}, kCoefficients, kMaxMomentumOrder);
  const FilterFamily family = family_of(reader.choice("family", {"bessel", "butterworth", "binomial"}));
  const double width = reader.number("bandwidth_rad_s", 1.0, kGains);
  result.gain_scale = reader.number("gain_scale", result.gain_scale, kGains);
  const int count = static_cast<int>(way == "coefficients" ? c.size() : K.size());
  const int order = reader.integer("order", count, 1, kMaxMomentumOrder);
  if (reader.choice("coriolis", {"exact", "neglected"}) == "neglected") result.coriolis = Coriolis::kNeglected;
  result.allow_unstable = reader.flag("allow_unstable", result.allow_unstable);
  reader.refuse_unknown();

  if (way == "family") {
    require(options, "order");
    require(options, "bandwidth_rad_s");
    refuse(options, "gain_scale", "a family's bandwidth is bandwidth_rad_s, and nothing scales it");
    result.gains = family_gains(family, order, width);
    return result;
  }
  refuse(options, "bandwidth_rad_s", "it goes with a family: bessel, butterworth or binomial");
  if (order != count) {
    const std::string last =
        way == "coefficients" ? fmt::format("c_0;...;c_{}", order - 1) : fmt::format("gains K_1;...;K_{}", order);
    throw OptionError(kOptionsOf, "order", static_cast<double>(order),
                      fmt::format("it needs as many {}, there are {}", last, count));
  }
  result.gains = way == "coefficients" ? gains_from_coefficients(c) : MomentumGains{std::move(K)};
  return result;
}

}  // namespace dob
