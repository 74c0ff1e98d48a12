// The tick of the metrics stays off the heap. This program counts every allocation it makes.
#include <cstdlib>
#include <memory>
#include <new>

#include <gtest/gtest.h>

#include "results/metrics.h"
#include "test/results/quiet_tick.h"

namespace {

thread_local long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace dob {
namespace {

TickRecord tick_of_a_swing(int tick) {
  TickRecord r = test::quiet();
  r.stance.fill(tick % 100 < 60);
  r.lift_off.fill(tick % 100 == 60);
  r.touchdown.fill(tick % 100 == 0);
  r.disturbance_onset = tick % 300 == 70;
  r.has_force_estimate = r.has_leg_estimate = r.qp_solved = true;
  return r;
}

TEST(MetricsAllocationTest, TicksOfTheAnnouncedDurationAllocateNothing) {
  MetricsAccumulator metrics({}, 0.001, 2.0);
  const long before = allocations;
  for (int tick = 0; tick < 2000; ++tick) metrics.add(tick_of_a_swing(tick));
  EXPECT_EQ(allocations, before);
}

TEST(MetricsAllocationTest, CounterSeesAnAllocation) {
  const long before = allocations;
  MetricsAccumulator metrics({}, 0.001, 0.0);
  for (int tick = 0; tick < 100; ++tick) metrics.add(tick_of_a_swing(tick));
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace dob
