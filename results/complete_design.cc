#include <algorithm>
#include <numeric>

#include "results/variance_shares.h"

namespace dob {
namespace {

using Kept = std::vector<std::vector<bool>>;  // of each dimension (factors, then the seed): which of its levels

// What a level of a dimension has within what is kept of the others.
struct Slice {
  std::size_t dimension = 0, level = 0;
  int values = 0, missing = 0;

  double lacks() const { return static_cast<double>(missing) / (values + missing); }
};

// Walks over the combinations of the levels, the last dimension fastest.
class Combination {
 public:
  explicit Combination(const std::vector<int>& sizes) : sizes_(sizes), levels_(sizes.size(), 0) {}

  const std::vector<std::size_t>& levels() const { return levels_; }
  bool in(const Kept& kept) const {
    for (std::size_t d = 0; d < levels_.size(); ++d) {
      if (!kept[d][levels_[d]]) return false;
    }
    return true;
  }
  void next() {
    for (std::size_t d = levels_.size(); d-- > 0;) {
      if (++levels_[d] < static_cast<std::size_t>(sizes_[d])) return;
      levels_[d] = 0;
    }
  }

 private:
  const std::vector<int>& sizes_;
  std::vector<std::size_t> levels_;
};

std::vector<Slice> slices_of(const PartialDesign& design, const Kept& kept) {
  std::vector<std::vector<Slice>> slices(kept.size());
  for (std::size_t d = 0; d < kept.size(); ++d) {
    for (std::size_t level = 0; level < kept[d].size(); ++level) slices[d].push_back({d, level});
  }
  Combination place(design.levels);
  for (const std::optional<double>& value : design.values) {
    if (place.in(kept)) {
      for (std::size_t d = 0; d < kept.size(); ++d) {
        Slice& slice = slices[d][place.levels()[d]];
        ++(value ? slice.values : slice.missing);
      }
    }
    place.next();
  }
  std::vector<Slice> all;
  for (const auto& of_dimension : slices) all.insert(all.end(), of_dimension.begin(), of_dimension.end());
  return all;
}

// That which lacks most; the one behind among equals, so that seeds go first.
const Slice* worst_of(const std::vector<Slice>& slices) {
  const Slice* worst = nullptr;
  for (const Slice& slice : slices) {
    if (slice.missing > 0 && (worst == nullptr || slice.lacks() >= worst->lacks())) worst = &slice;
  }
  return worst;
}

}  // namespace

FactorialDesign complete_part(const PartialDesign& design) {
  Kept kept;
  for (const int levels : design.levels) kept.emplace_back(static_cast<std::size_t>(levels), true);
  for (;;) {
    const std::vector<Slice> slices = slices_of(design, kept);
    const Slice* worst = worst_of(slices);
    if (worst == nullptr) break;
    kept[worst->dimension][worst->level] = false;
  }
  FactorialDesign complete{design.factors, {}, {}};
  for (const std::vector<bool>& levels : kept) {
    complete.levels.push_back(static_cast<int>(std::count(levels.begin(), levels.end(), true)));
  }
  Combination place(design.levels);
  for (const std::optional<double>& value : design.values) {
    if (place.in(kept)) complete.values.push_back(value.value());
    place.next();
  }
  return complete;
}

}  // namespace dob
