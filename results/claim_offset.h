// The claim that a wrong model gives the estimate a constant offset.
#pragma once

#include <string>

#include "results/claim_finding.h"

namespace dob {

class Reader;

struct OffsetClaim {
  std::string observer;
  std::string reference;        // the case without the cause of the offset
  double share_at_least = 0.5;  // of the offset in the root mean square of the error: 1 is an error that never changes
};

// Keys: observer, reference, share_at_least.
OffsetClaim read_offset(Reader& reader, const std::string& subject);

// Judges the norm of the mean of F_hat minus the truth (estimate_offset_Nm). Holds if its median is larger than in the
// reference case, and in every run that survived at least share_at_least of the error's root mean square
// (joint_estimate_rmse_Nm).
Finding evaluate(const OffsetClaim& claim, const ClaimView& view);

}  // namespace dob
