// The paper's claims as data (paper_claims.toml), and what a run says about each. docs/claims.md.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "results/claim_bound.h"
#include "results/claim_fall.h"
#include "results/claim_offset.h"
#include "results/claim_ordering.h"
#include "results/claim_shape.h"
#include "results/store.h"

namespace dob {

// The same question with some of its terms replaced; empty: as in the row.
struct Contrast {
  std::string observer;  // in place of the claims' subject
  std::string profile, gains, planner, overrides;
};

struct Claim {
  std::string id;      // unique
  std::string study;   // the paper's case
  std::string text;    // what is claimed
  std::string paper;   // the paper's figure
  std::string source;  // section, figure
  std::string kind;
  std::vector<std::string> cells;  // SCENARIO/VARIANT, * for any characters: a row each
  bool along = false;              // all the cells make one row, in their order
  std::variant<BoundClaim, FallClaim, SurviveClaim, OrderingClaim, SimilarClaim, OffsetClaim, TwoPeaksClaim,
               LargerClaim, GrowsClaim>
      test;
  std::vector<std::string> observers;  // that the test asks for
  std::vector<Contrast> contrasts;
};

struct ClaimSet {
  std::string subject;  // the observer that the claims are about
  std::string ours;     // the one whose answer stands beside
  std::vector<Claim> claims;
};

// results/paper_claims.toml of what came with the program.
std::filesystem::path paper_claims_file();

// Throws InputError with file, line and column: unknown keys, kinds and metrics, a limit in another unit than its
// metric's, two claims of one id.
ClaimSet load_claims(const std::filesystem::path& file);

struct ContrastFinding {
  std::string name;       // what differs from the row: "oracle_legs", "gains stiff"
  bool recorded = false;  // from another run than the one in question
  Finding finding;
};

// One claim under one setting.
struct ClaimRow {
  const Claim* claim = nullptr;
  std::string cells;
  Setting setting;       // empty when the claim is not part of the run
  bool planned = false;  // some observer of the claim is part of the run
  Finding finding;
  std::optional<Finding> ours;  // nullopt where the subject has no part in the claim
  std::vector<ContrastFinding> contrasts;
  std::string note;
};

// In the order of the claims, then of their cells, then of the run's settings. Every claim has a row. A claim that does
// not hold is asked again for each of its contrasts: of this run or, where it has none, of `recorded` ones. The rows
// point into `set`.
std::vector<ClaimRow> evaluate_claims(const ClaimSet& set, const Run& run, const std::vector<Run>& recorded = {});

}  // namespace dob
