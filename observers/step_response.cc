#include "observers/step_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "observers/frozen_robot.h"

namespace dob {
namespace {

constexpr long kShortest = 256;       // ticks
constexpr long kLongest = 1 << 16;    // ticks
constexpr double kDivergent = 1e4;    // times the disturbance
constexpr double kSettled = 1e-5;     // of the final value
constexpr double kGoodEnough = 5e-2;  // at the end of the longest run

double& unknown(FrozenRobot& robot, Channel channel) {
  if (channel == Channel::kLegTorque) return robot.leg_torque[static_cast<int>(LegLink::kUpper)];  // of LF
  return robot.com_wrench[channel == Channel::kComForce ? 0 : 3];
}

double estimated(const Estimate& estimate, Channel channel) {
  if (channel == Channel::kLegTorque) return estimate.leg_torque[static_cast<int>(LegLink::kUpper)];
  return estimate.com_wrench[channel == Channel::kComForce ? 0 : 3];
}

}  // namespace

std::vector<double> Probe::answer(DisturbanceObserver& observer, long ticks, double limit,
                                  const std::function<double(long)>& u) const {
  FrozenRobot robot(pose_);
  observer.reset(robot.terms());
  std::vector<double> y;
  y.reserve(static_cast<std::size_t>(ticks));
  for (long k = 0; k < ticks; ++k) {
    unknown(robot, channel_) = u(k);
    const Estimate estimate = observer.update(robot.advance(dt_));
    const double value = estimated(estimate, channel_);
    const bool good = estimate.status == EstimateStatus::kOk && std::abs(value) <= limit;
    y.push_back(good ? value : std::numeric_limits<double>::quiet_NaN());
    if (!good) break;
  }
  return y;
}

std::optional<StepResponse> step_response(const Probe& probe, DisturbanceObserver& observer, double amplitude) {
  for (long ticks = kShortest; ticks <= kLongest; ticks *= 2) {
    StepResponse step;
    step.y = probe.answer(observer, ticks, kDivergent * amplitude, [amplitude](long) { return amplitude; });
    if (std::isnan(step.y.back())) return std::nullopt;
    for (double& y : step.y) y /= amplitude;
    const auto half = step.y.begin() + ticks / 2;
    step.final_value = std::accumulate(half, step.y.end(), 0.0) / static_cast<double>(step.y.end() - half);
    const auto [low, high] = std::minmax_element(half, step.y.end());
    const double spread = std::max(*high - step.final_value, step.final_value - *low);
    const double allowed = ticks == kLongest ? kGoodEnough : kSettled;
    if (spread <= allowed * std::abs(step.final_value)) return step;
  }
  return std::nullopt;
}

}  // namespace dob
