// Cells and run information as JSON. Private to results/.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "results/store.h"

namespace dob {

using Json = nlohmann::ordered_json;

Json to_json(const RunInfo& info);
Json to_json(const CellResult& cell);  // without its wall time
Json timing_to_json(const CellResult& cell);

// Throw nlohmann::json::exception or std::invalid_argument, which say which key is wrong.
RunInfo run_info_from_json(const Json& json);
CellResult cell_from_json(const Json& json);
CellKey key_from_json(const Json& json);

// On one line; bytes that are not UTF-8 are replaced.
std::string one_line(const Json& json);

}  // namespace dob
