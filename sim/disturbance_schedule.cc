#include "sim/disturbance_schedule.h"

#include <utility>

namespace dob {
namespace {

constexpr double kStartSlack = 1e-9;  // [s] on a start, [-] on a phase: both are sums of ticks

}  // namespace

DisturbanceSchedule::DisturbanceSchedule(const std::vector<Disturbance>& disturbances, std::vector<Payload> payloads,
                                         double gravity)
    : payloads_(std::move(payloads)), gravity_(gravity) {
  items_.reserve(disturbances.size());
  for (const Disturbance& d : disturbances) items_.push_back({d, d.trigger.has_value(), false});
  forces_.reserve(items_.size() + payloads_.size());
  last_phase_.fill(-1.0);
}

void DisturbanceSchedule::update(double t, const PerLeg<double>& swing_phase, const RobotState& state) noexcept {
  forces_.clear();
  began_ = false;
  for (Item& item : items_) {
    Disturbance& d = item.disturbance;
    if (item.waits && t >= d.profile.start_s - kStartSlack) {
      const auto leg = static_cast<std::size_t>(d.trigger->leg);
      const double phase = d.trigger->phase - kStartSlack;
      if (last_phase_[leg] < phase && swing_phase[leg] >= phase) {
        item.waits = false;
        d.profile.start_s = t;
      }
    }
    const bool acts = !item.waits && d.profile.active(t);
    began_ = began_ || (acts && !item.acts);
    item.acts = acts;
    if (acts) forces_.push_back(d.at(t, state));
  }
  last_phase_ = swing_phase;
  applied_ = forces_.size();
  for (const Payload& payload : payloads_) {
    if (!payload.on(t)) continue;
    AppliedForce weight;
    weight.p_L = payload.p_B;
    weight.force_W.z() = -payload.mass * gravity_;
    forces_.push_back(weight);
  }
  began_ = began_ || forces_.size() - applied_ > payloads_on_;
  payloads_on_ = forces_.size() - applied_;
}

const Disturbance* DisturbanceSchedule::waiting() const noexcept {
  for (const Item& item : items_) {
    if (item.waits) return &item.disturbance;
  }
  return nullptr;
}

}  // namespace dob
