// An observer from outside: the legs' momentum with proportional and integral correction (a PI or Luenberger observer
// with the disturbance as a second state),
//     d(rho_hat)/dt = C_q^T qd + tau + J_j^T f + F_hat + l_1 (rho - rho_hat),   d(F_hat)/dt = l_2 (rho - rho_hat),
// so that F_hat = l_2 / (s^2 + l_1 s + l_2) F. Both poles are put at -w: l_1 = 2 w, l_2 = w^2.
// Option: pole_rad_s = w [rad/s]. Like every leg observer it is blind to mass errors and to forces on the trunk.
#include <observers/plugin_api.h>

namespace {

class PiObserver final : public dob::DisturbanceObserver {
 public:
  explicit PiObserver(double w) : l1_(2.0 * w), l2_(w * w) {}

  std::string_view name() const noexcept override { return "pi_momentum"; }

  // Started in motion, it must not read the momentum that is there as the work of a disturbance.
  void reset(const dob::ModelTerms& now) noexcept override {
    rho_hat_ = now.rho;
    F_hat_.setZero();
  }

  dob::Estimate update(const dob::ObserverInput& in) noexcept override {
    // The forces of ALL feet are known inputs, at the start of the interval, where they acted.
    const dob::Vec12 known =
        in.start.CqT_qd + in.joint_torque + dob::joint_torques(in.start, in.start.contact, in.foot_force);
    const dob::Vec12 error = in.start.rho - rho_hat_;
    const dob::Vec12 rho_hat = rho_hat_ + in.dt * (known + F_hat_ + l1_ * error);
    const dob::Vec12 F_hat = F_hat_ + in.dt * l2_ * (in.now.rho - rho_hat);

    dob::Estimate estimate{.has_legs = true};
    if (in.dt > 0.0 && F_hat.allFinite() && rho_hat.allFinite()) {
      rho_hat_ = rho_hat;
      F_hat_ = F_hat;
    } else {
      estimate.status = dob::EstimateStatus::kInvalidInput;  // and the last good estimate
    }
    estimate.leg_torque = F_hat_;
    return estimate;
  }

 private:
  double l1_;                                // [1/s]
  double l2_;                                // [1/s^2]
  dob::Vec12 rho_hat_ = dob::Vec12::Zero();  // [kg m^2/s]
  dob::Vec12 F_hat_ = dob::Vec12::Zero();    // [N m]
};

std::unique_ptr<dob::DisturbanceObserver> make(const dob::ObserverOptions& options, double dt) {
  dob::OptionReader reader("pi_momentum", options);
  const double w = reader.number("pole_rad_s", 100.0, {.above = 0.0, .max = 0.5 / dt});
  reader.refuse_unknown();
  return std::make_unique<PiObserver>(w);
}

}  // namespace

const dob::ObserverPlugin* dob_observer_plugin() {
  static constexpr dob::ObserverPlugin plugin{.name = "pi_momentum",
                                              .summary = "legs' momentum with proportional and integral correction",
                                              .source = "textbook",
                                              .estimates_legs = true,
                                              .make = make};
  return &plugin;
}
