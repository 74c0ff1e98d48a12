#include "results/run_plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/campaign_store.h"
#include "results/fingerprint.h"
#include "results/plain_files.h"
#include "results/run_directory.h"
#include "results/table_cells.h"
#include "robot/text_input.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kBatchColumns{"date",     "command_line", "version", "commit_id", "build",
                                             "compiler", "flags",        "cpu",     "cores",     "os"};
const std::vector<std::string> kCodePathColumns{"model_path", "libraries", "cpu_flags"};

std::vector<std::string> batch_columns() {
  std::vector<std::string> columns = kBatchColumns;
  columns.insert(columns.end(), kCodePathColumns.begin(), kCodePathColumns.end());
  return columns;
}

// Of the table `batch` of this run: '' for what was not kept yet when it was made.
std::vector<std::string> batch_columns_there(SQLite::Database& database) {
  const std::set<std::string> there = columns_of(database, "batch");
  std::vector<std::string> columns = batch_columns();
  for (std::string& column : columns) {
    if (!there.contains(column)) column = "''";
  }
  return columns;
}

RunInfo batch_of(const SQLite::Statement& row) {
  const auto text = [&row](int i) { return row.getColumn(i).getString(); };
  return {.command_line = text(1),
          .version = text(2),
          .commit = text(3),
          .build = text(4),
          .compiler = text(5),
          .flags = text(6),
          .machine = {text(7), row.getColumn(8).getInt(), text(9)},
          .date = text(0),
          .cells = {},
          .sources = {},
          .code_path = {text(10), text(11), text(12)}};
}

// Names to ids, adding a row for a new name.
class NameIds {
 public:
  NameIds(SQLite::Database& database, std::string_view table, const std::vector<std::string>& columns)
      : database_(database), insert_(database, insert_into(table, columns)) {}

  long id_of(const std::string& name, const std::vector<std::string>& more = {}) {
    const auto [it, added] = ids_.emplace(name, 0);
    if (!added) return it->second;
    RowBinder row(insert_);
    row.add(name);
    for (const std::string& text : more) row.add(text);
    insert_.exec();
    return it->second = database_.getLastInsertRowid();
  }

 private:
  SQLite::Database& database_;
  SQLite::Statement insert_;
  std::map<std::string, long> ids_;
};

std::string describe(const CellKey& key) {
  return fmt::format("{}{}{} {} {} {} {} seed {}{}{}", key.scenario, key.variant.empty() ? "" : "/", key.variant,
                     key.observer, key.profile, key.gains, key.planner, key.seed, key.overrides.empty() ? "" : " set ",
                     key.overrides);
}

std::string describe_program(const RunInfo& info) {
  return fmt::format("dobbench {} ({}, {}, {}, {})", info.version, info.commit, info.build, info.compiler, info.flags);
}

std::string describe_missing(const CellKeys& keys, const CellKeys& other, std::string_view what) {
  const std::set<CellKey> there(other.begin(), other.end());
  CellKeys missing;
  for (const CellKey& key : keys) {
    if (there.count(key) == 0) missing.push_back(key);
  }
  if (missing.empty()) return "";
  return fmt::format("; {} {} (first: {})", missing.size(), what, describe(missing.front()));
}

[[noreturn]] void refuse(const fs::path& dir, const std::string& what) {
  throw StoreError(fmt::format("{}: cannot be resumed: {}", dir.string(), what));
}

// Resolved scenarios by name.
std::map<std::string, std::string> scenario_hashes(const fs::path& dir, SQLite::Database& database) {
  return with_database(dir / kDatabaseFile, [&] {
    std::map<std::string, std::string> hashes;
    SQLite::Statement query(database, "SELECT file, hash FROM scenario");
    while (query.executeStep()) hashes[query.getColumn(0).getString()] = query.getColumn(1).getString();
    return hashes;
  });
}

void require_same_sources(const fs::path& dir, const RunInfo& run, const RunInfo& now) {
  for (std::size_t i = 0; i < std::min(run.sources.size(), now.sources.size()); ++i) {
    if (run.sources[i].observer == now.sources[i].observer) continue;
    refuse(dir, fmt::format("the options or the library of {} ({}) are not those that the run began with",
                            run.cells[i].observer, run.cells[i].profile));
  }
}

std::vector<long> ids_of(const RunInfo& info) {
  if (!info.ids.empty()) return info.ids;
  std::vector<long> ids(info.cells.size());
  std::iota(ids.begin(), ids.end(), 1L);
  return ids;
}

std::string describe(const std::vector<RunShard>& shards) {
  return shards.size() == 1 ? fmt::format("shard {}/{}", shards.front().number, shards.front().count) : "a merged run";
}

void require_same_shard(const fs::path& dir, const RunInfo& run, const RunInfo& now) {
  const auto same = [](const RunShard& a, const RunShard& b) { return a.number == b.number && a.count == b.count; };
  if (std::equal(run.shards.begin(), run.shards.end(), now.shards.begin(), now.shards.end(), same)) return;
  refuse(dir, fmt::format("it is {}, not {}", describe(run.shards), describe(now.shards)));
}

// Names go to terminals and into pages.
void require_printable(const std::string& name) {
  if (on_one_line(name) == name && name.find('\x7f') == std::string::npos) return;
  throw std::runtime_error(fmt::format("'{}' holds a control character", on_one_line(name)));
}

}  // namespace

void write_plan(SQLite::Database& database, const RunInfo& info, const std::vector<ResolvedScenario>& scenarios) {
  add_batch(database, info);
  NameIds scenario_ids(database, "scenario", {"file", "hash"});
  for (const ResolvedScenario& scenario : scenarios) scenario_ids.id_of(scenario.name, {fingerprint(scenario.toml)});
  NameIds observer_ids(database, "observer", {"options"});
  std::vector<std::string> columns = kKeyColumns;
  columns.insert(columns.begin(), "id");
  const bool sourced = !info.sources.empty();
  if (sourced) columns.insert(columns.end(), {"scenario_id", "observer_id"});
  SQLite::Statement insert(database, insert_into("cell", columns));
  const std::vector<long> ids = ids_of(info);
  for (std::size_t i = 0; i < info.cells.size(); ++i) {
    RowBinder row(insert);
    row.add(ids[i]).add(info.cells[i]);
    if (sourced) {
      row.add(scenario_ids.id_of(info.sources[i].scenario)).add(observer_ids.id_of(info.sources[i].observer));
    }
    insert.exec();
  }
  for (const RunShard& shard : info.shards) write_shard(database, shard);
  if (info.campaign) write_campaign(database, *info.campaign, ids);
}

void write_shard(SQLite::Database& database, const RunShard& shard) {
  SQLite::Statement insert(database, insert_into("shard", kShardColumns));
  RowBinder(insert)
      .add(static_cast<long>(shard.number))
      .add(static_cast<long>(shard.count))
      .add(static_cast<long>(shard.planned))
      .add(shard.plan)
      .add(static_cast<long>(shard.complete));
  insert.exec();
}

std::vector<RunShard> read_shards(SQLite::Database& database) {
  std::vector<RunShard> shards;
  if (columns_of(database, "shard").empty()) return shards;
  SQLite::Statement row(database, fmt::format("SELECT {} FROM shard ORDER BY number", fmt::join(kShardColumns, ", ")));
  while (row.executeStep()) {
    shards.push_back({row.getColumn(0).getInt(), row.getColumn(1).getInt(),
                      static_cast<std::size_t>(row.getColumn(2).getInt64()), row.getColumn(3).getString(),
                      row.getColumn(4).getInt() != 0});
  }
  return shards;
}

long add_batch(SQLite::Database& database, const RunInfo& now) {
  SQLite::Statement insert(database, insert_into("batch", batch_columns()));
  RowBinder(insert)
      .add(now.date)
      .add(now.command_line)
      .add(now.version)
      .add(now.commit)
      .add(now.build)
      .add(now.compiler)
      .add(now.flags)
      .add(now.machine.cpu)
      .add(static_cast<long>(now.machine.cores))
      .add(now.machine.os)
      .add(now.code_path.model)
      .add(now.code_path.libraries)
      .add(now.code_path.cpu_flags);
  insert.exec();
  return database.getLastInsertRowid();
}

RunInfo read_info(SQLite::Database& database) {
  SQLite::Statement batch(
      database, fmt::format("SELECT {} FROM batch ORDER BY id", fmt::join(batch_columns_there(database), ", ")));
  if (!batch.executeStep()) throw std::runtime_error("has no batch");
  const auto text = [](const SQLite::Statement& row, int i) { return row.getColumn(i).getString(); };
  RunInfo info = batch_of(batch);
  info.shards = read_shards(database);
  SQLite::Statement cell(
      database, fmt::format("SELECT cell.{}, file, options, cell.id FROM cell LEFT JOIN scenario ON scenario.id = "
                            "scenario_id LEFT JOIN observer ON observer.id = observer_id ORDER BY cell.id",
                            fmt::join(kKeyColumns, ", cell.")));
  while (cell.executeStep()) {
    info.cells.push_back({text(cell, 0), text(cell, 1), text(cell, 2), text(cell, 3), text(cell, 4), text(cell, 5),
                          text(cell, 6), cell.getColumn(7).getInt()});
    info.ids.push_back(cell.getColumn(10).getInt64());
    for (int i = 0; i < 6; ++i) require_printable(text(cell, i));
    if (cell.getColumn(8).isNull()) continue;
    if (!is_plain_name(text(cell, 8))) {
      throw std::runtime_error(fmt::format("scenario file '{}' is not one of scenarios/", on_one_line(text(cell, 8))));
    }
    info.sources.push_back({text(cell, 8), text(cell, 9)});
  }
  return info;
}

std::map<long, Provenance> read_programs(SQLite::Database& database) {
  SQLite::Statement batch(database,
                          fmt::format("SELECT {}, id FROM batch", fmt::join(batch_columns_there(database), ", ")));
  std::map<long, Provenance> programs;
  const int id = static_cast<int>(batch_columns().size());
  while (batch.executeStep()) programs[batch.getColumn(id).getInt64()] = batch_of(batch).provenance();
  return programs;
}

RunInfo read_info_of(const fs::path& dir, SQLite::Database& database) {
  try {
    return read_info(database);
  } catch (const std::runtime_error& error) {  // SQLite's, or a value that is not what it should be
    throw StoreError(fmt::format("{}: {}", (dir / kDatabaseFile).string(), error.what()));
  }
}

std::string select_cell_id() {
  return fmt::format("SELECT id FROM cell WHERE {} = ?", fmt::join(kKeyColumns, " = ? AND "));
}

RunInfo read_run_info(const fs::path& dir) {
  SQLite::Database database = open_database(dir);
  return read_info_of(dir, database);
}

ResolvedScenario read_resolved(const fs::path& dir, const std::string& name) {
  check_names({{name, ""}});
  SQLite::Database database = open_database(dir);
  const std::map<std::string, std::string> hashes = scenario_hashes(dir, database);
  const fs::path file = dir / "scenarios" / (name + ".toml");
  require_plain_file(file);
  std::string text;
  try {
    text = read_text_file(file, kMostScenarioBytes);
  } catch (const TextFileError& error) {
    throw StoreError(fmt::format("{}: {}", file.string(), error.what()));
  }
  const auto hash = hashes.find(name);
  if (hash == hashes.end() || hash->second != fingerprint(text)) {
    throw StoreError(file.string() + ": is not the scenario that the run began with");
  }
  return {name, std::move(text)};
}

void require_same_program(const fs::path& dir, const RunInfo& now) {
  const RunInfo run = read_run_info(dir);
  if (describe_program(run) == describe_program(now)) return;
  throw StoreError(fmt::format("{}: its cells were computed by {}, this is {}: use that program, or begin a new run",
                               dir.string(), describe_program(run), describe_program(now)));
}

void require_same_plan(const fs::path& dir, const RunInfo& now, const std::vector<ResolvedScenario>& scenarios) {
  SQLite::Database database = open_database(dir);
  const RunInfo run = read_info_of(dir, database);
  require_same_shard(dir, run, now);
  if (run.cells != now.cells) {
    const std::string differences =
        describe_missing(now.cells, run.cells, "of the cells asked for do not belong to it") +
        describe_missing(run.cells, now.cells, "of its cells were not asked for");
    refuse(dir, fmt::format("the cells differ{}; it was begun by: {}",
                            differences.empty() ? " in their order" : differences, run.command_line));
  }
  require_same_sources(dir, run, now);
  std::map<std::string, std::string> hashes = scenario_hashes(dir, database);
  for (const ResolvedScenario& scenario : scenarios) {
    if (hashes[scenario.name] == fingerprint(scenario.toml)) continue;
    refuse(dir,
           fmt::format("the scenario {0}, or its robot, is not the one that the run began with, scenarios/{0}.toml",
                       scenario.name));
  }
  // Of what no cell tells: another budget, or kind, of a campaign chooses other cells.
  if (!run.shards.empty() && !now.shards.empty() && run.shards.front().plan != now.shards.front().plan) {
    refuse(dir, "the campaign's file or its budget is not the one that it began with");
  }
}

}  // namespace dob
