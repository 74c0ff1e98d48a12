// Claims that a robot falls, or that it does not.
#pragma once

#include <string>

#include "results/claim_finding.h"

namespace dob {

class Reader;

struct FallClaim {
  std::string observer;
};

struct SurviveClaim {
  std::string observer;
};

FallClaim read_fall(Reader& reader, const std::string& subject);
SurviveClaim read_survive(Reader& reader, const std::string& subject);

// Holds if more than half of the runs fall, at whatever time; the median time is part of what was measured.
Finding evaluate(const FallClaim& claim, const ClaimView& view);

// Holds if no run falls.
Finding evaluate(const SurviveClaim& claim, const ClaimView& view);

}  // namespace dob
