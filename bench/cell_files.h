// The files that a cell leaves in its run directory besides its row.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "bench/batch_plan.h"
#include "bench/signals.h"
#include "results/trace.h"

namespace dob {

// A file name for the cell that stands at `index` of the plan, without extension: unique in its run; letters, digits,
// '.', '_' and '-' only.
std::string cell_file_name(std::size_t index, const CellKey& key);

// Collects the ticks of a trial as a trace of about `rate` [Hz].
class TraceRecorder {
 public:
  TraceRecorder(double rate, double dt);
  void add(const TickRecord& tick);
  const Trace& trace() const noexcept { return trace_; }

 private:
  std::vector<Signal> signals_;
  Decimation decimation_;
  Trace trace_;
};

}  // namespace dob
