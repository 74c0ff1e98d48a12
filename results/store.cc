#include "results/store.h"

#include <algorithm>
#include <charconv>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "results/metric_fields.h"
#include "results/run_database.h"
#include "results/run_directory.h"
#include "results/run_lock.h"
#include "results/run_plan.h"
#include "results/whole_file.h"

namespace dob {

namespace fs = std::filesystem;

struct RunStore::Impl {
  fs::path dir;
  RunLock lock;
  SQLite::Database database;
  long batch;  // id of this one
  std::mutex mutex;

  SQLite::Statement cell_id, insert_result, insert_checkpoint, insert_shadow, insert_timing;

  Impl(fs::path directory, const RunInfo& now)
      : dir(std::move(directory)),
        lock(dir),
        database(open_database(dir)),
        batch(add_batch(database, now)),
        cell_id(database, select_cell_id()),
        insert_result(database, insert_into("result", result_columns())),
        insert_checkpoint(database,
                          insert_into("checkpoint", with_columns({"cell", "number", "t_s"}, kCheckpointColumns))),
        insert_shadow(database,
                      insert_into("shadow", with_columns({"cell", "number", "observer", "profile"}, kShadowColumns))),
        insert_timing(database, insert_into("timing", with_columns({"cell", "batch"}, kTimingColumns))) {}

  long id_of(const CellKey& key) {
    RowBinder(cell_id).add(key);
    if (!cell_id.executeStep()) throw StoreError(dir.string() + ": a cell that does not belong to the run");
    const long id = cell_id.getColumn(0).getInt64();
    cell_id.reset();
    return id;
  }

  // All of it or nothing.
  template <typename Write>
  void write(const Write& write_rows) {
    const std::lock_guard guard(mutex);
    try {
      SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      write_rows();
      transaction.commit();
    } catch (const SQLite::Exception& error) {
      throw WriteError(fmt::format("{}: {}", (dir / kDatabaseFile).string(), error.what()));
    }
  }

  void write_result(long cell, const CellResult& result) {
    RowBinder row(insert_result);
    row.add(cell).add(batch).add(kOutcomes.at(static_cast<std::size_t>(result.outcome))).add(result.reason);
    row.add(result.simulated_s).add(result.wall_s).add(fmt::format("{:016x}", result.state_hash)).add(result.trace);
    row.add(result.metrics.qp_solves);
    for (const MetricField& field : kMetricFields) {
      field.value != nullptr ? row.add(result.metrics.*field.value) : row.add(result.metrics.*field.count);
    }
    insert_result.exec();
  }

  void write_lists(long cell, const CellResult& result) {
    database.exec(fmt::format("DELETE FROM checkpoint WHERE cell = {0}; DELETE FROM shadow WHERE cell = {0};", cell));
    for (long i = 0; const MetricsCheckpoint& checkpoint : result.checkpoints) {
      RowBinder row(insert_checkpoint);
      row.add(cell).add(i++).add(checkpoint.t);
      for (const CheckpointColumn& column : kCheckpointColumns) row.add(checkpoint.*column.field);
      insert_checkpoint.exec();
    }
    for (long i = 0; const ShadowResult& shadow : result.shadows) {
      RowBinder row(insert_shadow);
      row.add(cell).add(i++).add(shadow.observer).add(shadow.profile);
      for (const ShadowColumn& column : kShadowColumns) row.add(shadow.*column.field);
      insert_shadow.exec();
    }
  }

  void write_histograms(long cell, const CellTiming& timing) {
    create_histogram_table(database);
    database.exec(fmt::format("DELETE FROM {} WHERE cell = {}", kHistogramTable, cell));
    SQLite::Statement insert(database, insert_into(kHistogramTable, kHistogramColumns));
    for (const HistogramField& histogram : kHistogramFields) {
      const auto& [edges, counts] = timing.*histogram.field;
      for (std::size_t i = 0; i < counts.size(); ++i) {
        RowBinder(insert).add(cell).add(histogram.quantity).add(edges[i]).add(edges[i + 1]).add(counts[i]);
        insert.exec();
      }
    }
  }
};

RunStore::RunStore(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RunStore::~RunStore() = default;

RunStore RunStore::create(const fs::path& dir, const RunInfo& info, const std::vector<ResolvedScenario>& scenarios) {
  check_names(scenarios);
  prepare_directory(dir);
  fill_directory(dir, info, scenarios);
  return open(dir, info);
}

RunStore RunStore::create_numbered(const fs::path& root, const RunInfo& info,
                                   const std::vector<ResolvedScenario>& scenarios) {
  check_names(scenarios);
  const fs::path dir = make_numbered(root);
  fill_directory(dir, info, scenarios);
  return open(dir, info);
}

RunStore RunStore::open(const fs::path& dir, const RunInfo& now) {
  require_same_program(dir, now);
  return RunStore(with_database(dir / kDatabaseFile, [&] { return std::make_unique<Impl>(dir, now); }));
}

RunStore RunStore::resume(const fs::path& dir, const RunInfo& now, const std::vector<ResolvedScenario>& scenarios) {
  require_same_program(dir, now);
  require_same_plan(dir, now, scenarios);
  return open(dir, now);
}

void RunStore::append(const CellResult& cell) {
  impl_->write([&] {
    const long id = impl_->id_of(cell.key);
    impl_->write_result(id, cell);
    impl_->write_lists(id, cell);
  });
}

void RunStore::append(const CellTiming& timing) {
  impl_->write([&] {
    const long id = impl_->id_of(timing.key);
    RowBinder row(impl_->insert_timing);
    row.add(id).add(impl_->batch);
    for (const TimingColumn& column : kTimingColumns) row.add(timing.*column.field);
    impl_->insert_timing.exec();
    impl_->write_histograms(id, timing);
  });
}

std::vector<std::optional<Outcome>> RunStore::outcomes() {
  const std::lock_guard guard(impl_->mutex);
  return with_database(impl_->dir / kDatabaseFile, [&] {
    std::vector<std::optional<Outcome>> outcomes;
    SQLite::Statement query(impl_->database,
                            "SELECT outcome FROM cell LEFT JOIN result ON result.cell = cell.id ORDER BY cell.id");
    while (query.executeStep()) {
      const SQLite::Column outcome = query.getColumn(0);
      outcomes.push_back(outcome.isNull() ? std::nullopt : std::optional(outcome_from(outcome.getString())));
    }
    return outcomes;
  });
}

void RunStore::set_complete(bool complete) {
  impl_->write([&] { impl_->database.exec(fmt::format("UPDATE shard SET complete = {}", complete ? 1 : 0)); });
}

void RunStore::remove(const std::vector<CellKey>& cells) {
  impl_->write([&] {
    for (const CellKey& cell : cells) {
      const long id = impl_->id_of(cell);
      for (const char* table : {"result", "checkpoint", "shadow"}) {
        impl_->database.exec(fmt::format("DELETE FROM {} WHERE cell = {}", table, id));
      }
    }
  });
}

const fs::path& RunStore::dir() const noexcept {
  return impl_->dir;
}

}  // namespace dob
