// One filter, two observers: of the legs' momentum (12 joints) and of the momentum of the whole robot (force and moment
// with gains of their own).
//
// A filter turns the residuals of residual.h, dt times the mean disturbance, into an estimate:
//     template <int N> class Filter {
//       using Options = ...;
//       static Options read(OptionReader&, const std::string& prefix);  // keys: prefix + name; throws OptionError
//       Filter(const Options&, double dt);           // at rest: estimate zero; dt [s] the tick it is made for
//       void step(const Vector& residual, double dt) noexcept;
//       bool finite() const noexcept;                // all of the state
//       const Vector& estimate() const noexcept;     // mean disturbance over the last interval, filtered
//     };
// It treats its N components alike. The observers keep the state before a step whose residual / dt or whose outcome is
// not finite, so that a filter need not look at its input.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "observers/options.h"
#include "observers/residual.h"

namespace dob {

// Torques F_hat of leg-tip forces, one filter for all joints. What it cannot see: see momentum.h.
struct LegMomentum {
  using Vector = Vec12;
  static constexpr int kWidth = kJoints;  // components of a filter
  static constexpr std::array<const char*, 1> kPrefixes{""};
  static Vector residual(const ObserverInput& input) noexcept { return leg_residual(input); }
  static Estimate answer(const Vector& torque, bool valid) noexcept { return leg_estimate(torque, valid); }
};

// Wrench about the CoM, along W, one filter for the force and one for the moment. What it cannot see: see com_wrench.h.
// Joint torques are not used, and may be anything.
struct ComMomentum {
  using Vector = Vec6;
  static constexpr int kWidth = 3;
  static constexpr std::array<const char*, 2> kPrefixes{"linear_", "angular_"};
  static Vector residual(const ObserverInput& input) noexcept { return com_residual(input); }
  static Estimate answer(const Vector& wrench, bool valid) noexcept { return com_estimate(wrench, valid); }
};

// Keys: the filter's, with the prefix of each filter before them.
template <typename Momentum, template <int> class Filter>
class FilterObserver final : public DisturbanceObserver {
 public:
  using OneFilter = Filter<Momentum::kWidth>;

  // `name` has to outlive the observer; dt [s] is the tick. Throws OptionError.
  FilterObserver(std::string_view name, const ObserverOptions& options, double dt)
      : name_(name), rest_(make(name, options, dt)), filters_(rest_) {}

  std::string_view name() const noexcept override { return name_; }

  // All filters to rest.
  void reset(const ModelTerms& /*now*/) noexcept override { filters_ = rest_; }

  // Non-finite input, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were.
  Estimate update(const ObserverInput& input) noexcept override {
    const typename Momentum::Vector residual = Momentum::residual(input);
    bool valid = input.dt > 0.0 && (residual / input.dt).allFinite();
    Filters next = filters_;
    for (int i = 0; i < kFilters && valid; ++i) {
      next[i].step(residual.template segment<Momentum::kWidth>(i * Momentum::kWidth), input.dt);
      valid = next[i].finite();
    }
    if (valid) filters_ = next;
    typename Momentum::Vector estimate;
    for (int i = 0; i < kFilters; ++i) {
      estimate.template segment<Momentum::kWidth>(i * Momentum::kWidth) = filters_[i].estimate();
    }
    return Momentum::answer(estimate, valid);
  }

  // Of all joints; of force (0) and moment (1).
  const OneFilter& filter(int i = 0) const noexcept { return filters_[i]; }

 private:
  static constexpr int kFilters = static_cast<int>(Momentum::kPrefixes.size());
  using Filters = std::array<OneFilter, Momentum::kPrefixes.size()>;

  static Filters make(std::string_view name, const ObserverOptions& options, double dt) {
    check_tick(name, dt);
    OptionReader reader(name, options);
    const auto one = [&](const char* prefix) { return OneFilter(OneFilter::read(reader, prefix), dt); };
    Filters filters = [&]<std::size_t... i>(std::index_sequence<i...>) {
      return Filters{one(Momentum::kPrefixes[i])...};
    }
    (std::make_index_sequence<Momentum::kPrefixes.size()>{});
    reader.refuse_unknown();
    return filters;
  }

  std::string_view name_;
  Filters rest_;
  Filters filters_;
};

template <template <int> class Filter>
using LegFilterObserver = FilterObserver<LegMomentum, Filter>;

template <template <int> class Filter>
using ComFilterObserver = FilterObserver<ComMomentum, Filter>;

}  // namespace dob
