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

#include <memory>
#include <string>

#include "observers/options.h"
#include "observers/residual.h"

namespace dob {

// Estimates the torques F_hat of leg-tip forces. Keys as the filter has them. What it cannot see: see momentum.h.
template <template <int> class Filter>
class LegFilterObserver final : public DisturbanceObserver {
 public:
  // `name` has to outlive the observer. Throws OptionError.
  LegFilterObserver(std::string_view name, const ObserverOptions& options, double dt)
      : name_(name), rest_(make(name, options, dt)), filter_(rest_) {}

  std::string_view name() const noexcept override { return name_; }
  void reset(const ModelTerms& /*now*/) noexcept override { filter_ = rest_; }

  // Non-finite input, dt <= 0 or overflow: kInvalidInput, state and estimate stay as they were.
  Estimate update(const ObserverInput& input) noexcept override {
    const Vec12 residual = leg_residual(input);
    Filter<kJoints> next = filter_;
    next.step(residual, input.dt);
    const bool valid = input.dt > 0.0 && (residual / input.dt).allFinite() && next.finite();
    if (valid) filter_ = next;
    Estimate estimate;
    estimate.has_legs = true;
    estimate.leg_torque = filter_.estimate();
    estimate.status = valid ? EstimateStatus::kOk : EstimateStatus::kInvalidInput;
    return estimate;
  }

  const Filter<kJoints>& filter() const noexcept { return filter_; }

 private:
  static Filter<kJoints> make(std::string_view name, const ObserverOptions& options, double dt) {
    check_tick(name, dt);
    OptionReader reader(name, options);
    const auto read = Filter<kJoints>::read(reader, "");
    reader.refuse_unknown();
    return {read, dt};
  }

  std::string_view name_;
  Filter<kJoints> rest_;
  Filter<kJoints> filter_;
};

// Estimates the disturbance wrench about the CoM, along W. Keys: the filter's twice, with linear_ and angular_ before
// them. What it cannot see: see com_wrench.h.
template <template <int> class Filter>
class ComFilterObserver final : public DisturbanceObserver {
 public:
  // As above.
  ComFilterObserver(std::string_view name, const ObserverOptions& options, double dt)
      : name_(name), rest_(make(name, options, dt)), filters_(rest_) {}

  std::string_view name() const noexcept override { return name_; }
  void reset(const ModelTerms& /*now*/) noexcept override { filters_ = rest_; }

  // As above. Joint torques are not used, and may be anything.
  Estimate update(const ObserverInput& input) noexcept override {
    const Vec6 residual = com_residual(input);
    Filters next = filters_;
    next.linear.step(residual.head<3>(), input.dt);
    next.angular.step(residual.tail<3>(), input.dt);
    const bool valid =
        input.dt > 0.0 && (residual / input.dt).allFinite() && next.linear.finite() && next.angular.finite();
    if (valid) filters_ = next;
    Estimate estimate;
    estimate.has_com = true;
    estimate.com_wrench << filters_.linear.estimate(), filters_.angular.estimate();
    estimate.status = valid ? EstimateStatus::kOk : EstimateStatus::kInvalidInput;
    return estimate;
  }

  const Filter<3>& linear_filter() const noexcept { return filters_.linear; }
  const Filter<3>& angular_filter() const noexcept { return filters_.angular; }

 private:
  struct Filters {
    Filter<3> linear;
    Filter<3> angular;
  };

  static Filters make(std::string_view name, const ObserverOptions& options, double dt) {
    check_tick(name, dt);
    OptionReader reader(name, options);
    const auto linear = Filter<3>::read(reader, "linear_");
    const auto angular = Filter<3>::read(reader, "angular_");
    reader.refuse_unknown();
    return {{linear, dt}, {angular, dt}};
  }

  std::string_view name_;
  Filters rest_;
  Filters filters_;
};

}  // namespace dob
