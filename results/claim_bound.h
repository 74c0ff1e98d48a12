// Claims that a figure stays within a limit.
#pragma once

#include <limits>
#include <string>

#include "results/claim_finding.h"

namespace dob {

class Reader;

struct BoundClaim {
  std::string observer;
  std::size_t metric = 0;  // index into kMetricFields
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  bool or_fall = false;  // a run that falls does as well
};

// Keys: metric; at least one of at_least_UNIT, at_most_UNIT, below_UNIT, UNIT being that of the metric; or_fall.
BoundClaim read_bound(Reader& reader, const std::string& subject);

// Holds if every run keeps the limits and none falls: a robot on the ground keeps no bound. With or_fall, if every run
// keeps the limits or falls. `worst` is the figure that is farthest out, of the runs that survived.
Finding evaluate(const BoundClaim& claim, const ClaimView& view);

}  // namespace dob
