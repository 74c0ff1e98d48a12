// Time series of a cell, kept for reports and figures: traces/CELL.dobtrace in the run directory.
//
// The file, all numbers little-endian: the eight characters "dobtrace"; version (uint32, 1); length of the head
// (uint32); the head, JSON {"rate_Hz": ..., "rows": ..., "names": [...]}; then one zlib stream of the columns, one
// after the other, each `rows` float32 with its bytes sorted by significance (all lowest bytes first), which halves it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dob {

struct Trace {
  double rate_Hz = 0.0;
  std::vector<std::string> names;           // unique; the first one is the time, t_s
  std::vector<std::vector<float>> columns;  // one for each name, equally long; NaN where a value does not apply

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  // Throws StoreError if there is no such column.
  const std::vector<float>& column(const std::string& name) const;
};

// Complete or absent, never half written. Throws StoreError.
void write_trace(const std::filesystem::path& file, const Trace& trace);

// Throws StoreError if it cannot be read, is not a trace, is of another version, or is damaged.
Trace read_trace(const std::filesystem::path& file);

}  // namespace dob
