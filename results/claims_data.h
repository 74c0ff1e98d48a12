// The claims' table for programs. Private to results/.
#pragma once

#include <string>
#include <vector>

#include "results/claims.h"

namespace dob {

// An array of objects, one per row; holds is true, false or null (no data); contrasts only where it is false.
std::string claims_json(const std::vector<ClaimRow>& rows);

// A heading and a line for each row, quoted as in RFC 4180; without the contrasts, which the note tells.
std::string claims_csv(const std::vector<ClaimRow>& rows);

}  // namespace dob
