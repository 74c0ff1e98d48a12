// What the robot does not know of itself, or is told wrongly.
#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

constexpr Range kMass = above(0.0, 1e3);          // [kg]
constexpr Range kOnTrunk = between(-10.0, 10.0);  // [m]
constexpr Range kScale = above(0.0, 10.0);        // [-]
constexpr Range kNoise = between(0.0, 10.0);      // [m/s] or [rad/s]
constexpr Range kTorque = between(0.0, 1e4);      // [N m]
constexpr Range kFootForce = between(-1e4, 1e4);  // [N]

}  // namespace

void read_imperfections(Reader& r, Scenario& s) {
  r.table("model_error", [&](Reader& t) {
    s.model_error.mass_scale = t.number("mass_scale", kScale);
    s.model_error.trunk_mass_scale = t.number("trunk_mass_scale", kScale);
    s.model_error.rotational_inertia_scale = t.number("rotational_inertia_scale", kScale);
  });
  r.table("sensing", [&](Reader& t) {
    s.sensing.base_velocity_noise = t.number("base_velocity_noise_m_s", kNoise);
    s.sensing.base_angular_velocity_noise = t.number("base_angular_velocity_noise_rad_s", kNoise);
    s.sensing.torque_bias = t.number("torque_bias_Nm", kTorque);
    s.sensing.foot_force_bias = t.number("foot_force_bias_N", kFootForce);
    s.sensing.delay_ticks = t.integer("delay_ticks", 0, kMaxDelayTicks);
  });
  r.each("payload", [&](Reader& t) {
    s.payloads.push_back({.start_s = t.number("at_s", between(0.0, kLongestTime)),
                          .mass = t.number("mass_kg", kMass),
                          .p_B = t.vector("point_m", kOnTrunk)});
  });
}

}  // namespace dob
