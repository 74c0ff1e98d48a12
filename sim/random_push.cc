#include "sim/random_push.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/random_stream.h"
#include "sim/require.h"

namespace dob {
namespace {

constexpr double kEndSlack = 1e-9;               // [s] a draw that would begin this close to the end does not
constexpr std::uint32_t kPushStreams = 0x9d5au;  // sets these streams apart from others of the same seed

// The point at this share of the length from the pitch joint over the knee to the foot.
void place(double share, const LegDescription& leg, Disturbance& d) {
  const Vec3& knee = leg.joints[static_cast<std::size_t>(LegLink::kLower)].origin;  // in the upper link's frame
  const double upper = knee.norm();
  const double along = share * (upper + leg.foot_center.norm());
  if (along < upper) {
    d.link = LegLink::kUpper;
    d.p_L = along / upper * knee;
  } else {
    d.link = LegLink::kLower;
    d.p_L = (along - upper) / leg.foot_center.norm() * leg.foot_center;
  }
}

}  // namespace

void RandomPush::validate() const {
  const Require require{"random push"};
  require.not_negative("min_N", min_N);
  require(std::isfinite(max_N) && max_N >= min_N, "max_N", max_N, "finite and >= min_N");
  require.positive("hold_s", hold_s);
  require.finite("start_s", start_s);
  require(duration_s > 0.0, "duration_s", duration_s, "> 0");
  require(!legs.empty(), "number of legs", 0.0, "at least 1");
}

std::vector<Disturbance> draw_pushes(const RandomPush& push, const RobotDescription& robot, std::uint64_t seed,
                                     std::uint32_t stream, double end_s) {
  push.validate();
  std::mt19937_64 random = random_stream(seed, kPushStreams, stream);
  const double end = std::min(end_s, push.start_s + push.duration_s);
  std::vector<Disturbance> draws;
  for (int k = 0;; ++k) {
    const double start = push.start_s + k * push.hold_s;
    if (start >= end - kEndSlack) return draws;
    // Four numbers per draw, in this order.
    Disturbance d;
    const Leg leg = push.legs[static_cast<std::size_t>(uniform(random) * static_cast<double>(push.legs.size()))];
    d.leg = static_cast<int>(leg);
    place(uniform(random), robot.legs[static_cast<std::size_t>(leg)], d);
    const double angle = 2.0 * std::numbers::pi * uniform(random);
    d.direction = Vec3(std::cos(angle), std::sin(angle), 0.0);
    d.profile.amplitude_N = push.min_N + (push.max_N - push.min_N) * uniform(random);
    d.profile.start_s = start;
    // Only the window of all draws cuts the last one: where a run ends is not the disturbance's business.
    d.profile.duration_s = std::min(push.hold_s, push.start_s + push.duration_s - start);
    draws.push_back(d);
  }
}

}  // namespace dob
