// Cells as JSON: what a worker process sends home, and what tables need of JSON. Private to results/.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "results/store.h"

namespace dob {

using Json = nlohmann::ordered_json;

// On one line; bytes that are not UTF-8 are replaced.
std::string one_line(const Json& json);

// An axis of a campaign, as the database and the table's data have it.
Json axis_to_json(const CampaignAxis& axis);

}  // namespace dob
