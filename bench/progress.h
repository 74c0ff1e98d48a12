// The progress line of a batch on stderr.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "results/cell.h"

namespace dob {

class Progress {
 public:
  // `done` of `cells` are finished already; `cost` is the expected work of the others, in any unit. Silent unless
  // `visible`.
  Progress(std::size_t cells, std::size_t done, double cost, bool visible);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // A cell of this expected cost has ended.
  void add(const CellResult& cell, double cost);

  // "12/60 cells, 3 falls, 1 error, 2 min left": the time left from the share of the work done in `elapsed_s`.
  std::string line(double elapsed_s) const;

 private:
  std::size_t cells_, done_, falls_ = 0, errors_ = 0;
  double cost_, cost_done_ = 0.0;
  bool visible_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace dob
