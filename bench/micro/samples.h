// Per-iteration timings for Google Benchmark: median, p99 and max beside its mean, and heap allocations.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "test/support/allocation_counter.h"

namespace dob::micro {

inline constexpr int kBatch = 16;  // calls per timing sample: a clock reading costs as much as a fast call
inline constexpr std::size_t kMaxSamples = 1U << 20U;

// Entry at quantile q of sorted samples.
inline double quantile(const std::vector<double>& sorted, double q) {
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
}

// Runs `call(i)` for the state's iterations and sets the counters p50_us, p99_us, max_us (of means over kBatch calls,
// or of single calls where batch = 1) and allocs_per_iter. `call` gets a running number for choosing its input.
template <typename Call>
void measure(benchmark::State& state, Call&& call, int batch = kBatch) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> samples;
  samples.reserve(kMaxSamples);
  for (long i = 0; i < 64; ++i) call(i);  // warm up
  const test::AllocationCounter allocations;
  long allocated = 0;
  long n = 0;
  while (state.KeepRunningBatch(batch)) {
    const long before = allocations.count();
    const auto start = Clock::now();
    for (int k = 0; k < batch; ++k) call(n++);
    const auto stop = Clock::now();
    allocated += allocations.count() - before;
    const double seconds = std::chrono::duration<double>(stop - start).count() / batch;
    if (samples.size() < kMaxSamples) samples.push_back(1e6 * seconds);
  }
  std::sort(samples.begin(), samples.end());
  state.counters["p50_us"] = quantile(samples, 0.5);
  state.counters["p99_us"] = quantile(samples, 0.99);
  state.counters["max_us"] = quantile(samples, 1.0);
  state.counters["allocs_per_iter"] = n == 0 ? 0.0 : static_cast<double>(allocated) / static_cast<double>(n);
}

// The same for a set of instances whose running time depends on the instance: `call(i)`, timed one by one, with i = 0
// ... count - 1 again and again, in order. `prepare(i)` before it is not timed: there the instance is brought into the
// cache, where a tick finds the model terms that it has just computed. (It is in Google Benchmark's own Time column.)
// p50_us and p99_us are over all calls. max_us is over the instances, each with the shortest of its kRepeats or more
// calls: the slowest instance, not the slowest interruption by the machine. Runs every instance kRepeats times, however
// few iterations the state asks for.
inline constexpr long kRepeats = 20;

template <typename Prepare, typename Call>
void measure_instances(benchmark::State& state, std::size_t count, Prepare&& prepare, Call&& call) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> samples;
  samples.reserve(kMaxSamples);
  std::vector<double> shortest(count, std::numeric_limits<double>::infinity());
  const test::AllocationCounter allocations;
  long allocated = 0;
  long n = 0;
  const auto once = [&] {
    const std::size_t i = static_cast<std::size_t>(n++) % count;
    prepare(i);
    const long before = allocations.count();
    const auto start = Clock::now();
    call(i);
    const auto stop = Clock::now();
    allocated += allocations.count() - before;
    const double seconds = std::chrono::duration<double>(stop - start).count();
    if (samples.size() < kMaxSamples) samples.push_back(1e6 * seconds);
    shortest[i] = std::min(shortest[i], 1e6 * seconds);
  };
  for (std::size_t i = 0; i < count; ++i) once();  // warm up
  for (auto _ : state) once();
  for (long missing = (kRepeats + 1) * static_cast<long>(count) - n; missing > 0; --missing) once();
  std::sort(samples.begin(), samples.end());
  state.counters["p50_us"] = quantile(samples, 0.5);
  state.counters["p99_us"] = quantile(samples, 0.99);
  state.counters["max_us"] = *std::max_element(shortest.begin(), shortest.end());
  state.counters["allocs_per_iter"] = static_cast<double>(allocated) / static_cast<double>(n);
}

// Explicit registration, called by main().
void add_model_benchmarks();
void add_observer_benchmarks();
void add_planner_benchmarks();
void add_qp_benchmarks();
void add_trial_benchmarks();

}  // namespace dob::micro
