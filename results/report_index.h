// What the page calls the parts of a run. Private to results/.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "results/seeded_list.h"
#include "results/store_json.h"

namespace dob {

// Scenarios (with their variants), observers (with their profiles) and settings (gains, planner, overrides) of a list
// of cells, each in the order of first mention.
class ReportIndex {
 public:
  explicit ReportIndex(const CellKeys& cells);

  // The first cell of each.
  const std::vector<CellKey>& scenarios() const noexcept { return scenarios_.first; }
  const std::vector<CellKey>& observers() const noexcept { return observers_.first; }
  const std::vector<CellKey>& settings() const noexcept { return settings_.first; }

  // Places in these lists, of a cell that belongs to the list of cells.
  std::size_t scenario(const CellKey& cell) const;
  std::size_t observer(const CellKey& cell) const;
  std::size_t setting(const CellKey& cell) const;

  std::string scenario_id(const CellKey& cell) const;         // "case1/knee_lateral"
  const std::string& observer_id(const CellKey& cell) const;  // "momentum@tuned", "none"; unique

  // {"scenario_id", "observer_id", "setting"}
  Json ids(const CellKey& cell) const;

 private:
  struct Part {
    std::vector<CellKey> first;
    std::map<std::vector<std::string>, std::size_t> places;
    void add(const std::vector<std::string>& name, const CellKey& cell);
  };

  Part scenarios_, observers_, settings_;
  std::vector<std::string> observer_ids_;
};

}  // namespace dob
