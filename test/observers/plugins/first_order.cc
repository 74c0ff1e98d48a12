// A good plugin: joint momentum, first order, one option.
#include "observers/plugin_api.h"

namespace {

class FirstOrder final : public dob::DisturbanceObserver {
 public:
  explicit FirstOrder(double gain) : gain_(gain) {}
  std::string_view name() const noexcept override { return "first_order"; }
  void reset(const dob::ModelTerms& /*now*/) noexcept override { estimate_.setZero(); }
  dob::Estimate update(const dob::ObserverInput& in) noexcept override {
    const dob::Vec12 alpha =
        in.start.CqT_qd + in.joint_torque + dob::joint_torques(in.start, in.start.contact, in.foot_force);
    const dob::Vec12 next = estimate_ + gain_ * (in.now.rho - in.start.rho - in.dt * (alpha + estimate_));
    dob::Estimate result{.has_legs = true};
    if (in.dt > 0.0 && next.allFinite()) {
      estimate_ = next;
    } else {
      result.status = dob::EstimateStatus::kInvalidInput;
    }
    result.leg_torque = estimate_;
    return result;
  }

 private:
  double gain_;
  dob::Vec12 estimate_ = dob::Vec12::Zero();
};

std::unique_ptr<dob::DisturbanceObserver> make(const dob::ObserverOptions& options, double /*dt*/) {
  dob::OptionReader reader("first_order", options);
  const double gain = reader.number("gain_rad_s", 50.0, {.above = 0.0, .max = 1e3});
  reader.refuse_unknown();
  return std::make_unique<FirstOrder>(gain);
}

}  // namespace

const dob::ObserverPlugin* dob_observer_plugin() {
  static constexpr dob::ObserverPlugin plugin{
      .name = "first_order", .summary = "for tests", .source = "here", .estimates_legs = true, .make = make};
  return &plugin;
}
