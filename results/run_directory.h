// Making a run directory. Private to results/.
#pragma once

#include <filesystem>
#include <vector>

#include "results/store.h"

namespace dob {

inline constexpr const char* kUnfinished = "run.sqlite.part";  // the database until it is complete

// All of these throw StoreError.
void check_names(const std::vector<ResolvedScenario>& scenarios);

// `dir`, made if need be, is empty, or holds no more than the beginning of a run directory whose making was cut short.
void prepare_directory(const std::filesystem::path& dir);

// A new directory root/NNNN.
std::filesystem::path make_numbered(const std::filesystem::path& root);

// Scenarios, then the database: a directory that has it is complete.
void fill_directory(const std::filesystem::path& dir, const RunInfo& info,
                    const std::vector<ResolvedScenario>& scenarios);

}  // namespace dob
