// The paper's claims asked of a run, as `table --claims` and `run --claims` print them.
#pragma once

#include <string>
#include <vector>

#include "results/store.h"
#include "results/table.h"

namespace dob {

// `recorded`: further run directories whose cells may show why a claim does not hold. Throws InputError for what is
// wrong with the claims' file, StoreError for a directory that cannot be read.
std::string claims_report(const Run& run, TableFormat format, const std::vector<std::string>& recorded = {});

}  // namespace dob
