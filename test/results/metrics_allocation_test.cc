// The tick of the metrics stays off the heap.
#include <gtest/gtest.h>

#include "results/metrics.h"
#include "test/results/quiet_tick.h"
#include "test/support/allocation_counter.h"

namespace dob::metrics_allocation_test {
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
  const test::AllocationCounter allocations;
  for (int tick = 0; tick < 2000; ++tick) metrics.add(tick_of_a_swing(tick));
  EXPECT_EQ(allocations.count(), 0);
}

TEST(MetricsAllocationTest, CounterSeesAnAllocation) {
  MetricsAccumulator metrics({}, 0.001, 0.0);
  const test::AllocationCounter allocations;
  for (int tick = 0; tick < 100; ++tick) metrics.add(tick_of_a_swing(tick));
  EXPECT_GT(allocations.count(), 0);
}

}  // namespace
}  // namespace dob::metrics_allocation_test
