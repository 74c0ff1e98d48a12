#include "observers/analysis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Cholesky>

#include "observers/frozen_robot.h"
#include "observers/options.h"
#include "observers/step_response.h"

namespace dob {
namespace {

constexpr double kLegAmplitude = 5.0;     // [N m]
constexpr double kForceAmplitude = 20.0;  // [N]
constexpr double kMomentAmplitude = 5.0;  // [N m]
constexpr double kBand = 0.02;            // of the settled estimate
constexpr double kLongestTick = 1.0;      // [s]
constexpr double kShortestTick = 1e-6;    // [s]

double amplitude_of(Channel channel) {
  if (channel == Channel::kLegTorque) return kLegAmplitude;
  return channel == Channel::kComForce ? kForceAmplitude : kMomentAmplitude;
}

std::vector<Channel> estimated_channels(DisturbanceObserver& observer, const ModelTerms& pose, double dt) {
  FrozenRobot robot(pose);
  observer.reset(robot.terms());
  const Estimate estimate = observer.update(robot.advance(dt));
  std::vector<Channel> channels;
  if (estimate.has_legs) channels.push_back(Channel::kLegTorque);
  if (estimate.has_com) channels.insert(channels.end(), {Channel::kComForce, Channel::kComMoment});
  return channels;
}

// The observer of a tick that it may refuse.
bool settles(const MakeAtTick& make, const ModelTerms& pose, Channel channel, double dt) {
  try {
    return step_response(Probe(pose, channel, dt), *make(dt), amplitude_of(channel)).has_value();
  } catch (const OptionError&) {
    return false;
  }
}

std::optional<double> measure_max_stable_dt(const MakeAtTick& make, const ModelTerms& pose, Channel channel,
                                            double dt) {
  double lo = dt;
  double hi = dt;
  if (settles(make, pose, channel, dt)) {
    do {
      lo = hi;
      hi *= 2.0;
      if (hi > kLongestTick) return std::nullopt;
    } while (settles(make, pose, channel, hi));
  } else {
    do {
      hi = lo;
      lo *= 0.5;
      if (lo < kShortestTick) return 0.0;
    } while (!settles(make, pose, channel, lo));
  }
  while (hi > 1.01 * lo) {
    const double mid = std::sqrt(lo * hi);
    (settles(make, pose, channel, mid) ? lo : hi) = mid;
  }
  return lo;
}

// Settled part of the answer to a sine, fitted by a sine and a cosine of its frequency over two periods.
std::optional<double> sine_gain(const Probe& probe, DisturbanceObserver& observer, double amplitude, double w,
                                double settling) {
  const long before = std::lround(2.0 * settling / probe.dt());
  const long ticks = before + std::lround(4.0 * std::numbers::pi / (w * probe.dt()));
  const auto phase = [&](long k) { return w * probe.dt() * static_cast<double>(k); };
  const std::vector<double> y =
      probe.answer(observer, ticks, 1e3 * amplitude, [&](long k) { return amplitude * std::sin(phase(k)); });
  if (std::isnan(y.back())) return std::nullopt;
  Mat3 A = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  for (long k = before; k < ticks; ++k) {
    const Vec3 basis(std::sin(phase(k)), std::cos(phase(k)), 1.0);
    A += basis * basis.transpose();
    b += y[static_cast<std::size_t>(k)] * basis;
  }
  return A.ldlt().solve(b).head<2>().norm() / amplitude;
}

std::optional<double> measure_bandwidth(const Probe& probe, DisturbanceObserver& observer, const ChannelAnalysis& a) {
  const auto passes = [&](double w) {
    const auto gain = sine_gain(probe, observer, a.amplitude, w, *a.settling_time);
    return gain && *gain > std::numbers::sqrt2 / 2.0 * *a.static_gain;
  };
  double lo = 0.2 / std::max(*a.delay, probe.dt());
  while (!passes(lo)) {
    lo *= 0.5;
    if (lo < 1e-2) return std::nullopt;
  }
  double hi = 1.2 * lo;
  for (; passes(hi); hi *= 1.2) {
    lo = hi;
    if (hi > 0.5 * std::numbers::pi / probe.dt()) return std::nullopt;
  }
  while (hi > 1.0005 * lo) {
    const double mid = std::sqrt(lo * hi);
    (passes(mid) ? lo : hi) = mid;
  }
  return std::sqrt(lo * hi);
}

double measure_noise_gain(const Probe& probe, DisturbanceObserver& observer, double amplitude, double settling) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const long before = std::lround(2.0 * settling / probe.dt());
  const long ticks = std::max(1L << 15, 40 * before);
  const std::vector<double> y =
      probe.answer(observer, ticks, 1e6 * amplitude, [&](long) { return amplitude * normal(random); });
  double sum = 0.0;
  double squares = 0.0;
  for (auto it = y.begin() + std::min(before, static_cast<long>(y.size()) - 1); it != y.end(); ++it) {
    sum += *it;
    squares += *it * *it;
  }
  const auto count = static_cast<double>(static_cast<long>(y.size()) - before);
  return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count))) / amplitude;
}

// What the answer to a step shows: y(0) = 0, then the estimate at the end of every tick.
void read_step(const StepResponse& step, double dt, ChannelAnalysis& a) {
  a.static_gain = step.final_value;
  if (std::abs(step.final_value) < 1e-6) return;  // does not answer
  const std::size_t half = step.y.size() / 2;
  double area = 0.5;
  double highest = 0.0;
  std::size_t unsettled = 0;
  double energy = 0.0;
  for (std::size_t k = 0; k < step.y.size(); ++k) {
    const double y = step.y[k] / step.final_value;
    if (k < half) area += 1.0 - y;
    highest = std::max(highest, y);
    if (std::abs(y - 1.0) > kBand) unsettled = k + 1;
    const double before = k == 0 ? 0.0 : step.y[k - 1];
    energy += (step.y[k] - before) * (step.y[k] - before);
  }
  a.delay = dt * area;
  a.overshoot = std::max(0.0, highest - 1.0);
  a.settling_time = dt * static_cast<double>(unsettled + 1);
  a.noise_gain = std::sqrt(energy);  // of a linear observer: the energy of its answer to one tick
}

ChannelAnalysis analyse_channel(const MakeAtTick& make, DisturbanceObserver& observer, const ModelTerms& pose,
                                Channel channel, double dt) {
  ChannelAnalysis a;
  a.channel = channel;
  a.amplitude = amplitude_of(channel);
  const auto* linear = dynamic_cast<const LinearObserver*>(&observer);
  if (linear != nullptr) a.linear = linear->linear(channel);
  if (a.linear) {
    a.stable = routh(a.linear->gains).stable;
    a.max_stable_dt = a.linear->largest_stable_dt;
    a.discrete_stable = dt < a.linear->largest_stable_dt;
    if (!a.discrete_stable) return a;
  }
  const Probe probe(pose, channel, dt);
  const auto step = step_response(probe, observer, a.amplitude);
  if (step) read_step(*step, dt, a);
  if (a.linear) {
    a.bandwidth = bandwidth(a.linear->gains);
    a.delay = 1.0 / a.linear->gains.K.front();  // c_1 / c_0 of (5)
    return a;
  }
  a.stable = a.discrete_stable = step.has_value();
  a.max_stable_dt = measure_max_stable_dt(make, pose, channel, dt);
  if (!a.delay) return a;
  a.bandwidth = measure_bandwidth(probe, observer, a);
  a.noise_gain = measure_noise_gain(probe, observer, a.amplitude, *a.settling_time);
  return a;
}

}  // namespace

std::vector<ChannelAnalysis> analyse(const MakeAtTick& make, const ModelTerms& pose, double dt) {
  const auto observer = make(dt);
  std::vector<ChannelAnalysis> all;
  for (const Channel channel : estimated_channels(*observer, pose, dt)) {
    all.push_back(analyse_channel(make, *observer, pose, channel, dt));
  }
  return all;
}

}  // namespace dob
