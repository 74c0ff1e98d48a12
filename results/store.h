// The run directory: what was run, on what, and one row per finished cell.
//
//   run.sqlite                the planned cells in the order of the tables, results, checkpoints, shadow observers,
//                             timings, and what computed each of them (tables: results/run_database.h)
//   scenarios/NAME.toml       resolved copies of the scenarios, for readers; their hashes are in the database
//   run.lock                  locked while a batch writes, so that a second one is refused
//
// One transaction per cell. A process that is killed loses the cell it was writing, nothing else. Numbers read back
// bit for bit; what is not finite is null. A cell that is appended again replaces what was there.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "results/campaign.h"
#include "results/cell.h"
#include "results/code_path.h"
#include "results/interned.h"
#include "results/machine.h"
#include "results/seeded_list.h"

namespace dob {

// From what a cell can be made again.
struct CellSource {
  std::string scenario;  // name of its ResolvedScenario
  std::string observer;  // how it is made, options and routing resolved: observer_toml() of scenarios/loader.h

  friend auto operator<=>(const CellSource&,
                          const CellSource&) = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

// A part of a plan that is computed by itself (--shard), or all of it: number 1 of 1.
struct RunShard {
  int number = 1, count = 1;
  std::size_t planned = 0;  // cells of the whole plan
  std::string plan;         // fingerprint of the whole plan: shards of one plan can be merged (results/merge.h)
  bool complete = false;    // what belongs to it has been run to the end
};

struct RunInfo {
  std::string command_line;
  std::string version, commit, build, compiler, flags;
  Machine machine;
  std::string date;                       // UTC, ISO 8601
  CellKeys cells;                         // all that belong to the run, in the order of its tables
  Interned<CellSource> sources = {};      // of the cells, in their order; or empty
  CodePath code_path = {};                // its fields are "" in a run from before they were kept
  std::vector<long> ids = {};             // places of the cells in the whole plan, from 1, increasing; empty: 1, 2, ...
  std::vector<RunShard> shards = {};      // one, several after a merge, none in a run from before they were kept
  std::optional<Campaign> campaign = {};  // to be stored with the plan; what is read has none: read_campaign()

  Provenance provenance() const { return {version, commit, build, compiler, flags, code_path}; }
};

struct ResolvedScenario {
  std::string name;  // <scenario>_<variant>; letters, digits, '_', '-' and '.', the first one not a '.'
  std::string toml;
};

struct Run {
  RunInfo info;                              // of the batch that began it
  std::vector<CellResult> cells;             // finished ones, in the order of info.cells
  std::vector<CellTiming> timings;           // of a serial pass, in the order of info.cells; not every cell has one
  std::vector<std::string> notes;            // what was odd and could be read all the same
  std::vector<Provenance> programs = {};     // that have computed the cells
  std::vector<std::size_t> program_of = {};  // of each of `cells`: index into `programs`
};

// what() begins with the path of the file or directory.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class RunStore {
 public:
  // Makes `dir` a run directory. It may exist if it is empty; a directory with anything in it is refused.
  static RunStore create(const std::filesystem::path& dir, const RunInfo& info,
                         const std::vector<ResolvedScenario>& scenarios);

  // The same in root/NNNN, NNNN one above the largest number there. Safe against others doing so at the same time.
  static RunStore create_numbered(const std::filesystem::path& root, const RunInfo& info,
                                  const std::vector<ResolvedScenario>& scenarios);

  // Opens a run directory to append to it, by the program and machine of `now` (its cells are not looked at). Refused
  // if version, commit, build, compiler or flags differ from those of the run: results of two programs do not make one
  // table. Another machine is allowed, and read_run notes it.
  static RunStore open(const std::filesystem::path& dir, const RunInfo& now);

  // The same, if cells, resolved options and scenarios are those of the run as well; else says what differs.
  static RunStore resume(const std::filesystem::path& dir, const RunInfo& now,
                         const std::vector<ResolvedScenario>& scenarios);

  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;
  ~RunStore();

  // Adds one finished cell. May be called from several threads. When it throws, what was there before is intact.
  void append(const CellResult& cell);
  void append(const CellTiming& timing);

  // How each planned cell ended, in their order; nullopt: it has not been run.
  std::vector<std::optional<Outcome>> outcomes();

  // Whether nothing is left to be run: what is missing of a merge is then missing elsewhere.
  void set_complete(bool complete);

  // Forgets how these cells ended, if they have.
  void remove(const std::vector<CellKey>& cells);

  const std::filesystem::path& dir() const noexcept;

 private:
  struct Impl;
  explicit RunStore(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

// One cell, its wall time included, as one line of text and back: what a worker process sends home. cell_from_line
// throws StoreError.
std::string cell_to_line(const CellResult& cell);
CellResult cell_from_line(const std::string& line);
std::string timing_to_line(const CellTiming& timing);
CellTiming timing_from_line(const std::string& line);

// True if there is a run in `dir`.
bool is_run_directory(const std::filesystem::path& dir);

// What was run, without the results.
RunInfo read_run_info(const std::filesystem::path& dir);

// A whole run; a batch may be writing it at the same time.
Run read_run(const std::filesystem::path& dir);

// The resolved copy of a scenario, as the run began with it. Throws StoreError when there is none of that name, or when
// its text is not the one whose hash the database holds.
ResolvedScenario read_resolved(const std::filesystem::path& dir, const std::string& name);

// The cells of read_run.
std::vector<CellResult> read_cells(const std::filesystem::path& dir);

}  // namespace dob
