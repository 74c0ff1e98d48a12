#include "results/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>

namespace dob {
namespace {

constexpr double kNormalQuantile975 = 1.959963984540054;

}  // namespace

double quantile(std::vector<double> samples, double p) {
  if (samples.empty()) throw std::invalid_argument("quantile of no samples");
  if (!(p >= 0.0 && p <= 1.0)) {
    throw std::invalid_argument("quantile p = " + std::to_string(p) + ", allowed: 0 to 1");
  }
  if (!std::all_of(samples.begin(), samples.end(), [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("quantile of a sample that is not finite");
  }
  const double h = static_cast<double>(samples.size() - 1) * p;
  const auto below = samples.begin() + static_cast<std::ptrdiff_t>(std::floor(h));
  std::nth_element(samples.begin(), below, samples.end());
  const double fraction = h - std::floor(h);
  if (fraction == 0.0) return *below;
  const double above = *std::min_element(below + 1, samples.end());
  return *below + fraction * (above - *below);
}

double median(std::vector<double> samples) {
  return quantile(std::move(samples), 0.5);
}

std::optional<Interval> wilson_interval(int successes, int trials) {
  if (successes < 0 || successes > trials) {
    throw std::invalid_argument(std::to_string(successes) + " successes in " + std::to_string(trials) + " trials");
  }
  if (trials < kMinSamplesForInterval) return std::nullopt;
  const double n = trials;
  const double share = successes / n;
  const double z2 = kNormalQuantile975 * kNormalQuantile975;
  const double center = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = kNormalQuantile975 / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
  // At the ends the bound is exactly 0 or 1; rounding must not say otherwise.
  return Interval{successes == 0 ? 0.0 : center - half, successes == trials ? 1.0 : center + half};
}

std::optional<Interval> bootstrap_median_interval(std::vector<double> samples) {
  if (samples.size() < static_cast<std::size_t>(kMinSamplesForInterval)) return std::nullopt;
  std::sort(samples.begin(), samples.end());
  std::mt19937_64 random(kBootstrapSeed);
  std::vector<double> medians;
  medians.reserve(kResamples);
  std::vector<double> resample(samples.size());
  for (int i = 0; i < kResamples; ++i) {
    for (double& x : resample) x = samples[random() % samples.size()];
    medians.push_back(median(resample));
  }
  return Interval{quantile(medians, 0.025), quantile(medians, 0.975)};
}

}  // namespace dob
