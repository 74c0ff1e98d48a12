// Run directories and traces made by hand for the tests of figures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/figure_spec.h"
#include "results/store.h"
#include "results/trace.h"
#include "test/results/run_samples.h"

namespace dob::test {

// 100 samples per second from 0 on; `columns` as name and value(t).
template <typename... Value>
Trace trace_of(std::size_t rows, const std::pair<const char*, Value>&... columns) {
  Trace trace{100.0, {"t_s"}, {{}}};
  for (std::size_t i = 0; i < rows; ++i) trace.columns[0].push_back(0.01F * static_cast<float>(i));
  [[maybe_unused]] const auto add = [&](const char* name, auto value) {
    trace.names.emplace_back(name);
    trace.columns.emplace_back();
    for (const float t : trace.columns[0]) trace.columns.back().push_back(static_cast<float>(value(t)));
  };
  (add(columns.first, columns.second), ...);
  return trace;
}

// A directory with one trace file; its cells are given to FigureCells as a Run, without a database.
class FigureRun {
 public:
  std::filesystem::path dir() const { return temporary_.path(); }

  CellResult& add(CellResult cell) {
    run.info.cells.push_back(cell.key);
    run.cells.push_back(std::move(cell));
    return run.cells.back();
  }

  CellResult& add(CellResult cell, const Trace& trace) {
    cell.trace = "cell" + std::to_string(run.cells.size()) + ".dobtrace";
    write_trace(dir() / cell.trace, trace);
    return add(std::move(cell));
  }

  Run run;

 private:
  TemporaryDirectory temporary_;
};

inline FigureQuantity quantity(std::vector<std::string> signals) {
  FigureQuantity q;
  q.id = "q";
  q.axis = "error $ [mm]";
  q.scale = 1000.0;
  q.signals = std::move(signals);
  return q;
}

}  // namespace dob::test
