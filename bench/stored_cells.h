// The cells of a run from what its directory holds of them: the resolved scenarios and the observers' resolved options,
// not the scenario files and profiles of today.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/batch_plan.h"
#include "results/store.h"

namespace dob {

struct StoredCell {
  CellKey key;
  PlannedObserver observer;
  const Scenario* scenario = nullptr;
  std::string obstacle;  // why it cannot be computed again; "" when it can
};

class StoredCells {
 public:
  // `plugins`: the libraries that may be loaded. Plugins are code: one that the run directory names is loaded only if
  // the user names a library with the same content. Throws StoreError for a run that does not hold what its cells were
  // made from, std::runtime_error for a library that cannot be read.
  StoredCells(std::filesystem::path dir, const RunInfo& info, const std::vector<std::filesystem::path>& plugins);

  // The scenario lives as long as this. Throws StoreError when the run directory has been changed.
  StoredCell of(const CellResult& row);

 private:
  struct Loaded {
    std::optional<Scenario> scenario;
    std::string obstacle;
  };
  const Loaded& scenario_of(const std::string& name);
  std::string library_for(const std::string& path, const std::string& source) const;
  void take_plugins(ObserverConfig& observer, const std::string& source) const;

  std::filesystem::path dir_;
  std::map<CellKey, CellSource> sources_;
  std::map<std::string, std::filesystem::path> plugins_;  // fingerprint -> library
  std::map<std::string, Loaded> scenarios_;               // by the name of their resolved copy
};

}  // namespace dob
