// run.sqlite: its tables, and opening them. Private to results/.
//
//   batch       what computed: command line, program, compiler, code path, machine; one row for each time the run was
//   gone
//               on with
//   scenario    resolved scenarios: file name, hash of the text
//   observer    resolved options and routing of the observers
//   cell        the planned cells; id = place in the tables, from 1, of the whole plan in a shard too
//   result      what became of a cell; its metrics are the fields of results/metric_fields.h
//   checkpoint  metrics of a cell up to a moment
//   shadow      observers that ran along
//   timing      of a serial pass
//   timing_histogram  how the tick and QP times of that pass are distributed; made with the first timing, so that runs
//                     from before it was kept are of the same version and simply have none
//   shard       which parts of the plan this is, and of what plan; one row, several after a merge
//   merged      in a merge only, and empty: what is merged to it replaces what is there
//   campaign    what a campaign asks, as JSON (results/campaign_store.cc); no row in a run that is none
//   campaign_cell  curve and levels of a campaign's cells
//   overview    (view) everything that is known of a cell as one row
//
// The journal is SQLite's rollback journal, not the write-ahead log: a run at rest is one file, which can be copied and
// read from where nothing can be written, and a cell lasts seconds, its transaction milliseconds.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "results/store.h"

namespace dob {

inline constexpr int kStoreVersion = 3;   // PRAGMA user_version
inline constexpr int kOldestVersion = 2;  // that can still be read: without the tables of shards and campaigns
inline constexpr const char* kDatabaseFile = "run.sqlite";

// A column of numbers and the field that it holds.
template <typename Row, typename Field>
struct NumberColumn {
  std::string_view name;
  Field Row::*field;
};

using CheckpointColumn = NumberColumn<MetricsCheckpoint, std::optional<double>>;
inline constexpr std::array kCheckpointColumns{
    CheckpointColumn{"com_error_max_m", &MetricsCheckpoint::com_error_max_m},
    CheckpointColumn{"com_error_rms_m", &MetricsCheckpoint::com_error_rms_m},
    CheckpointColumn{"path_error_max_m", &MetricsCheckpoint::path_error_max_m},
    CheckpointColumn{"foot_error_max_m", &MetricsCheckpoint::foot_error_max_m},
    CheckpointColumn{"grf_error_mean_N", &MetricsCheckpoint::grf_error_mean_N},
};

using ShadowColumn = NumberColumn<ShadowResult, std::optional<double>>;
inline constexpr std::array kShadowColumns{
    ShadowColumn{"estimate_rmse_N", &ShadowResult::estimate_rmse_N},
    ShadowColumn{"joint_estimate_rmse_Nm", &ShadowResult::joint_estimate_rmse_Nm},
    ShadowColumn{"com_force_rmse_N", &ShadowResult::com_force_rmse_N},
    ShadowColumn{"com_moment_rmse_Nm", &ShadowResult::com_moment_rmse_Nm},
};

using TimingColumn = NumberColumn<CellTiming, double>;
inline constexpr std::array kTimingColumns{
    TimingColumn{"tick_p50_us", &CellTiming::tick_p50_us},
    TimingColumn{"tick_p99_us", &CellTiming::tick_p99_us},
    TimingColumn{"tick_max_us", &CellTiming::tick_max_us},
    TimingColumn{"qp_p50_us", &CellTiming::qp_p50_us},
    TimingColumn{"qp_p99_us", &CellTiming::qp_p99_us},
    TimingColumn{"qp_max_us", &CellTiming::qp_max_us},
    TimingColumn{"real_time_factor", &CellTiming::real_time_factor},
};

// What the table timing_histogram calls a quantity.
struct HistogramField {
  std::string_view quantity;
  TimeHistogram CellTiming::*field;
};
inline constexpr std::array kHistogramFields{
    HistogramField{"tick", &CellTiming::tick_histogram},
    HistogramField{"qp", &CellTiming::qp_histogram},
};
inline constexpr const char* kHistogramTable = "timing_histogram";
inline const std::vector<std::string> kHistogramColumns{"cell", "quantity", "low_us", "high_us", "count"};

inline constexpr std::array<std::string_view, 3> kOutcomes{"survived", "fell", "error"};  // of Outcome
Outcome outcome_from(const std::string& name);  // throws std::invalid_argument

// Makes the database `file` with its tables, empty.
SQLite::Database create_database(const std::filesystem::path& file);

// Makes the table of the histograms where there is none.
void create_histogram_table(SQLite::Database& database);

// Opens that of a run directory. For reading too it is opened for writing where it may be, so that the transaction of a
// process that was killed is rolled back. Throws StoreError if there is none, not one of this version, or one in which
// there is more than a dobbench puts there (results/database_guard.h).
SQLite::Database open_database(const std::filesystem::path& dir);

// Calls action() and turns what SQLite throws into a StoreError about `file`.
template <typename Action>
auto with_database(const std::filesystem::path& file, const Action& action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    throw StoreError(file.string() + ": " + error.what());
  }
}

// Binds the values of a row one after the other; what is not finite is null.
class RowBinder {
 public:
  explicit RowBinder(SQLite::Statement& statement) : statement_(statement) { statement_.reset(); }
  RowBinder& add(const std::string& text);
  RowBinder& add(std::string_view text) { return add(std::string(text)); }
  RowBinder& add(long number);
  RowBinder& add(double number);
  RowBinder& add(const std::optional<double>& number);
  RowBinder& add(const CellKey& key);  // in the order of kKeyColumns

 private:
  SQLite::Statement& statement_;
  int index_ = 0;
};

inline const std::vector<std::string> kKeyColumns{"scenario", "variant", "observer",  "profile",
                                                  "gains",    "planner", "overrides", "seed"};

// "INSERT OR REPLACE INTO table(columns) VALUES(?, ...)"
std::string insert_into(std::string_view table, const std::vector<std::string>& columns);

// Of a table as it is in this database; none when it is not there.
std::set<std::string> columns_of(SQLite::Database& database, const std::string& table);

// Columns of the table `result`, and those of the others that are lists of numbers behind `head`.
std::vector<std::string> result_columns();
template <typename Columns>
std::vector<std::string> with_columns(std::vector<std::string> head, const Columns& columns) {
  for (const auto& column : columns) head.emplace_back(column.name);
  return head;
}

}  // namespace dob
