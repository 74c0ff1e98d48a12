#include "bench/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "bench/trial.h"
#include "results/statistics.h"

namespace dob {
namespace {

constexpr double kWarmUp = 0.1;  // [s]

std::vector<double> without_warm_up(const std::vector<double>& samples, double per_second) {
  const auto first = static_cast<std::ptrdiff_t>(std::lround(kWarmUp * per_second));
  if (std::ssize(samples) <= first) throw std::runtime_error(fmt::format("fell within the first {} s", kWarmUp));
  return {samples.begin() + first, samples.end()};
}

}  // namespace

CellTiming time_cell(const CellKey& key, const Scenario& scenario, const ObserverConfig& observer, double seconds) {
  const double duration = seconds > 0.0 ? std::min(seconds, scenario.duration) : scenario.duration;
  Trial trial(scenario, observer, key.seed);
  const long ticks = std::lround(duration / scenario.sim.dt);
  TickClock clock(static_cast<std::size_t>(ticks));
  trial.time_ticks(clock);
  const auto begin = std::chrono::steady_clock::now();
  for (long k = 0; k < ticks && trial.tick(); ++k) {
  }
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::vector<double> tick = without_warm_up(clock.tick_us(), 1.0 / scenario.sim.dt);
  const std::vector<double> qp = without_warm_up(clock.qp_us(), scenario.controller.qp_rate);
  return {.key = key,
          .tick_p50_us = median(tick),
          .tick_p99_us = quantile(tick, 0.99),
          .tick_max_us = quantile(tick, 1.0),
          .qp_p50_us = median(qp),
          .qp_p99_us = quantile(qp, 0.99),
          .qp_max_us = quantile(qp, 1.0),
          .real_time_factor = trial.time() / wall_s,
          .tick_histogram = time_histogram(tick),
          .qp_histogram = time_histogram(qp)};
}

std::vector<PlannedCell> first_seeds(const BatchPlan& plan) {
  std::vector<PlannedCell> first;
  for (const PlannedCell& cell : plan.cells) {
    if (cell.is_first()) first.push_back(cell);
  }
  return first;
}

}  // namespace dob
