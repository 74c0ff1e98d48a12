// Claims about how errors go: two peaks after a push, one error above another, an error that grows along a sweep.
#pragma once

#include <string>
#include <vector>

#include "results/claim_finding.h"

namespace dob {

class Reader;

// The CoM's error has two peaks after a pulse that are apart (results/pulse_response.h).
struct TwoPeaksClaim {
  std::string observer;
};

struct LargerClaim {
  std::string observer;
  std::size_t metric = 0, than = 0;  // indices into kMetricFields
};

// All cases of the claim make one row, in their order.
struct GrowsClaim {
  std::string observer;
  std::size_t metric = 0;
};

// Keys: observer.
TwoPeaksClaim read_two_peaks(Reader& reader, const std::string& subject);
// Keys: observer, metric, than.
LargerClaim read_larger(Reader& reader, const std::string& subject);
// Keys: observer, metric.
GrowsClaim read_grows(Reader& reader, const std::string& subject);

// Holds if every run survives and has both peaks, each above everything in the second before the pulse.
Finding evaluate(const TwoPeaksClaim& claim, const ClaimView& view);

// Holds if in every run that survived and has both metrics `metric` is above `than`. Shown is the run with the smallest
// ratio of the two. The largest errors of a run that fell are those of its fall.
Finding evaluate(const LargerClaim& claim, const ClaimView& view);

// Holds if the median over seeds is larger in every case than in the one before, of runs of the two paired by seed
// (results/claim_pairs.h). No data where no pair compares, or all runs of a case fell within their first two seconds.
Finding evaluate(const GrowsClaim& claim, const ClaimView& view);

}  // namespace dob
