#include "results/time_histogram.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kBinsPerDecade = 20.0;
constexpr double kShortest = 0.01;  // [us] no clock tells less apart

double edge(int k) {
  return std::pow(10.0, k / kBinsPerDecade);
}

// The k with edge(k) <= duration < edge(k + 1); rounding of the logarithm does not move what lies on an edge.
int bin_of(double duration_us) {
  if (!(std::isfinite(duration_us) && duration_us >= 0.0)) {
    throw std::invalid_argument(fmt::format("duration {} us, must be finite and >= 0", duration_us));
  }
  const double duration = std::max(duration_us, kShortest);
  int k = static_cast<int>(std::floor(kBinsPerDecade * std::log10(duration)));
  while (edge(k) > duration) --k;
  while (edge(k + 1) <= duration) ++k;
  return k;
}

}  // namespace

TimeHistogram time_histogram(const std::vector<double>& durations_us) {
  std::map<int, long> bins;
  for (const double duration : durations_us) ++bins[bin_of(duration)];
  TimeHistogram histogram;
  if (bins.empty()) return histogram;
  const int first = bins.begin()->first, last = bins.rbegin()->first;
  for (int k = first; k <= last; ++k) {
    histogram.edges_us.push_back(edge(k));
    histogram.counts.push_back(bins[k]);
  }
  histogram.edges_us.push_back(edge(last + 1));
  return histogram;
}

}  // namespace dob
