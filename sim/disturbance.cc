#include "sim/disturbance.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kTimeSlack = 1e-9;      // [s]
constexpr double kUnitTolerance = 1e-9;  // on the norm of the direction

void require(bool allowed, std::string_view field, double value, std::string_view expected) {
  if (!allowed) {
    throw std::invalid_argument(fmt::format("disturbance: {} = {}, must be {}", field, value, expected));
  }
}

void require_valid(const ForceProfile& profile) {
  const bool sine = profile.kind == ForceProfile::Kind::kSine;
  require(std::isfinite(profile.amplitude_N), "amplitude_N", profile.amplitude_N, "finite");
  require(!sine || (std::isfinite(profile.period_s) && profile.period_s > 0.0), "period_s", profile.period_s,
          "finite and > 0");
  require(!sine || std::isfinite(profile.phase_rad), "phase_rad", profile.phase_rad, "finite");
  require(std::isfinite(profile.start_s), "start_s", profile.start_s, "finite");
  require(profile.duration_s > 0.0, "duration_s", profile.duration_s, "> 0");
}

}  // namespace

bool ForceProfile::active(double t) const noexcept {
  const double since = t - start_s;
  return since >= -kTimeSlack && since < duration_s - kTimeSlack;
}

double ForceProfile::value(double t) const noexcept {
  if (!active(t)) return 0.0;
  if (kind == Kind::kConstant) return amplitude_N;
  return amplitude_N * std::sin(2.0 * std::numbers::pi * (t - start_s) / period_s + phase_rad);
}

void Disturbance::validate() const {
  require_valid(profile);
  require(leg >= AppliedForce::kTrunk && leg < kLegs, "leg", leg, "-1 (trunk) or 0 to 3 (LF, RF, LH, RH)");
  for (const double coordinate : p_L) require(std::isfinite(coordinate), "p_L", coordinate, "finite");
  const double norm = direction.norm();
  require(std::abs(norm - 1.0) <= kUnitTolerance, "norm of direction", norm, "1");
}

AppliedForce Disturbance::at(double t, const RobotState& state) const noexcept {
  const Vec3 force = profile.value(t) * direction;
  AppliedForce applied{leg, link, p_L, force};
  if (frame == Frame::kBase) applied.force_W = state.R_WB * force;
  return applied;
}

}  // namespace dob
