#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/merge.h"
#include "results/metric_fields.h"
#include "results/plain_files.h"
#include "results/run_database.h"
#include "results/run_plan.h"
#include "results/store.h"
#include "results/table_cells.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

std::uint64_t hash_from(const std::string& hex) {
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), hash, 16);
  if (hex.size() != 16 || error != std::errc{} || end != hex.data() + hex.size()) {
    throw std::invalid_argument(fmt::format("state_hash '{}', allowed: 16 hexadecimal digits", hex));
  }
  return hash;
}

// A file of the run's own, or none.
std::string trace_from(const std::string& name) {
  constexpr std::string_view kDirectory = "traces/";
  if (name.empty() || (name.starts_with(kDirectory) && is_plain_name(name.substr(kDirectory.size())))) return name;
  throw std::invalid_argument(fmt::format("trace '{}', allowed: a file in traces/", on_one_line(name)));
}

std::optional<double> number_or_null(const SQLite::Statement& row, int column) {
  const SQLite::Column value = row.getColumn(column);
  if (value.isNull()) return std::nullopt;
  if (!value.isFloat() && !value.isInteger()) {
    throw std::invalid_argument(fmt::format("{} '{}', allowed: a number", value.getName(), value.getString()));
  }
  return value.getDouble();
}

double number(const SQLite::Statement& row, int column) {
  const std::optional<double> value = number_or_null(row, column);
  return value ? *value : 0.0;  // it was not finite
}

// A part of a plan is not to be taken for all of it.
void note_missing_shards(const std::vector<RunShard>& shards, std::vector<std::string>& notes) {
  if (shards.empty() || shards.front().count == 1) return;
  const auto note = [&](const std::vector<int>& numbers, std::string_view what) {
    if (numbers.empty()) return;
    notes.push_back(
        fmt::format("of {} shards these are not {}: {}", shards.front().count, what, fmt::join(numbers, ", ")));
  };
  note(missing_shards(shards), "here");
  note(unfinished_shards(shards), "finished");
}

// Reads the tables of one run.
class RunReader {
 public:
  explicit RunReader(SQLite::Database& database) : database_(database) {}

  Run read() {
    const SQLite::Transaction one_state_of_it(database_);
    run_.info = read_info(database_);
    batches_ = read_programs(database_);
    read_results();
    read_checkpoints();
    read_shadows();
    read_timings();
    read_histograms();
    note_machines();
    note_missing_shards(run_.info.shards, run_.notes);
    return std::move(run_);
  }

 private:
  // Of the row of `table`: its first column is the cell.
  CellKey key_of(const SQLite::Statement& row, std::string_view table) const {
    const std::int64_t cell = row.getColumn(0).getInt64();
    const std::vector<long>& ids = run_.info.ids;  // in their order
    const auto it = std::lower_bound(ids.begin(), ids.end(), cell);
    if (it == ids.end() || *it != cell) {
      throw std::invalid_argument(fmt::format("table {}: cell {} is not planned", table, cell));
    }
    return run_.info.cells[static_cast<std::size_t>(it - ids.begin())];
  }

  // A metric that was not measured yet when the run was made has no column there.
  void read_results() {
    const std::set<std::string> there = columns_of(database_, "result");
    std::vector<std::string> columns = result_columns();
    for (std::string& column : columns) {
      if (there.count(column) > 0) continue;
      run_.notes.push_back(fmt::format("{}: not recorded when the run was made", column));
      column = "NULL";
    }
    SQLite::Statement row(database_, fmt::format("SELECT {} FROM result ORDER BY cell", fmt::join(columns, ", ")));
    while (row.executeStep()) {
      place_[row.getColumn(0).getInt64()] = run_.cells.size();
      run_.cells.push_back(result_of(row));
      run_.program_of.push_back(program_of(row.getColumn(1).getInt64()));
    }
  }

  // Index into run_.programs. Batches of one program are one there.
  std::size_t program_of(long batch) {
    const auto it = batches_.find(batch);
    if (it == batches_.end()) throw std::invalid_argument(fmt::format("table result: there is no batch {}", batch));
    const auto place = std::find(run_.programs.begin(), run_.programs.end(), it->second) - run_.programs.begin();
    if (place == std::ssize(run_.programs)) run_.programs.push_back(it->second);
    return static_cast<std::size_t>(place);
  }

  CellResult result_of(const SQLite::Statement& row) const {
    CellResult cell;
    cell.key = key_of(row, "result");
    cell.outcome = outcome_from(row.getColumn(2).getString());
    cell.reason = row.getColumn(3).getString();
    cell.simulated_s = number(row, 4);
    cell.wall_s = number(row, 5);
    cell.state_hash = hash_from(row.getColumn(6).getString());
    cell.trace = trace_from(row.getColumn(7).getString());
    cell.metrics.qp_solves = row.getColumn(8).getInt64();
    for (int column = 9; const MetricField& field : kMetricFields) {
      if (field.value != nullptr) {
        cell.metrics.*field.value = number_or_null(row, column);
      } else {
        cell.metrics.*field.count = row.getColumn(column).getInt64();
      }
      ++column;
    }
    return cell;
  }

  CellResult& cell_of(const SQLite::Statement& row, std::string_view table) {
    key_of(row, table);
    const auto place = place_.find(row.getColumn(0).getInt64());
    if (place != place_.end()) return run_.cells[place->second];
    throw std::invalid_argument(fmt::format("table {}: cell {} has no result", table, row.getColumn(0).getInt64()));
  }

  template <typename Columns>
  SQLite::Statement select(std::string_view table, const std::vector<std::string>& head, const Columns& columns,
                           std::string_view order) {
    return {database_,
            fmt::format("SELECT {} FROM {} ORDER BY {}", fmt::join(with_columns(head, columns), ", "), table, order)};
  }

  void read_checkpoints() {
    SQLite::Statement row = select("checkpoint", {"cell", "t_s"}, kCheckpointColumns, "cell, number");
    while (row.executeStep()) {
      MetricsCheckpoint& checkpoint = cell_of(row, "checkpoint").checkpoints.emplace_back();
      checkpoint.t = number(row, 1);
      for (int i = 2; const CheckpointColumn& column : kCheckpointColumns) {
        checkpoint.*column.field = number_or_null(row, i++);
      }
    }
  }

  void read_shadows() {
    SQLite::Statement row = select("shadow", {"cell", "observer", "profile"}, kShadowColumns, "cell, number");
    while (row.executeStep()) {
      ShadowResult& shadow = cell_of(row, "shadow").shadows.emplace_back();
      shadow.observer = row.getColumn(1).getString();
      shadow.profile = row.getColumn(2).getString();
      for (int i = 3; const ShadowColumn& column : kShadowColumns) shadow.*column.field = number_or_null(row, i++);
    }
  }

  void read_timings() {
    SQLite::Statement row = select("timing", {"cell"}, kTimingColumns, "cell");
    while (row.executeStep()) {
      CellTiming& timing = run_.timings.emplace_back();
      timing.key = key_of(row, "timing");
      for (int i = 1; const TimingColumn& column : kTimingColumns) timing.*column.field = number(row, i++);
    }
  }

  // Each behind the other, from the shortest; a run from before they were kept has none.
  void read_histograms() {
    if (columns_of(database_, kHistogramTable).empty()) return;
    std::map<CellKey, CellTiming*> timings;
    for (CellTiming& timing : run_.timings) timings[timing.key] = &timing;
    SQLite::Statement row(database_, fmt::format("SELECT {} FROM {} ORDER BY cell, quantity, low_us",
                                                 fmt::join(kHistogramColumns, ", "), kHistogramTable));
    while (row.executeStep()) {
      const auto timing = timings.find(key_of(row, kHistogramTable));
      if (timing == timings.end()) continue;
      for (const HistogramField& histogram : kHistogramFields) {
        if (row.getColumn(1).getString() != histogram.quantity) continue;
        TimeHistogram& bins = timing->second->*histogram.field;
        if (bins.edges_us.empty()) bins.edges_us.push_back(number(row, 2));
        bins.edges_us.push_back(number(row, 3));
        bins.counts.push_back(row.getColumn(4).getInt64());
      }
    }
  }

  // Arithmetic may differ in the last bit between processors.
  void note_machines() {
    SQLite::Statement row(database_,
                          "SELECT DISTINCT cpu FROM batch WHERE id IN (SELECT batch FROM result) ORDER BY cpu");
    std::vector<std::string> cpus;
    while (row.executeStep()) cpus.push_back(row.getColumn(0).getString());
    if (cpus.size() > 1) run_.notes.push_back(fmt::format("computed on several machines: {}", fmt::join(cpus, "; ")));
    for (std::size_t i = 1; i < run_.programs.size(); ++i) {
      run_.notes.push_back("computed on several code paths: " + differences(run_.programs[0], run_.programs[i]));
    }
  }

  SQLite::Database& database_;
  Run run_;
  std::map<long, Provenance> batches_;
  std::map<std::int64_t, std::size_t> place_;  // cell -> index into run_.cells
};

}  // namespace

Run read_run(const fs::path& dir) {
  SQLite::Database database = open_database(dir);
  try {
    return RunReader(database).read();
  } catch (const std::exception& error) {  // SQLite's, or a value that is not what it should be
    throw StoreError(fmt::format("{}: {}", (dir / kDatabaseFile).string(), error.what()));
  }
}

std::vector<CellResult> read_cells(const fs::path& dir) {
  return read_run(dir).cells;
}

}  // namespace dob
