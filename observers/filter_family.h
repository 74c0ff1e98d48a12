// Gains of the momentum observer from a classical low-pass family, an order and a -3 dB bandwidth: observers of
// different orders compared at one bandwidth.
#pragma once

#include <string_view>

#include "observers/momentum_gains.h"

namespace dob {

enum class FilterFamily {
  kBessel,       // flattest delay: the reverse Bessel polynomial; next to no overshoot
  kButterworth,  // flattest magnitude: poles evenly on a half circle; overshoots more with the order
  kBinomial,     // r equal real poles; no overshoot
};

// 1 <= order <= kMaxMomentumOrder; bandwidth [rad/s], finite and > 0, of the whole filter at -3 dB. Of order 1 all
// families are the same.
MomentumGains family_gains(FilterFamily family, int order, double bandwidth);

}  // namespace dob
