// What a linear observer can say about itself beyond what can be measured: its transfer function.
#pragma once

#include <optional>

#include "observers/momentum_gains.h"

namespace dob {

// Where a disturbance acts and is estimated. Within a channel all axes have the same filter.
enum class Channel { kLegTorque, kComForce, kComMoment };

// Each axis of a channel by itself, for a small tick: estimate / disturbance = G(s) of momentum_gains.h, a low-pass
// without zeros and with unit static gain.
struct LinearChannel {
  MomentumGains gains;
  double largest_stable_dt = 0.0;  // [s] the update as programmed is stable for ticks below this
};

// Implemented beside DisturbanceObserver, not part of the plugin seam.
class LinearObserver {
 public:
  virtual ~LinearObserver() = default;
  // nullopt for a channel that is not estimated, or not in this form.
  virtual std::optional<LinearChannel> linear(Channel channel) const = 0;
};

}  // namespace dob
