// Per-iteration timings for Google Benchmark: p99 and max beside its mean, and heap allocations.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "test/support/allocation_counter.h"

namespace dob::micro {

inline constexpr int kBatch = 16;  // calls per timing sample: a clock reading costs as much as a fast call
inline constexpr std::size_t kMaxSamples = 1U << 20U;

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
  const auto at = [&](double q) {
    return samples.empty() ? 0.0 : samples[static_cast<std::size_t>(q * static_cast<double>(samples.size() - 1))];
  };
  state.counters["p50_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["max_us"] = at(1.0);
  state.counters["allocs_per_iter"] = n == 0 ? 0.0 : static_cast<double>(allocated) / static_cast<double>(n);
}

// Explicit registration, called by main().
void add_model_benchmarks();
void add_observer_benchmarks();
void add_planner_benchmarks();
void add_qp_benchmarks();
void add_trial_benchmarks();

}  // namespace dob::micro
