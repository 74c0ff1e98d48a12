#include "results/fall_threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {
namespace {

// The grid of the posterior, in widths of the ladder: 0 is its mildest level, 1 its hardest.
constexpr int kMidpoints = 120;
constexpr int kSlopes = 24;
constexpr double kFirstMidpoint = -0.5, kLastMidpoint = 1.5;
constexpr double kMidpointStep = (kLastMidpoint - kFirstMidpoint) / kMidpoints;
constexpr double kSteepest = 0.02, kFlattest = 1.0;
constexpr std::array kLapses{0.0, 0.05, 0.1};  // of either kind, each as likely before the trials
constexpr std::size_t kLapsePairs = kLapses.size() * kLapses.size();

// The middle of a step of the grid.
double midpoint(int i) {
  return kFirstMidpoint + (i + 0.5) * kMidpointStep;
}

double slope(int i) {
  return kSteepest * std::pow(kFlattest / kSteepest, static_cast<double>(i) / (kSlopes - 1));
}

// Levels against places between 0 and 1.
class Ladder {
 public:
  Ladder(const std::vector<LevelCount>& counts, bool logarithmic)
      : mildest_(counts.front().level),
        hardest_(counts.back().level),
        logarithmic_(logarithmic),
        first_(scaled(mildest_)),
        width_(scaled(hardest_) - first_) {}

  double place_of(double level) const { return (scaled(level) - first_) / width_; }

  // That of an end for places beyond it.
  double level_at(double place) const {
    if (place <= 0.0) return mildest_;
    if (place >= 1.0) return hardest_;
    const double x = first_ + place * width_;
    return logarithmic_ ? std::exp(x) : x;
  }

 private:
  double scaled(double level) const { return logarithmic_ ? std::log(level) : level; }

  double mildest_, hardest_;
  bool logarithmic_;
  double first_, width_;
};

struct Trials {
  double place = 0.0;
  double falls = 0.0, survivals = 0.0;
};

void check_count(const LevelCount& count, bool logarithmic) {
  if (!std::isfinite(count.level)) throw std::invalid_argument("fall threshold: a level that is not finite");
  if (logarithmic && count.level <= 0.0) {
    throw std::invalid_argument(
        fmt::format("fall threshold: level {} of a logarithmic ladder, allowed: above 0", count.level));
  }
  if (count.falls < 0 || count.falls > count.trials) {
    throw std::invalid_argument(
        fmt::format("fall threshold: {} falls in {} trials at level {}", count.falls, count.trials, count.level));
  }
}

void check(const std::vector<LevelCount>& counts, bool logarithmic, double share) {
  if (!(share > 0.0 && share < 1.0)) {
    throw std::invalid_argument(fmt::format("fall threshold: share {}, allowed: between 0 and 1", share));
  }
  if (counts.size() < 2) {
    throw std::invalid_argument(fmt::format("fall threshold: {} levels, at least two are needed", counts.size()));
  }
  for (const LevelCount& count : counts) check_count(count, logarithmic);
  const bool rising = counts[1].level > counts[0].level;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    const double a = counts[i - 1].level, b = counts[i].level;
    if (rising ? b > a : b < a) continue;
    throw std::invalid_argument(fmt::format("fall threshold: level {} after {}, levels must be monotone", b, a));
  }
}

std::vector<Trials> trials_of(const std::vector<LevelCount>& counts, const Ladder& ladder) {
  std::vector<Trials> trials;
  for (const LevelCount& count : counts) {
    if (count.trials == 0) continue;
    trials.push_back({ladder.place_of(count.level), static_cast<double>(count.falls),
                      static_cast<double>(count.trials - count.falls)});
  }
  return trials;
}

// Log-likelihood of the trials for each pair of lapses.
std::array<double, kLapsePairs> log_likelihoods(const std::vector<Trials>& trials, double m, double s) {
  std::array<double, kLapsePairs> sums{};
  for (const Trials& at : trials) {
    // Both parts from the exponential itself: one minus the other would lose the digits of a small one.
    const double e = std::exp(-(at.place - m) / s);
    const double falls = 1.0 / (1.0 + e), survives = e / (1.0 + e);
    std::size_t pair = 0;
    for (const double g : kLapses) {
      for (const double l : kLapses) {
        const double range = 1.0 - g - l;
        if (at.falls > 0.0) sums[pair] += at.falls * std::log(g + range * falls);
        if (at.survivals > 0.0) sums[pair] += at.survivals * std::log(l + range * survives);
        ++pair;
      }
    }
  }
  return sums;
}

// A step of the grid and its part of the posterior, over all lapses.
struct Candidate {
  double m = 0.0, s = 0.0;
  double weight = 0.0;
};

std::vector<Candidate> posterior(const std::vector<Trials>& trials) {
  std::vector<Candidate> candidates;
  std::vector<std::array<double, kLapsePairs>> logs;
  candidates.reserve(kMidpoints * kSlopes);
  logs.reserve(kMidpoints * kSlopes);
  double largest = -HUGE_VAL;
  for (int j = 0; j < kSlopes; ++j) {
    for (int i = 0; i < kMidpoints; ++i) {
      candidates.push_back({midpoint(i), slope(j)});
      logs.push_back(log_likelihoods(trials, candidates.back().m, candidates.back().s));
      largest = std::max(largest, *std::max_element(logs.back().begin(), logs.back().end()));
    }
  }
  double total = 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (const double log : logs[i]) candidates[i].weight += std::exp(log - largest);
    total += candidates[i].weight;
  }
  for (Candidate& candidate : candidates) candidate.weight /= total;
  return candidates;
}

// The threshold of a candidate is at m + s logit(share), spread evenly over a step of the midpoint: so the share of the
// posterior up to a place is a continuous function of it.
double posterior_up_to(double place, const std::vector<Candidate>& candidates, double logit) {
  double sum = 0.0;
  for (const Candidate& candidate : candidates) {
    const double begin = candidate.m + candidate.s * logit - 0.5 * kMidpointStep;
    sum += candidate.weight * std::clamp((place - begin) / kMidpointStep, 0.0, 1.0);
  }
  return sum;
}

// Place below which `part` of the posterior is, by bisection; only between the ends of the ladder, -1 or 2 beyond them.
double posterior_quantile(const std::vector<Candidate>& candidates, double logit, double part) {
  if (posterior_up_to(0.0, candidates, logit) >= part) return -1.0;
  if (posterior_up_to(1.0, candidates, logit) <= part) return 2.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (posterior_up_to(middle, candidates, logit) < part ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

FallThreshold fall_threshold(const std::vector<LevelCount>& counts, bool logarithmic, double share) {
  check(counts, logarithmic, share);
  const Ladder ladder(counts, logarithmic);
  const std::vector<Candidate> candidates = posterior(trials_of(counts, ladder));
  const double logit = std::log(share / (1.0 - share));
  const double mild = posterior_quantile(candidates, logit, 0.025);
  const double hard = posterior_quantile(candidates, logit, 0.975);
  FallThreshold threshold;
  threshold.estimate = ladder.level_at(posterior_quantile(candidates, logit, 0.5));
  threshold.interval = {ladder.level_at(mild), ladder.level_at(hard)};
  if (threshold.interval.low > threshold.interval.high) std::swap(threshold.interval.low, threshold.interval.high);
  threshold.below = mild <= 0.0;
  threshold.above = hard >= 1.0;
  return threshold;
}

}  // namespace dob
