// Plugins are code that the user chooses to load, and that may crash, hang or leave.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/batch_plan.h"

namespace dob {

// What a run directory asks for may name plugins, but only the user loads them: throws InputError, with `source` before
// it, for the first one that is none of the files in `named`, which the user has named on this command line.
void require_consent(const BatchRequest& of_run, const std::vector<std::filesystem::path>& named,
                     const std::string& source);

// Loads each plugin of the request, and makes its observer, in a process of its own first. Throws InputError when that
// crashes, hangs or leaves; what the plugin says itself is left to plan_batch().
void try_plugins(const BatchRequest& request);

}  // namespace dob
