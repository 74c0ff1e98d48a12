#include <gtest/gtest.h>

#include "observers/factory.h"
#include "test/observers/ideal_plant.h"
#include "test/support/allocation_counter.h"

namespace dob::allocation_test {
namespace {

TEST(EveryObserver, AllocatesNothingInUpdateAndReset) {
  for (const ObserverInfo& info : built_in_observers()) {
    const auto observer = make_observer(info.name, {}, 1e-3);
    test::IdealPlant plant;
    plant.disturbance.setConstant(1.0);
    plant.com_disturbance.setConstant(1.0);
    const test::AllocationCounter counter;
    observer->reset(plant.terms());
    for (int k = 0; k < 10; ++k) observer->update(plant.advance(1e-3));
    EXPECT_EQ(counter.count(), 0) << info.name;
  }
}

}  // namespace
}  // namespace dob::allocation_test
