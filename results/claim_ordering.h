// Claims that observers rank in some order, or that they are alike.
#pragma once

#include <string>
#include <vector>

#include "results/claim_finding.h"

namespace dob {

class Reader;

// Every observer of a stage is at least as good as every one of the next.
struct OrderingClaim {
  std::vector<std::vector<std::string>> stages;  // the best first
  std::size_t metric = 0;                        // index into kMetricFields; less is better
  double slack = 1.0;                            // A counts as no worse than B up to slack times B
};

struct SimilarClaim {
  std::vector<std::string> observers;
  std::size_t metric = 0;
  double within_ratio = 1.0;
};

// Keys: observers (a list of stages, alternatives within a stage separated by " | "), metric, slack_ratio (default 1).
OrderingClaim read_ordering(Reader& reader, const std::string& subject);
// Keys: observers, metric, within_ratio.
SimilarClaim read_similar(Reader& reader, const std::string& subject);

// Falls count first: the observer with the larger share of falls is worse; if all runs of both fall, the one that falls
// earlier. Otherwise the worst figures over seeds and cases are compared, of runs paired by case and seed
// (results/claim_pairs.h).
Finding evaluate(const OrderingClaim& claim, const ClaimView& view);

// Holds if of every two observers the larger of the worst figures is at most within_ratio times the smaller, of runs
// paired by case and seed (results/claim_pairs.h). Falls are of no account: one observer may walk on where another one,
// much like it until then, falls.
Finding evaluate(const SimilarClaim& claim, const ClaimView& view);

}  // namespace dob
