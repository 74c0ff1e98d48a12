// A campaign in the run's database. Private to results/.
#pragma once

#include <cstddef>
#include <vector>

#include "results/campaign.h"
#include "results/run_database.h"

namespace dob {

// With the plan: `ids` are those of the campaign's cells.
void write_campaign(SQLite::Database& database, const Campaign& campaign, const std::vector<long>& ids);

// nullopt: the run is no campaign. Throws std::runtime_error or SQLite::Exception for what cannot be one of `cells`
// cells.
std::optional<Campaign> read_campaign(SQLite::Database& database, std::size_t cells);

// What two campaigns must share to be one: everything but the cells.
std::string campaign_document(SQLite::Database& database);

}  // namespace dob
