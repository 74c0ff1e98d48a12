// The claims' table: case | claim | the paper's figure | measured | holds | note.
#pragma once

#include <string>
#include <vector>

#include "results/claims.h"
#include "results/table.h"

namespace dob {

// Ends in a line end. Text, Markdown and LaTeX are for readers: a block for each setting, then the claims that are not
// part of the run. CSV and JSON hold a row or an object for each row, figures in the unit that the metric's name ends
// in. `recorded` says, a line each, where recorded contrasts come from.
std::string render_claims(const ClaimSet& set, const std::vector<ClaimRow>& rows, TableFormat format,
                          const std::vector<std::string>& recorded = {});

}  // namespace dob
