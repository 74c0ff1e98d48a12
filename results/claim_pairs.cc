#include "results/claim_pairs.h"

#include <algorithm>

#include "results/claim_finding.h"
#include "results/metric_fields.h"
#include "results/paired.h"
#include "results/statistics.h"

namespace dob {
namespace {

void add_pairs(const CellGroup& a, const CellGroup& b, std::size_t metric, PairedFigures& figures) {
  for (const CellResult* one : a.ran) {
    for (const CellResult* other : b.ran) {
      if (one->key.seed != other->key.seed) continue;
      const std::optional<FigurePair> pair = paired_figures(*one, *other, kMetricFields.at(metric));
      if (!pair) continue;
      figures.a.push_back(pair->a);
      figures.b.push_back(pair->b);
      const bool cut = one->outcome == Outcome::kFell || other->outcome == Outcome::kFell;
      if (cut) figures.until = std::min(pair->t, figures.until.value_or(pair->t));
    }
  }
}

}  // namespace

PairedFigures pair_by_seed(const CellGroup& a, const CellGroup& b, std::size_t metric) {
  PairedFigures figures;
  add_pairs(a, b, metric, figures);
  return figures;
}

PairedFigures pair_by_case(const std::vector<const CellGroup*>& a, const std::vector<const CellGroup*>& b,
                           std::size_t metric) {
  PairedFigures figures;
  for (const CellGroup* one : a) {
    for (const CellGroup* other : b) {
      if (case_name(one->key) == case_name(other->key)) add_pairs(*one, *other, metric, figures);
    }
  }
  return figures;
}

std::string describe_all(std::size_t metric, const std::vector<double>& figures) {
  return describe(metric, median(figures), *std::max_element(figures.begin(), figures.end()), figures.size());
}

}  // namespace dob
