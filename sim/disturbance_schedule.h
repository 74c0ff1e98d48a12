// The disturbances of a trial as they happen: opens the windows of those that wait for a moment of the gait, and knows
// which ones act.
#pragma once

#include <span>
#include <vector>

#include "sim/disturbance.h"
#include "sim/payload.h"

namespace dob {

class DisturbanceSchedule {
 public:
  // A payload counts as a disturbance from its start on: its weight, under `gravity` [m/s^2] along -z of W.
  explicit DisturbanceSchedule(const std::vector<Disturbance>& disturbances = {}, std::vector<Payload> payloads = {},
                               double gravity = kGravity);

  // The tick at time t [s], later than the one before. `swing_phase`: the share of its planned swing duration that has
  // passed since each leg's lift-off; negative while it stands. A trigger fires at the first tick, not before its
  // disturbance's start, at which its leg's swing has come to the phase since the tick before: a swing that was past
  // it already does not count. Allocates nothing.
  void update(double t, const PerLeg<double>& swing_phase, const RobotState& state) noexcept;

  // Of the tick of the last update:
  // The forces to be applied over it; some may be zero.
  std::span<const AppliedForce> forces() const noexcept { return std::span(forces_).first(applied_); }
  // Those and the weights of the payloads, which the simulator's own bodies bring; what speeds a payload up is left
  // out.
  std::span<const AppliedForce> true_forces() const noexcept { return forces_; }
  bool active() const noexcept { return !forces_.empty(); }
  bool began() const noexcept { return began_; }  // some disturbance began
  // The first one that still waits for its trigger; nullptr: none does.
  const Disturbance* waiting() const noexcept;

 private:
  struct Item {
    Disturbance disturbance;
    bool waits = false;
    bool acts = false;
  };

  std::vector<Item> items_;
  std::vector<Payload> payloads_;
  double gravity_;
  std::vector<AppliedForce> forces_;  // the applied ones first
  std::size_t applied_ = 0;
  std::size_t payloads_on_ = 0;
  PerLeg<double> last_phase_;
  bool began_ = false;
};

}  // namespace dob
