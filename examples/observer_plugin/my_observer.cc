// An observer from outside: the legs' momentum with proportional and integral correction, i.e. a Luenberger observer
// with the disturbance as its second state. With e = rho - rho_hat,
//     d(rho_hat)/dt = C_q^T qd + tau + J_j^T f + F_hat + l_1 e,   d(F_hat)/dt = l_2 e,
// so that F_hat = l_2 / (s^2 + l_1 s + l_2) F. Both poles are put at -w: l_1 = 2 w, l_2 = w^2.
// Option: pole_rad_s = w [rad/s]. Like every leg observer it is blind to mass errors and to forces on the trunk.
#include <observers/plugin_api.h>

namespace {

class PiObserver final : public dob::DisturbanceObserver {
 public:
  explicit PiObserver(double w) : l1_(2.0 * w), l2_(w * w) {}

  std::string_view name() const noexcept override { return "pi_momentum"; }

  void reset(const dob::ModelTerms& /*now*/) noexcept override {
    e_.setZero();
    F_hat_.setZero();
  }

  dob::Estimate update(const dob::ObserverInput& in) noexcept override {
    // Known torques, the forces of ALL feet included, at the start of the interval, where they acted. The momentum is
    // differenced: the observer may start in motion, and a lost interval leaves no jump.
    const dob::Vec12 known =
        in.start.CqT_qd + in.joint_torque + dob::joint_torques(in.start, in.start.contact, in.foot_force);
    const dob::Vec12 e = e_ + (in.now.rho - in.start.rho) - in.dt * (known + F_hat_ + l1_ * e_);
    const dob::Vec12 F_hat = F_hat_ + in.dt * l2_ * e;

    dob::Estimate estimate{.has_legs = true};
    if (in.dt > 0.0 && F_hat.allFinite()) {
      e_ = e;
      F_hat_ = F_hat;
    } else {
      estimate.status = dob::EstimateStatus::kInvalidInput;  // and the last good estimate
    }
    estimate.leg_torque = F_hat_;
    return estimate;
  }

 private:
  double l1_;                              // [1/s]
  double l2_;                              // [1/s^2]
  dob::Vec12 e_ = dob::Vec12::Zero();      // [kg m^2/s]
  dob::Vec12 F_hat_ = dob::Vec12::Zero();  // [N m]
};

std::unique_ptr<dob::DisturbanceObserver> make(const dob::ObserverOptions& options, double dt) {
  dob::OptionReader reader("pi_momentum", options);
  const double w = reader.number("pole_rad_s", 100.0, {.above = 0.0, .max = 1e4});
  reader.refuse_unknown();
  if (w * dt > 0.8)
    throw dob::OptionError("pi_momentum", "pole_rad_s", w, "unstable at this tick; allowed is 0.8 / dt");
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
