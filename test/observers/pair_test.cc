#include "observers/pair.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/com_wrench.h"
#include "observers/factory.h"
#include "observers/momentum.h"
#include "test/observers/ideal_plant.h"

namespace dob::pair_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using test::IdealPlant;

constexpr double kTick = 1e-3;

IdealPlant pushed_plant() {
  IdealPlant plant;
  plant.disturbance.setLinSpaced(-3.0, 3.0);
  plant.com_disturbance.setLinSpaced(2.0, 12.0);
  for (int l = 0; l < kLegs; ++l) plant.contact[l] = Vec3(0.3, 0.2 * l, -0.4);
  plant.foot_force.setConstant(5.0);
  return plant;
}

TEST(MomentumCom, GivesBitForBitWhatItsTwoPartsGiveAlone) {
  const auto pair = make_observer("momentum_com", {{"legs.gain_scale", 10.0}, {"com.linear_gain_rad_s", 50.0}}, kTick);
  MomentumObserver legs({.gain_scale = 10.0}, kTick);
  ComWrenchObserver com({.linear_gain = 50.0}, kTick);
  for (int run = 0; run < 2; ++run) {
    IdealPlant plant = pushed_plant();
    pair->reset(plant.terms());
    legs.reset(plant.terms());
    com.reset(plant.terms());
    for (int k = 0; k < 200; ++k) {
      const ObserverInput input = plant.advance(kTick);
      const Estimate both = pair->update(input);
      EXPECT_EQ(both.status, EstimateStatus::kOk);
      EXPECT_TRUE(both.has_legs && both.has_com);
      ASSERT_EQ(both.leg_torque, legs.update(input).leg_torque);
      ASSERT_EQ(both.com_wrench, com.update(input).com_wrench);
    }
  }
}

TEST(PairObserver, LeavesOutWhatItsPartsSayBesideTheirPart) {
  PairObserver swapped("swapped", make_observer("com_wrench", {}, kTick), make_observer("momentum", {}, kTick));
  EXPECT_EQ(swapped.name(), "swapped");
  IdealPlant plant = pushed_plant();
  const Estimate nothing = swapped.update(plant.advance(kTick));
  EXPECT_FALSE(nothing.has_legs);
  EXPECT_FALSE(nothing.has_com);
  EXPECT_TRUE(nothing.leg_torque.isZero(0.0));
  EXPECT_TRUE(nothing.com_wrench.isZero(0.0));
}

TEST(PairObserver, SaysInvalidInputIfEitherPartDoes) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto pair = make_observer("momentum_com", {}, kTick);
  IdealPlant plant = pushed_plant();
  for (int k = 0; k < 50; ++k) pair->update(plant.advance(kTick));
  const Estimate before = pair->update(plant.advance(kTick));

  ObserverInput torque = plant.advance(kTick);  // only the legs look at it
  torque.joint_torque[3] = kNan;
  const Estimate legs_refuse = pair->update(torque);
  EXPECT_EQ(legs_refuse.status, EstimateStatus::kInvalidInput);
  EXPECT_EQ(legs_refuse.leg_torque, before.leg_torque);
  EXPECT_TRUE(legs_refuse.com_wrench.allFinite());

  const ObserverInput good = plant.advance(kTick);  // the angular momentum is the CoM's alone
  ModelTerms now = good.now;
  now.L[0] = kNan;
  const Estimate com_refuses =
      pair->update({good.start, now, good.joint_torque, good.foot_force, good.stance, good.dt});
  EXPECT_EQ(com_refuses.status, EstimateStatus::kInvalidInput);
  EXPECT_EQ(com_refuses.com_wrench, legs_refuse.com_wrench);
  EXPECT_TRUE(com_refuses.leg_torque.allFinite());

  const Estimate after = pair->update(plant.advance(kTick));
  EXPECT_EQ(after.status, EstimateStatus::kOk);
  EXPECT_TRUE(after.leg_torque.allFinite() && after.com_wrench.allFinite());
}

TEST(PairObserver, IsMadeFromTheNamesOfItsParts) {
  const auto pair = make_observer("legs=momentum,com=com_wrench", {{"com.linear_gain_rad_s", 50.0}}, kTick);
  const auto named = make_observer("momentum_com", {{"com.linear_gain_rad_s", 50.0}}, kTick);
  EXPECT_EQ(pair->name(), "legs=momentum,com=com_wrench");
  IdealPlant plant = pushed_plant();
  for (int k = 0; k < 200; ++k) {
    const ObserverInput input = plant.advance(kTick);
    const Estimate one = pair->update(input);
    const Estimate other = named->update(input);
    ASSERT_EQ(one.leg_torque, other.leg_torque);
    ASSERT_EQ(one.com_wrench, other.com_wrench);
  }
}

TEST(PairObserver, RefusesPartsThatDoNotEstimateTheirPart) {
  const auto make = [](const char* name) { return [=] { make_observer(name, {}, kTick); }; };
  EXPECT_THAT(make("legs=com_eso,com=com_eso"), ThrowsMessage<OptionError>(HasSubstr("com_eso cannot be legs")));
  EXPECT_THAT(make("legs=eso,com=eso"),
              ThrowsMessage<OptionError>(HasSubstr("eso cannot be com; there are: com_wrench, momentum_com, ")));
  EXPECT_THAT(make("legs=oracle_legs,com=com_eso"), ThrowsMessage<OptionError>(HasSubstr("oracle_legs cannot be")));
  EXPECT_THAT(make("legs=magic,com=com_eso"), ThrowsMessage<OptionError>(HasSubstr("no observer \"magic\"")));
}

TEST(PairName, HasExactlyTwoPartsInOrder) {
  const auto pair = parse_pair_name("legs=a,com=b");
  ASSERT_TRUE(pair.has_value());
  EXPECT_EQ(pair->legs, "a");
  EXPECT_EQ(pair->com, "b");
  for (const char* none : {"", "legs=a", "com=b,legs=a", "legs=a,com=b,x=1", "legs=a,b", "momentum", "legs=a;com=b"}) {
    EXPECT_FALSE(parse_pair_name(none).has_value()) << none;
  }
}

TEST(PairObserver, RefusesOptionsWithTheNameOfThePart) {
  const auto make = [](const char* key, const OptionValue& value) {
    return [=] { make_observer("momentum_com", {{key, value}}, kTick); };
  };
  EXPECT_THAT(make("gain_scale", 2.0),
              ThrowsMessage<OptionError>("observer momentum_com: option gain_scale = 2 is refused: no such option; "
                                         "there are: legs.KEY and com.KEY, of the two observers"));
  EXPECT_THAT(make("legs.gain_scale", 88.0),
              ThrowsMessage<OptionError>(AllOf(HasSubstr("observer momentum_com, part legs: observer momentum: "),
                                               HasSubstr("gain_scale = 88"), HasSubstr("unstable at the tick"))));
  EXPECT_THAT(make("com.linear_gain_rad_s", 2500.0),
              ThrowsMessage<OptionError>(AllOf(HasSubstr("observer momentum_com, part com: observer com_wrench: "),
                                               HasSubstr("linear_gain_rad_s = 2500"))));
  EXPECT_THAT(make("com.gain_scale", 2.0), ThrowsMessage<OptionError>(HasSubstr("no such option")));
}

}  // namespace
}  // namespace dob::pair_test
