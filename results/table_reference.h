// Every row of a table against the row of one observer, pair of runs by pair of runs.
#pragma once

#include <string>
#include <vector>

#include "results/table_rows.h"

namespace dob {

// Fills TableRow::reference and TableRow::paired. `reference` is OBSERVER@PROFILE, or OBSERVER: then each row is
// compared with that observer in the row's own profile or, where it is not there, in the first one of the block. Pairs
// are runs of equal seeds within a block; each is compared on the time that both have stood (results/paired.h), so runs
// that fell are in. Empty: `none`; rows of a block without it stay as they are. Throws std::invalid_argument for an
// observer that is in no block.
void compare_with_reference(std::vector<TableRow>& rows, const Run& run, const std::string& reference);

}  // namespace dob
