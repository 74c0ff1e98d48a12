#include "results/merge_rows.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/database_guard.h"
#include "results/metric_fields.h"
#include "results/run_plan.h"

namespace dob {

MergedRows::MergedRows(SQLite::Database& database) : database_(database) {
  distrust(database, 1);
}

void MergedRows::add(const std::filesystem::path& dir, const std::vector<RunShard>& shards, bool earlier) {
  part_ = dir.string();
  SQLite::Statement attach(database_, "ATTACH ? AS part");
  attach.bind(1, (dir / kDatabaseFile).string());
  attach.exec();
  {
    SQLite::Transaction transaction(database_);
    add_plan();
    choose_cells(shards.front().count, earlier);
    require_agreement();
    const long batches = add_batches();
    add_results(batches);
    add_timings(batches);
    for (const RunShard& shard : shards) add_shard(shard, earlier);
    transaction.commit();
  }
  database_.exec("DROP TABLE temp.observer_of; DROP TABLE temp.offered; DETACH part");
}

void MergedRows::add_plan() {
  database_.exec(
      "INSERT OR IGNORE INTO scenario(file, hash) SELECT file, hash FROM part.scenario ORDER BY id;"
      "INSERT OR IGNORE INTO observer(options) SELECT options FROM part.observer ORDER BY id;"
      "CREATE TEMP TABLE observer_of AS SELECT theirs.id AS part_id, ours.id AS id"
      "  FROM part.observer AS theirs JOIN observer AS ours USING(options);");
  database_.exec(
      fmt::format("INSERT OR IGNORE INTO cell(id, {0}, scenario_id, observer_id)"
                  "  SELECT theirs.id, theirs.{1}, ours.id, observer_of.id FROM part.cell AS theirs"
                  "  LEFT JOIN part.scenario AS named ON named.id = theirs.scenario_id"
                  "  LEFT JOIN scenario AS ours ON ours.file = named.file"
                  "  LEFT JOIN temp.observer_of ON part_id = theirs.observer_id ORDER BY theirs.id",
                  fmt::join(kKeyColumns, ", "), fmt::join(kKeyColumns, ", theirs.")));
  database_.exec(
      "INSERT OR IGNORE INTO campaign_cell SELECT * FROM part.campaign_cell;"
      "INSERT INTO campaign SELECT document FROM part.campaign WHERE NOT EXISTS (SELECT 1 FROM campaign);");
}

void MergedRows::require_agreement() {
  std::vector<std::string> same;
  same.reserve(kKeyColumns.size());
  for (const std::string& column : kKeyColumns) same.push_back(fmt::format("ours.{0} = theirs.{0}", column));
  refuse_if(fmt::format("SELECT theirs.id FROM part.cell AS theirs LEFT JOIN cell AS ours ON ours.id = theirs.id"
                        "  AND {} WHERE ours.id IS NULL",
                        fmt::join(same, " AND ")),
            "is another one in another part");
  refuse_if(
      "SELECT theirs.cell FROM part.result AS theirs JOIN result AS ours USING(cell)"
      "  WHERE theirs.cell IN temp.offered AND theirs.outcome != 'error' AND ours.outcome != 'error'"
      "  AND (theirs.state_hash != ours.state_hash OR theirs.outcome != ours.outcome)",
      "has come out differently in another part (`dobbench verify` tells which one can be repeated)");
}

void MergedRows::refuse_if(const std::string& query, std::string_view what) {
  SQLite::Statement row(database_, query + " LIMIT 1");
  if (!row.executeStep()) return;
  throw StoreError(fmt::format("{}: cell {} {}", part_, row.getColumn(0).getInt64(), what));
}

// `offered`: cells of the part that may be taken. A shard that is there replaces what an earlier merge has of it: it
// may have chosen other cells since.
void MergedRows::choose_cells(int shards, bool earlier) {
  const std::string others =
      earlier ? fmt::format(" WHERE IFNULL(curve, cell.id - 1) % {} + 1 NOT IN (SELECT number FROM shard)", shards)
              : "";
  database_.exec(
      "CREATE TEMP TABLE offered AS SELECT cell.id AS cell FROM part.cell AS cell"
      "  LEFT JOIN part.campaign_cell AS place ON place.cell = cell.id" +
      others);
}

// Those that have computed something of the part; returns by how much their ids have grown.
long MergedRows::add_batches() {
  const long before = static_cast<long>(database_.execAndGet("SELECT IFNULL(MAX(id), 0) FROM batch").getInt64());
  const std::set<std::string> batch = columns_of(database_, "batch");
  std::vector<std::string> columns(batch.begin(), batch.end());
  std::erase(columns, "id");
  database_.exec(
      fmt::format("INSERT INTO batch(id, {0}) SELECT id + {1}, {0} FROM part.batch WHERE {1} = 0"
                  "  OR id IN (SELECT batch FROM part.result WHERE cell IN temp.offered"
                  "            UNION SELECT batch FROM part.timing WHERE cell IN temp.offered)",
                  fmt::join(columns, ", "), before));
  return before;
}

// Only those of cells that have no result yet; one that could not be run gives way to one that could.
void MergedRows::add_results(long batches) {
  database_.exec(
      "DELETE FROM result WHERE outcome = 'error' AND cell IN"
      "  (SELECT cell FROM part.result WHERE outcome != 'error' AND cell IN temp.offered);"
      "CREATE TEMP TABLE wanted AS SELECT cell FROM part.result WHERE cell IN temp.offered"
      "  AND cell NOT IN (SELECT cell FROM result);");
  std::vector<std::string> numbers = result_columns();
  const std::string names = fmt::format("{}", fmt::join(numbers, ", "));
  numbers.at(1) = fmt::format("batch + {}", batches);
  database_.exec(fmt::format("INSERT INTO result({}) SELECT {} FROM part.result WHERE cell IN temp.wanted", names,
                             fmt::join(numbers, ", ")));
  for (const char* table : {"checkpoint", "shadow"}) {
    database_.exec(
        fmt::format("DELETE FROM {0} WHERE cell IN temp.wanted;"
                    "INSERT INTO {0} SELECT * FROM part.{0} WHERE cell IN temp.wanted",
                    table));
  }
  database_.exec("DROP TABLE temp.wanted");
}

// A cell's timing with its histograms, of the first part that has any.
void MergedRows::add_timings(long batches) {
  database_.exec(
      "CREATE TEMP TABLE wanted AS SELECT cell FROM part.timing WHERE cell IN temp.offered"
      "  AND cell NOT IN (SELECT cell FROM timing)");
  std::vector<std::string> numbers = with_columns({"cell", "batch"}, kTimingColumns);
  const std::string names = fmt::format("{}", fmt::join(numbers, ", "));
  numbers.at(1) = fmt::format("batch + {}", batches);
  database_.exec(fmt::format("INSERT INTO timing({}) SELECT {} FROM part.timing WHERE cell IN temp.wanted", names,
                             fmt::join(numbers, ", ")));
  SQLite::Statement table(database_, "SELECT 1 FROM part.sqlite_schema WHERE name = ?");
  table.bind(1, kHistogramTable);
  if (table.executeStep()) {
    create_histogram_table(database_);
    database_.exec(fmt::format("INSERT INTO {0} SELECT * FROM part.{0} WHERE cell IN temp.wanted", kHistogramTable));
  }
  table.reset();
  database_.exec("DROP TABLE temp.wanted");
}

void MergedRows::add_shard(const RunShard& shard, bool earlier) {
  SQLite::Statement there(database_, "SELECT complete FROM shard WHERE number = ?");
  there.bind(1, shard.number);
  const bool added = there.executeStep();
  const bool complete = added && there.getColumn(0).getInt() != 0;
  there.reset();
  if (added && earlier) return;
  RunShard row = shard;
  row.complete = shard.complete || complete;
  write_shard(database_, row);
}

}  // namespace dob
