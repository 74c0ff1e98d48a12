// A run as the claims see it: its cells grouped over their seeds, found by case and observer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/store.h"

namespace dob {

// All seeds of one row of the comparison table.
struct CellGroup {
  CellKey key;                         // its seed has no meaning
  int planned = 0;                     // cells that belong to it, run yet or not
  int errors = 0;                      // cells that could not be run
  std::vector<const CellResult*> ran;  // survived or fell
};

// "scenario/variant", or "scenario" where there is no variant.
std::string case_name(const CellKey& key);

// What a row of the claims' table has in common besides case and observer.
struct Setting {
  std::string profile, gains, planner, overrides;

  friend auto operator<=>(const Setting&, const Setting&) = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

// The groups of a run, in the order of its cells. The run must outlive it.
class CellGroups {
 public:
  explicit CellGroups(const Run& run);

  const std::vector<CellGroup>& all() const noexcept { return groups_; }

  // An observer without profiles ("-") answers for every profile. nullptr: not part of the run.
  const CellGroup* find(const std::string& case_name, const std::string& observer, const Setting& setting) const;

  // The names of cases that match the pattern, in which * stands for any characters.
  std::vector<std::string> cases(const std::string& pattern) const;

 private:
  std::vector<CellGroup> groups_;
};

// What an evaluator is given: the cases of one row under one setting.
class ClaimView {
 public:
  ClaimView(const CellGroups& cells, std::vector<std::string> cases, Setting setting)
      : cells_(&cells), cases_(std::move(cases)), setting_(std::move(setting)) {}

  // The same question about another observer: whoever asks for `observer` gets `substitute`.
  void substitute(std::string observer, std::string substitute);

  // The groups of an observer, in the order of the cases; cases that are not part of the run are left out.
  std::vector<const CellGroup*> groups(const std::string& observer) const;
  // nullptr: not part of the run.
  const CellGroup* group(const std::string& case_name, const std::string& observer) const;
  // The name under which an observer is found.
  const std::string& name_of(const std::string& observer) const;
  const Setting& setting() const noexcept { return setting_; }

 private:
  const CellGroups* cells_;
  std::vector<std::string> cases_;
  Setting setting_;
  std::string observer_, substitute_;
};

}  // namespace dob
