// What an observer does to a disturbance: speed, delay, overshoot, noise, stability. Measured on the frozen robot with
// any observer whatever is inside; a linear one (linear_observer.h) adds its transfer function, and what follows from
// it in closed form then replaces the measured figure.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "observers/linear_observer.h"
#include "observers/observer.h"

namespace dob {

// One channel of one observer at one tick. A figure is absent where it has no meaning: an unstable observer has no
// bandwidth, a step that is never answered no delay.
struct ChannelAnalysis {
  Channel channel = Channel::kLegTorque;
  double amplitude = 0.0;  // [N m] or [N] of step, sine and noise; matters for observers that are not linear
  std::optional<LinearChannel> linear;  // if the observer offers it
  bool stable = false;                  // as a continuous filter; measured: like discrete_stable
  bool discrete_stable = false;         // the programmed update at the tick, closed form or: answers a step by settling
  std::optional<double> max_stable_dt;  // [s] largest stable tick; measured: up to 1 s, to 1 %. Absent: none below 1 s
  std::optional<double> static_gain;    // settled estimate of a step over the step
  std::optional<double> bandwidth;      // [rad/s] smallest frequency at which a sine comes through with 1/sqrt(2) of
                                        // the static gain
  std::optional<double> delay;          // [s] of slow signals: area between step and answer; lag behind a ramp
  std::optional<double> overshoot;      // of a step, over the settled estimate
  std::optional<double> settling_time;  // [s] after which the answer to a step stays within 2 %
  std::optional<double> noise_gain;     // standard deviation of the estimate over that of a disturbance that is white
                                        // from tick to tick (as noise of the measured torque or force is); depends on
                                        // the tick
};

// Makes the observer for ticks of dt [s]; may throw OptionError when dt is too long for it.
using MakeAtTick = std::function<std::unique_ptr<DisturbanceObserver>(double dt)>;

// One entry for each channel that the observer estimates; none for one that estimates nothing. `pose` as in
// FrozenRobot. The legs are asked at the LF upper joint, the CoM along x. Throws what `make` throws at dt.
std::vector<ChannelAnalysis> analyse(const MakeAtTick& make, const ModelTerms& pose, double dt);

}  // namespace dob
