#include "results/table_reference.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace dob {
namespace {

using CellsOfRows = std::map<CellKey, std::map<int, const CellResult*>>;  // by key without seed, then by seed

struct Reference {
  std::string observer;
  std::string profile;  // "": any

  bool is(const CellKey& key) const { return key.observer == observer && (profile.empty() || key.profile == profile); }
};

Reference parse(const std::string& text) {
  const std::size_t at = text.rfind('@');
  return at == std::string::npos ? Reference{text, ""} : Reference{text.substr(0, at), text.substr(at + 1)};
}

std::string name_of(const CellKey& key) {
  return key.observer + "@" + key.profile;
}

void require_in_run(const std::vector<TableRow>& rows, const Reference& reference, const std::string& text) {
  if (std::any_of(rows.begin(), rows.end(), [&](const TableRow& row) { return reference.is(row.key); })) return;
  std::set<std::string> there;
  for (const TableRow& row : rows) there.insert(name_of(row.key));
  throw std::invalid_argument(
      fmt::format("reference '{}': no such observer in this run; allowed: OBSERVER or "
                  "OBSERVER@PROFILE of {}",
                  text, fmt::join(there, ", ")));
}

// The reference's row in the block of `row`; nullptr if it is not there.
const TableRow* find_reference(const std::vector<TableRow>& rows, const Reference& reference, const TableRow& row) {
  const TableRow* first = nullptr;
  for (const TableRow& other : rows) {
    if (!same_block(other.key, row.key) || !reference.is(other.key)) continue;
    if (other.key.profile == row.key.profile) return &other;
    if (first == nullptr) first = &other;
  }
  return first;
}

void compare(TableRow& row, const std::map<int, const CellResult*>& cells,
             const std::map<int, const CellResult*>& reference) {
  std::array<std::vector<double>, kPairedMetrics.size()> differences;
  for (const auto& [seed, cell] : cells) {
    const auto partner = reference.find(seed);
    if (partner == reference.end()) continue;
    const auto both = on_common_time(*partner->second, *cell);
    if (!both) continue;
    for (std::size_t i = 0; i < kPairedMetrics.size(); ++i) {
      const auto value = kPairedMetrics[i].value;
      if (both->first.*value && both->second.*value)
        differences[i].push_back(*(both->second.*value) - *(both->first.*value));
    }
  }
  std::transform(differences.begin(), differences.end(), row.paired.begin(), summarise_differences);
}

}  // namespace

void compare_with_reference(std::vector<TableRow>& rows, const Run& run, const std::string& reference) {
  const Reference chosen = parse(reference.empty() ? "none" : reference);
  if (!reference.empty()) require_in_run(rows, chosen, reference);
  CellsOfRows cells;
  for (const CellResult& cell : run.cells) cells[without_seed(cell.key)][cell.key.seed] = &cell;
  for (TableRow& row : rows) {
    const TableRow* other = find_reference(rows, chosen, row);
    if (other == nullptr || other == &row) continue;
    row.reference = name_of(other->key);
    compare(row, cells[row.key], cells[other->key]);
  }
}

}  // namespace dob
