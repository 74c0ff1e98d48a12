#include "results/run_database.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/database_guard.h"
#include "results/metric_fields.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr int kApplicationId = 0x646F6262;  // "dobb"
constexpr int kBusyTimeout = 60'000;        // [ms] to wait for another process' transaction

constexpr const char* kCreateTables = R"(
CREATE TABLE batch(id INTEGER PRIMARY KEY, date TEXT, command_line TEXT, version TEXT, commit_id TEXT, build TEXT,
                   compiler TEXT, flags TEXT, cpu TEXT, cores INTEGER, os TEXT, model_path TEXT, libraries TEXT,
                   cpu_flags TEXT);
CREATE TABLE scenario(id INTEGER PRIMARY KEY, file TEXT NOT NULL UNIQUE, hash TEXT NOT NULL);
CREATE TABLE observer(id INTEGER PRIMARY KEY, options TEXT NOT NULL UNIQUE);
CREATE TABLE cell(id INTEGER PRIMARY KEY, scenario TEXT, variant TEXT, observer TEXT, profile TEXT, gains TEXT,
                  planner TEXT, overrides TEXT, seed INTEGER, scenario_id INTEGER REFERENCES scenario,
                  observer_id INTEGER REFERENCES observer,
                  UNIQUE(scenario, variant, observer, profile, gains, planner, overrides, seed));
)";

constexpr const char* kShardTables = R"(
CREATE TABLE shard(number INTEGER PRIMARY KEY, shards INTEGER, planned INTEGER, plan TEXT, complete INTEGER);
CREATE TABLE campaign(document TEXT);
CREATE TABLE campaign_cell(cell INTEGER PRIMARY KEY, curve INTEGER, level_0 INTEGER, level_1 INTEGER);
)";

constexpr const char* kOverview = R"(
CREATE VIEW overview AS
  SELECT cell.*, scenario.file AS scenario_file, scenario.hash AS scenario_hash, observer.options AS observer_options,
         result.*, batch.*
  FROM cell LEFT JOIN scenario ON scenario.id = cell.scenario_id LEFT JOIN observer ON observer.id = cell.observer_id
       LEFT JOIN result ON result.cell = cell.id LEFT JOIN batch ON batch.id = result.batch;
)";

// " REAL" would make SQLite keep some values as integers, and a negative zero lose its sign: numbers have no type.
std::string create_table(std::string_view table, const std::vector<std::string>& columns, std::string_view key) {
  return fmt::format("CREATE TABLE IF NOT EXISTS {}({}, PRIMARY KEY({})) WITHOUT ROWID;\n", table,
                     fmt::join(columns, ", "), key);
}

void require_version(SQLite::Database& database, const fs::path& file) {
  const int id = database.execAndGet("PRAGMA application_id").getInt();
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (id != kApplicationId) throw StoreError(file.string() + ": is not the database of a run");
  if (version >= kOldestVersion && version <= kStoreVersion) return;
  throw StoreError(fmt::format("{}: store of version {}, this program reads {} to {}: it was written by {} dobbench",
                               file.string(), version, kOldestVersion, kStoreVersion,
                               version > kStoreVersion ? "a newer" : "an older"));
}

}  // namespace

SQLite::Database create_database(const fs::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyTimeout);
  SQLite::Transaction transaction(database);
  database.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", kApplicationId, kStoreVersion));
  database.exec(kCreateTables);
  database.exec(kShardTables);
  database.exec(create_table("result", result_columns(), "cell"));
  database.exec(
      create_table("checkpoint", with_columns({"cell", "number", "t_s"}, kCheckpointColumns), "cell, number"));
  database.exec(
      create_table("shadow", with_columns({"cell", "number", "observer", "profile"}, kShadowColumns), "cell, number"));
  database.exec(create_table("timing", with_columns({"cell", "batch"}, kTimingColumns), "cell"));
  database.exec(kOverview);
  transaction.commit();
  return database;
}

void create_histogram_table(SQLite::Database& database) {
  database.exec(create_table(kHistogramTable, kHistogramColumns, "cell, quantity, low_us"));
}

SQLite::Database open_database(const fs::path& dir) {
  std::error_code error;
  if (!fs::is_directory(dir, error)) throw StoreError(dir.string() + ": no such directory");
  if (!is_run_directory(dir)) {
    throw StoreError(fmt::format("{}: is not a run directory (it has no {})", dir.string(), kDatabaseFile));
  }
  const fs::path file = dir / kDatabaseFile;
  require_harmless_files(file);
  return with_database(file, [&] {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE, kBusyTimeout);
    distrust(database);
    require_version(database, file);
    require_sound(database, file);
    return database;
  });
}

Outcome outcome_from(const std::string& name) {
  for (std::size_t i = 0; i < kOutcomes.size(); ++i) {
    if (kOutcomes[i] == name) return static_cast<Outcome>(i);
  }
  throw std::invalid_argument(fmt::format("outcome '{}', allowed: {}", name, fmt::join(kOutcomes, ", ")));
}

RowBinder& RowBinder::add(const std::string& text) {
  statement_.bind(++index_, text);
  return *this;
}

RowBinder& RowBinder::add(long number) {
  statement_.bind(++index_, static_cast<std::int64_t>(number));
  return *this;
}

RowBinder& RowBinder::add(double number) {
  ++index_;
  std::isfinite(number) ? statement_.bind(index_, number) : statement_.bind(index_);
  return *this;
}

RowBinder& RowBinder::add(const std::optional<double>& number) {
  if (number) return add(*number);
  statement_.bind(++index_);
  return *this;
}

RowBinder& RowBinder::add(const CellKey& key) {
  for (const std::string* text :
       {&key.scenario, &key.variant, &key.observer, &key.profile, &key.gains, &key.planner, &key.overrides}) {
    add(*text);
  }
  return add(static_cast<long>(key.seed));
}

std::string insert_into(std::string_view table, const std::vector<std::string>& columns) {
  const std::vector<std::string> places(columns.size(), "?");
  return fmt::format("INSERT OR REPLACE INTO {}({}) VALUES({})", table, fmt::join(columns, ", "),
                     fmt::join(places, ", "));
}

std::set<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::set<std::string> columns;
  SQLite::Statement query(database, "SELECT name FROM pragma_table_info(?)");
  query.bind(1, table);
  while (query.executeStep()) columns.insert(query.getColumn(0).getString());
  return columns;
}

std::vector<std::string> result_columns() {
  return with_columns(
      {"cell", "batch", "outcome", "reason", "simulated_s", "wall_s", "state_hash", "trace", "qp_solves"},
      kMetricFields);
}

bool is_run_directory(const fs::path& dir) {
  std::error_code error;
  return fs::exists(dir / kDatabaseFile, error);
}

}  // namespace dob
