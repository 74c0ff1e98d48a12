#include "sim/disturbance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/require.h"

namespace dob {
namespace {

constexpr double kTimeSlack = 1e-9;      // [s]
constexpr double kUnitTolerance = 1e-9;  // on the norm of the direction

void require_valid(const ForceProfile& p) {
  using Kind = ForceProfile::Kind;
  const Require require{"disturbance"};
  require.finite("amplitude_N", p.amplitude_N);
  require.finite("start_s", p.start_s);
  require(p.duration_s > 0.0, "duration_s", p.duration_s, "> 0");
  require.finite("phase_rad", p.phase_rad);
  if (p.kind == Kind::kSine) require.positive("period_s", p.period_s);
  if (p.kind == Kind::kRamp)
    require(std::isfinite(p.ramp_s) && p.ramp_s > 0.0 && p.ramp_s <= p.duration_s, "ramp_s", p.ramp_s,
            "finite, > 0 and <= duration_s");
  if (p.kind == Kind::kChirp) {
    require.not_negative("f0_Hz", p.f0_Hz);
    require.not_negative("f1_Hz", p.f1_Hz);
    require(std::isfinite(p.duration_s), "duration_s", p.duration_s, "finite for a chirp");
  }
}

}  // namespace

bool ForceProfile::active(double t) const noexcept {
  const double since = t - start_s;
  return since >= -kTimeSlack && since < duration_s - kTimeSlack;
}

double ForceProfile::value(double t) const noexcept {
  if (!active(t)) return 0.0;
  const double since = t - start_s;
  const auto wave = [this](double cycles) { return std::sin(2.0 * std::numbers::pi * cycles + phase_rad); };
  switch (kind) {
    case Kind::kConstant:
      return amplitude_N;
    case Kind::kSine:
      return amplitude_N * wave(since / period_s);
    case Kind::kRamp:
      return amplitude_N * std::clamp(since / ramp_s, 0.0, 1.0);
    case Kind::kChirp:
      return amplitude_N * wave((f0_Hz + 0.5 * (f1_Hz - f0_Hz) * since / duration_s) * since);
  }
  return 0.0;
}

void Disturbance::validate() const {
  const Require require{"disturbance"};
  require_valid(profile);
  require(leg >= AppliedForce::kTrunk && leg < kLegs, "leg", leg, "-1 (trunk) or 0 to 3 (LF, RF, LH, RH)");
  for (const double coordinate : p_L) require.finite("p_L", coordinate);
  const double norm = direction.norm();
  require(std::abs(norm - 1.0) <= kUnitTolerance, "norm of direction", norm, "1");
  if (trigger)
    require(trigger->phase >= 0.0 && trigger->phase < 1.0, "phase of the trigger", trigger->phase, "0 to below 1");
}

AppliedForce Disturbance::at(double t, const RobotState& state) const noexcept {
  const Vec3 force = profile.value(t) * direction;
  AppliedForce applied{leg, link, p_L, force};
  if (frame == Frame::kBase) applied.force_W = state.R_WB * force;
  return applied;
}

}  // namespace dob
