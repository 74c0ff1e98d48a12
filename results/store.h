// The run directory: what was run, on what, and one row per finished cell.
//
//   run.json                  command line, version, machine, date, and the cells of the run in the order of its tables
//   scenarios/NAME.toml       resolved copies of the scenarios
//   cells.jsonl               one line per finished cell, in the order in which they ended
//   timing.jsonl              wall times by cell, kept apart so that the lines of cells.jsonl are the same bytes in
//                             every run
//
// Numbers are written so that they read back bit for bit; what is not finite is null. The same cell may stand in a
// file twice (it was run again): the later line counts.
#pragma once

#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "results/cell.h"
#include "results/machine.h"

namespace dob {

struct RunInfo {
  std::string command_line;
  std::string version, commit, build, compiler, flags;
  Machine machine;
  std::string date;            // UTC, ISO 8601
  std::vector<CellKey> cells;  // all that belong to the run, in the order of its tables
};

struct ResolvedScenario {
  std::string name;  // <scenario>_<variant>; letters, digits, '_', '-' and '.', the first one not a '.'
  std::string toml;
};

struct Run {
  RunInfo info;
  std::vector<CellResult> cells;    // finished ones, in the order of info.cells
  std::vector<CellTiming> timings;  // of a serial pass, in the order of info.cells; not every cell has one
  std::vector<std::string> notes;   // what was odd and could be read all the same
};

// what() begins with the path, and the line where there is one.
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

  // Opens a run directory to append to it. A last line that was cut short is removed.
  static RunStore open(const std::filesystem::path& dir);

  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;
  ~RunStore();

  // Adds one finished cell. May be called from several threads. When it throws, what was there before is intact.
  void append(const CellResult& cell);

  const std::filesystem::path& dir() const noexcept { return dir_; }

 private:
  explicit RunStore(std::filesystem::path dir);

  std::filesystem::path dir_;
  std::mutex mutex_;
  int cells_fd_ = -1;
  int timing_fd_ = -1;
};

// One cell, its wall time included, as one line of text and back: what a worker process sends home. cell_from_line
// throws StoreError.
std::string cell_to_line(const CellResult& cell);
CellResult cell_from_line(const std::string& line);

// A whole run. An incomplete last line (the run was killed) is ignored and noted; any other line that cannot be read,
// or is not of a cell of the run, is a StoreError.
Run read_run(const std::filesystem::path& dir);

// The cells of read_run.
std::vector<CellResult> read_cells(const std::filesystem::path& dir);

}  // namespace dob
