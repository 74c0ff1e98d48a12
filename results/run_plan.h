// What is planned in a run, and by which program, in its database. Private to results/.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "results/run_database.h"
#include "results/store.h"

namespace dob {

inline constexpr std::size_t kMostScenarioBytes = 4 << 20;  // of a resolved one; the shipped ones have some 10 kB

// Cells, scenarios and observers of a new run.
void write_plan(SQLite::Database& database, const RunInfo& info, const std::vector<ResolvedScenario>& scenarios);

// A row of `shard`, in place of one with its number.
void write_shard(SQLite::Database& database, const RunShard& shard);
std::vector<RunShard> read_shards(SQLite::Database& database);
inline const std::vector<std::string> kShardColumns{"number", "shards", "planned", "plan", "complete"};

// A row of `batch`; returns its id.
long add_batch(SQLite::Database& database, const RunInfo& now);

// What began the run, with its cells and their sources.
RunInfo read_info(SQLite::Database& database);
// The same; what it throws is a StoreError about that file of `dir`.
RunInfo read_info_of(const std::filesystem::path& dir, SQLite::Database& database);

// What computed, by the id of the batch.
std::map<long, Provenance> read_programs(SQLite::Database& database);

std::string select_cell_id();  // by a key

// Throw StoreError with what differs.
void require_same_program(const std::filesystem::path& dir, const RunInfo& now);
void require_same_plan(const std::filesystem::path& dir, const RunInfo& now,
                       const std::vector<ResolvedScenario>& scenarios);

}  // namespace dob
