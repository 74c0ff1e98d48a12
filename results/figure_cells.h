// Which cells of a run a figure shows, and their time series.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/figure_spec.h"
#include "results/store.h"
#include "results/trace.h"

namespace dob {

// What the user wants to see; "" and empty: what the run has, see FigureCells.
struct FigureRequest {
  std::string profile, gains, planner;
  std::vector<std::string> observers;  // instead of those of a figure
};

// A cell that can be drawn. Valid as long as the FigureCells.
struct FigureCell {
  const CellResult* cell = nullptr;
  const Trace* trace = nullptr;
};

class FigureCells {
 public:
  // Without a wish: profile `tuned`, else the first one of the run; of each scenario the gains `paper`, else its first
  // ones (a robot of one's own has its own); the first planner. Throws StoreError if the run has nothing of what is
  // wished for.
  FigureCells(const std::filesystem::path& dir, Run run, const FigureRequest& request);

  const Run& run() const noexcept { return run_; }
  // What is shown; gains that differ between scenarios as a list, "paper, own".
  const FigureRequest& request() const noexcept { return request_; }
  const std::filesystem::path& dir() const noexcept { return dir_; }

  // In the order of first mention, without those of scenarios in `leave_out`.
  std::vector<std::string> observers(const std::vector<std::string>& leave_out = {}) const;

  // Whether the cell is of the profile, gains and planner that are shown.
  bool shown(const CellKey& key, const std::string& profile) const noexcept;

  // The first of the scenarios (SCENARIO or SCENARIO/VARIANT) that the run has with the observer; of its seeds the
  // first. Throws StoreError that says why there is nothing to draw. `profile`: "" for the one that is wished for.
  FigureCell find(const std::vector<std::string>& scenarios, const std::string& observer, const std::string& profile);

 private:
  std::optional<CellKey> planned(const std::string& scenario, const std::string& observer,
                                 const std::string& profile) const;
  const Trace& trace(const CellResult& cell);

  std::filesystem::path dir_;
  Run run_;
  FigureRequest request_;
  std::map<std::string, std::string> gains_;  // by scenario
  std::map<std::string, Trace> traces_;       // by file
};

}  // namespace dob
