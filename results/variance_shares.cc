#include "results/variance_shares.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

using Seeds = std::vector<std::size_t>;

std::size_t size(int n) {
  return static_cast<std::size_t>(n);
}

std::size_t product(const std::vector<int>& levels) {
  return std::accumulate(levels.begin(), levels.end(), std::size_t{1},
                         [](std::size_t sum, int n) { return sum * size(n); });
}

// A factor or a pair of factors, and for each seed the sums of the values at its levels or combinations.
struct Effect {
  std::string name;
  std::vector<std::size_t> factors;
  std::vector<std::size_t> mains = {};  // of a pair: its factors among the effects
  int levels = 0;
  std::vector<std::vector<double>> sums = {};
};

// The design about its mean, with what of it every resample needs.
struct Sums {
  std::size_t combinations = 0;  // of factors
  std::vector<Effect> effects;
  std::vector<double> of_seed, squares_of_seed;
};

std::vector<Effect> effects_of(const FactorialDesign& design) {
  std::vector<Effect> effects;
  for (std::size_t i = 0; i < design.factors.size(); ++i) {
    if (design.levels[i] > 1)
      effects.push_back({.name = design.factors[i], .factors = {i}, .levels = design.levels[i]});
  }
  const std::size_t mains = effects.size();
  for (std::size_t a = 0; a < mains; ++a) {
    for (std::size_t b = a + 1; b < mains; ++b) {
      effects.push_back({.name = effects[a].name + " x " + effects[b].name,
                         .factors = {effects[a].factors[0], effects[b].factors[0]},
                         .mains = {a, b},
                         .levels = effects[a].levels * effects[b].levels});
    }
  }
  return effects;
}

// Levels of the factors in the combination of that number.
std::vector<std::size_t> levels_at(std::size_t combination, const FactorialDesign& design) {
  std::vector<std::size_t> levels(design.factors.size());
  for (std::size_t i = levels.size(); i-- > 0;) {
    levels[i] = combination % size(design.levels[i]);
    combination /= size(design.levels[i]);
  }
  return levels;
}

Sums sums_of(const FactorialDesign& design) {
  const std::size_t seeds = size(design.levels.back());
  const double mean =
      std::accumulate(design.values.begin(), design.values.end(), 0.0) / static_cast<double>(design.values.size());
  Sums sums{design.values.size() / seeds, effects_of(design), std::vector<double>(seeds), std::vector<double>(seeds)};
  for (Effect& effect : sums.effects) effect.sums.assign(seeds, std::vector<double>(size(effect.levels)));
  for (std::size_t c = 0; c < sums.combinations; ++c) {
    const std::vector<std::size_t> levels = levels_at(c, design);
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      const double value = design.values[c * seeds + seed] - mean;
      sums.of_seed[seed] += value;
      sums.squares_of_seed[seed] += value * value;
      for (Effect& effect : sums.effects) {
        std::size_t at = 0;
        for (const std::size_t factor : effect.factors) at = at * size(design.levels[factor]) + levels[factor];
        effect.sums[seed][at] += value;
      }
    }
  }
  return sums;
}

// Sum of squares between the levels of an effect, with that of the mean still in it.
double raw_squares(const Effect& effect, const Seeds& drawn, double values) {
  double squares = 0.0;
  for (std::size_t at = 0; at < size(effect.levels); ++at) {
    double sum = 0.0;
    for (const std::size_t seed : drawn) sum += effect.sums[seed][at];
    squares += sum * sum;
  }
  return squares / (values / effect.levels);
}

// Shares of the effects, then the seed, then the residual, with the seeds that were drawn; none if nothing varies more
// than by rounding.
std::vector<double> shares_of(const Sums& sums, const Seeds& drawn, double smallest_total) {
  const double values = static_cast<double>(sums.combinations * drawn.size());
  double sum = 0.0, total = 0.0, between_seeds = 0.0;
  for (const std::size_t seed : drawn) {
    sum += sums.of_seed[seed];
    total += sums.squares_of_seed[seed];
    between_seeds += sums.of_seed[seed] * sums.of_seed[seed] / static_cast<double>(sums.combinations);
  }
  const double of_mean = sum * sum / values;
  total -= of_mean;
  if (total <= smallest_total) return {};
  std::vector<double> squares;
  for (const Effect& effect : sums.effects) {
    squares.push_back(raw_squares(effect, drawn, values) - of_mean);
    for (const std::size_t main : effect.mains) squares.back() -= squares[main];
  }
  squares.push_back(between_seeds - of_mean);
  squares.push_back(total - std::accumulate(squares.begin(), squares.end(), 0.0));
  for (double& x : squares) x = std::max(x, 0.0) / total;  // below 0 by rounding only
  return squares;
}

std::vector<std::optional<Interval>> bootstrap(const Sums& sums, std::size_t shares, double smallest_total) {
  const std::size_t seeds = sums.of_seed.size();
  std::vector<std::optional<Interval>> intervals(shares);
  if (seeds < size(kMinSamplesForInterval)) return intervals;
  std::mt19937_64 random(kBootstrapSeed);
  std::vector<std::vector<double>> samples(shares);
  Seeds drawn(seeds);
  for (int i = 0; i < kResamples; ++i) {
    for (std::size_t& seed : drawn) seed = random() % seeds;
    const std::vector<double> resampled = shares_of(sums, drawn, smallest_total);
    for (std::size_t k = 0; k < resampled.size(); ++k) samples[k].push_back(resampled[k]);
  }
  for (std::size_t k = 0; k < shares; ++k) {
    if (!samples[k].empty()) intervals[k] = Interval{quantile(samples[k], 0.025), quantile(samples[k], 0.975)};
  }
  return intervals;
}

void check(const FactorialDesign& design) {
  if (design.levels.size() == design.factors.size() + 1 && product(design.levels) == design.values.size()) return;
  throw std::invalid_argument(fmt::format("variance shares: {} values of {} factors do not fill the design",
                                          design.values.size(), design.factors.size()));
}

}  // namespace

std::vector<VarianceShare> variance_shares(const FactorialDesign& design) {
  check(design);
  const auto [least, most] = std::minmax_element(design.values.begin(), design.values.end());
  if (least == most || *least == *most) return {};
  const Sums sums = sums_of(design);
  Seeds all(sums.of_seed.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const double rounding = 1e-12 * std::accumulate(sums.squares_of_seed.begin(), sums.squares_of_seed.end(), 0.0);
  const std::vector<double> shares = shares_of(sums, all, rounding);
  const std::vector<std::optional<Interval>> intervals = bootstrap(sums, shares.size(), rounding);
  std::vector<VarianceShare> result;
  for (std::size_t i = 0; i < sums.effects.size(); ++i) {
    result.push_back({sums.effects[i].name, sums.effects[i].levels, shares[i], intervals[i]});
  }
  const std::size_t seed = sums.effects.size();
  if (all.size() > 1) result.push_back({"seed", design.levels.back(), shares[seed], intervals[seed]});
  std::stable_sort(result.begin(), result.end(),
                   [](const VarianceShare& a, const VarianceShare& b) { return a.share > b.share; });
  result.push_back({"residual", 0, shares.back(), intervals.back()});
  return result;
}

}  // namespace dob
