// The rows of shards in one database. Private to results/.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/run_database.h"

namespace dob {

class MergedRows {
 public:
  // Into a database with the tables of a run that nobody reads yet.
  explicit MergedRows(SQLite::Database& database);

  // Those of the run in `dir`, one of a plan to which all rows so far belong, too; the rules are merge_runs'. Of an
  // `earlier` merge only the rows of shards that have not been added. Throws StoreError for a cell about which they
  // disagree, SQLite::Exception.
  void add(const std::filesystem::path& dir, const std::vector<RunShard>& shards, bool earlier = false);

 private:
  void add_plan();
  void require_agreement();
  void refuse_if(const std::string& query, std::string_view what);
  void choose_cells(int shards, bool earlier);
  long add_batches();
  void add_results(long batches);
  void add_timings(long batches);
  void add_shard(const RunShard& shard, bool earlier);

  SQLite::Database& database_;
  std::string part_;  // for messages
};

}  // namespace dob
