#include "observers/pair.h"

#include <fmt/format.h>

namespace dob {
namespace {

constexpr std::string_view kLegsPrefix = "legs.";
constexpr std::string_view kComPrefix = "com.";

std::unique_ptr<DisturbanceObserver> make_part(std::string_view pair, std::string_view prefix, const MakeObserver& make,
                                               const ObserverOptions& options, double dt) {
  ObserverOptions own;
  for (const auto& [key, value] : options) {
    if (key.starts_with(prefix)) own[key.substr(prefix.size())] = value;
  }
  try {
    return make(own, dt);
  } catch (const OptionError& error) {
    const std::string_view part = prefix.substr(0, prefix.size() - 1);
    throw OptionError(fmt::format("observer {}, part {}: {}", pair, part, error.what()));
  }
}

}  // namespace

void PairObserver::reset(const ModelTerms& now) noexcept {
  legs_->reset(now);
  com_->reset(now);
}

Estimate PairObserver::update(const ObserverInput& input) noexcept {
  const Estimate legs = legs_->update(input);
  const Estimate com = com_->update(input);
  Estimate both;
  both.has_legs = legs.has_legs;
  both.leg_torque = legs.leg_torque;
  both.has_com = com.has_com;
  both.com_wrench = com.com_wrench;
  both.status = legs.status != EstimateStatus::kOk ? legs.status : com.status;
  return both;
}

std::optional<LinearChannel> PairObserver::linear(Channel channel) const {
  const auto* part = dynamic_cast<const LinearObserver*>(channel == Channel::kLegTorque ? legs_.get() : com_.get());
  return part == nullptr ? std::nullopt : part->linear(channel);
}

std::optional<PairName> parse_pair_name(std::string_view name) noexcept {
  constexpr std::string_view kFirst = "legs=";
  constexpr std::string_view kSecond = ",com=";
  const std::size_t comma = name.find(',');
  if (!name.starts_with(kFirst) || comma == std::string_view::npos || !name.substr(comma).starts_with(kSecond))
    return {};
  const PairName pair{name.substr(kFirst.size(), comma - kFirst.size()), name.substr(comma + kSecond.size())};
  if (pair.com.find(',') != std::string_view::npos) return {};
  return pair;
}

std::unique_ptr<DisturbanceObserver> make_pair_observer(std::string_view name, const MakeObserver& legs,
                                                        const MakeObserver& com, const ObserverOptions& options,
                                                        double dt) {
  for (const auto& [key, value] : options) {
    if (key.starts_with(kLegsPrefix) || key.starts_with(kComPrefix)) continue;
    throw OptionError(name, key, value, "no such option; there are: legs.KEY and com.KEY, of the two observers");
  }
  auto first = make_part(name, kLegsPrefix, legs, options, dt);
  auto second = make_part(name, kComPrefix, com, options, dt);
  return std::make_unique<PairObserver>(name, std::move(first), std::move(second));
}

}  // namespace dob
