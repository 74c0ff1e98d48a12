// Statistics of small samples: what a table says about the seeds of one row.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace dob {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// Below this many samples an interval would say more about its method than about the data: nullopt instead.
inline constexpr int kMinSamplesForInterval = 8;

// Of every bootstrap: how many resamples, and the seed of the std::mt19937_64 that draws them, index = draw modulo
// number of samples. The engine's output is fixed by the standard, std::uniform_int_distribution's is not; the bias of
// the modulo is below n / 2^64.
inline constexpr int kResamples = 2000;
inline constexpr std::uint64_t kBootstrapSeed = 20210827;

// Quantile 0 <= p <= 1 by linear interpolation between order statistics (type 7 of Hyndman & Fan, 1996): with sorted
// x_0 ... x_(n-1) and h = (n - 1) p it is x_floor(h) + (h - floor(h)) (x_floor(h)+1 - x_floor(h)).
// Throws std::invalid_argument for no samples, a sample that is not finite, or p out of range.
double quantile(std::vector<double> samples, double p);

// The quantile 1/2: the middle sample, or the mean of the two in the middle. Throws as quantile does.
double median(std::vector<double> samples);

// Wilson's score interval (1927), 95 %, of the share of successes; nullopt below kMinSamplesForInterval trials.
// Throws std::invalid_argument unless 0 <= successes <= trials.
std::optional<Interval> wilson_interval(int successes, int trials);

// Percentile bootstrap interval, 95 %, of the median: quantiles 0.025 and 0.975 of the medians of 2000 resamples.
// Seeded, independent of the order of the samples, and the same bits with every standard library; nullopt below
// kMinSamplesForInterval samples. Throws as quantile does.
std::optional<Interval> bootstrap_median_interval(std::vector<double> samples);

}  // namespace dob
