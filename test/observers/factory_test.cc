#include "observers/factory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/observers/ideal_plant.h"

namespace dob::factory_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kTick = 1e-3;

TEST(Factory, MakesEveryBuiltInObserverWithDefaultsUnderItsOwnName) {
  ASSERT_FALSE(built_in_observers().empty());
  for (const ObserverInfo& info : built_in_observers()) {
    const auto observer = make_observer(info.name, {}, kTick);
    EXPECT_EQ(observer->name(), info.name);
    EXPECT_FALSE(info.summary.empty());
    EXPECT_FALSE(info.source.empty());
  }
}

TEST(Factory, SaysTruthfullyWhatIsEstimated) {
  for (const ObserverInfo& info : built_in_observers()) {
    const auto observer = make_observer(info.name, {}, kTick);
    test::IdealPlant plant;
    plant.disturbance.setConstant(1.0);
    plant.com_disturbance.setConstant(1.0);
    plant.lever.setIdentity();
    plant.stance = {};  // without force sensors a standing leg hides what acts on it
    observer->reset(plant.terms());
    const Estimate estimate = observer->update(plant.advance(kTick));
    EXPECT_EQ(estimate.has_legs, info.estimates_legs) << info.name;
    EXPECT_EQ(estimate.has_com, info.estimates_com) << info.name;
    EXPECT_EQ(estimate.leg_torque.isZero(0.0), !info.estimates_legs || info.oracle) << info.name;
    EXPECT_EQ(estimate.com_wrench.isZero(0.0), !info.estimates_com || info.oracle) << info.name;
    EXPECT_EQ(estimate.status, EstimateStatus::kOk);
  }
}

TEST(Factory, ListsWhatExistsWhenTheNameIsUnknown) {
  EXPECT_THAT([] { make_observer("momemtum", {}, kTick); },
              ThrowsMessage<OptionError>(
                  AllOf(HasSubstr("momemtum"), HasSubstr("none, momentum, com_wrench, momentum_com, nonlinear_dob"))));
}

TEST(Factory, EveryObserverRefusesAnUnknownOption) {
  for (const ObserverInfo& info : built_in_observers()) {
    EXPECT_THAT(
        [&] {
          make_observer(info.name, {{"gian", 2.0}}, kTick);
        },
        ThrowsMessage<OptionError>(AllOf(HasSubstr(std::string(info.name)), HasSubstr("gian = 2"))));
  }
}

TEST(Factory, PassesOptionsOn) {
  const auto make = [](double gain_scale) { return make_observer("momentum", {{"gain_scale", gain_scale}}, kTick); };
  EXPECT_NO_THROW(make(87.0));
  EXPECT_THROW(make(88.0), OptionError);
}

}  // namespace
}  // namespace dob::factory_test
