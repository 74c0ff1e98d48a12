#include "results/campaign_factorial.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/variance_shares.h"

namespace dob {
namespace {

using CurveCells = std::vector<std::vector<CurveCell>>;
using Response = std::function<std::optional<double>(const CurveCell&)>;

void check_factors(const Campaign& campaign) {
  std::set<std::vector<std::string>> known;
  for (const CampaignCurve& curve : campaign.curves) {
    if (curve.factors.size() != campaign.factors.size()) {
      throw std::invalid_argument(fmt::format("campaign: a curve with levels of {} factors, there are {}",
                                              curve.factors.size(), campaign.factors.size()));
    }
    if (!known.insert(curve.factors).second) {
      throw std::invalid_argument(
          fmt::format("campaign: two curves with the same levels of the factors: {}", fmt::join(curve.factors, ", ")));
    }
  }
}

// Numbers of the levels of each factor, in the order of first mention, and last of the seeds.
struct Numbering {
  std::vector<std::map<std::string, std::size_t>> factors;
  std::map<int, std::size_t> seeds;

  std::vector<int> sizes() const {
    std::vector<int> sizes;
    for (const auto& levels : factors) sizes.push_back(static_cast<int>(levels.size()));
    sizes.push_back(static_cast<int>(seeds.size()));
    return sizes;
  }

  // Place of a value in a design.
  std::size_t place(const CampaignCurve& curve, int seed) const {
    std::size_t place = 0;
    for (std::size_t f = 0; f < factors.size(); ++f) {
      place = place * factors[f].size() + factors[f].at(curve.factors[f]);
    }
    return place * seeds.size() + seeds.at(seed);
  }
};

Numbering numbering(const Campaign& campaign, const CurveCells& cells) {
  Numbering numbers{std::vector<std::map<std::string, std::size_t>>(campaign.factors.size()), {}};
  for (const CampaignCurve& curve : campaign.curves) {
    for (std::size_t f = 0; f < curve.factors.size(); ++f) {
      numbers.factors[f].try_emplace(curve.factors[f], numbers.factors[f].size());
    }
  }
  std::set<int> seeds;
  for (const auto& of_curve : cells) {
    for (const CurveCell& cell : of_curve) seeds.insert(cell.seed);
  }
  for (const int seed : seeds) numbers.seeds.emplace(seed, numbers.seeds.size());
  return numbers;
}

PartialDesign design_of(const Campaign& campaign, const CurveCells& cells, const Response& response) {
  const Numbering numbers = numbering(campaign, cells);
  PartialDesign design{campaign.factors, numbers.sizes(), {}};
  std::size_t places = 1;
  for (const int levels : design.levels) places *= static_cast<std::size_t>(levels);
  design.values.resize(places);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const CurveCell& cell : cells[c]) {
      design.values[numbers.place(campaign.curves[c], cell.seed)] = response(cell);
    }
  }
  return design;
}

FactorialResult result_of(const std::string& name, const Campaign& campaign, const CurveCells& cells,
                          const Response& response) {
  const FactorialDesign design = complete_part(design_of(campaign, cells, response));
  FactorialResult result;
  result.response = name;
  result.trials = static_cast<int>(design.values.size());
  result.left_out = static_cast<int>(campaign.cells.size()) - result.trials;
  result.shares = variance_shares(design);
  return result;
}

std::optional<double> falls(const CurveCell& cell) {
  if (fell(cell)) return 1.0;
  return survived(cell) ? std::optional(0.0) : std::nullopt;
}

std::optional<double> log_error(const CurveCell& cell) {
  if (!survived(cell)) return std::nullopt;
  const std::optional<double> error = cell.result->metrics.com_error_max_m;
  return error && *error > 0.0 && std::isfinite(*error) ? std::optional(std::log10(*error)) : std::nullopt;
}

// The logarithm of the error, for a fall that of the worst survivor.
Response log_error_with_falls(const CurveCells& cells) {
  std::optional<double> worst;
  for (const auto& of_curve : cells) {
    for (const CurveCell& cell : of_curve) worst = std::max(worst, log_error(cell));  // nullopt is the least
  }
  return [worst](const CurveCell& cell) { return fell(cell) ? worst : log_error(cell); };
}

}  // namespace

std::vector<FactorialResult> factorial_results(const Campaign& campaign, const CurveCells& cells) {
  check_factors(campaign);
  return {result_of("falls", campaign, cells, falls),
          result_of("log CoM error", campaign, cells, log_error_with_falls(cells))};
}

}  // namespace dob
