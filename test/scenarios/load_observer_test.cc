#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/com_wrench.h"
#include "observers/factory.h"
#include "observers/momentum.h"
#include "scenarios/document.h"
#include "scenarios/loader.h"
#include "test/observers/ideal_plant.h"
#include "test/scenarios/scratch_files.h"

namespace dob::load_observer_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kPi = 3.14159265358979323846;

std::string error_of(const std::string& specification, const std::string& profile = "paper", double dt = 1e-3) {
  try {
    load_observer(specification, profile, dt);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

MomentumGains gains_of(const ObserverConfig& config) {
  const MomentumOptions options = read_momentum_options(config.options);
  return scale(options.gains, options.gain_scale);
}

TEST(Profiles, AreThePaperTheMatchedAndTheTunedOne) {
  EXPECT_THAT(list_profiles(), ElementsAre("matched", "paper", "tuned"));
}

// That is why an oracle is one row and not one for each profile.
TEST(Profiles, RouteAnOracleTheSameWay) {
  for (const char* oracle : {"oracle_legs", "oracle_full"}) {
    const ObserverConfig one = load_observer(oracle, "matched");
    EXPECT_EQ(one.profile, "-");
    for (const std::string& profile : list_profiles()) {
      EXPECT_EQ(profile_toml({load_observer(oracle, profile)}), profile_toml({one})) << profile;
    }
  }
}

// A path holds dots and slashes, a pair's name '=' and ','.
TEST(ObserverToml, CanBeReadBackWhateverTheObserverIsCalled) {
  const ScratchFiles files;
  ObserverConfig plugin{"/some.where/v1.2/mine.so", "-", {{"gain", 3.0}}, {}};
  const ObserverConfig pair = load_observer("legs=momentum,com=com_wrench,legs.gain_scale=5", "matched");
  const Node document = parse_file(files.write("observer.toml", observer_toml(plugin, {pair})));
  EXPECT_EQ(std::get<std::string>(document.find("observer")->value), plugin.observer);
  EXPECT_EQ(std::get<double>(document.find("options")->find("gain")->value), 3.0);
  EXPECT_EQ(std::get<bool>(document.find("routing")->find("torque_36")->value), plugin.routing.torque_36);
  const auto& shadows = std::get<Array>(document.find("shadow")->value);
  ASSERT_EQ(shadows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(shadows[0].find("observer")->value), "legs=momentum,com=com_wrench");
  EXPECT_EQ(std::get<double>(shadows[0].find("options")->find("legs")->find("gain_scale")->value), 5.0);
}

TEST(Profiles, LoadForEveryObserver) {
  for (const ObserverInfo& info : built_in_observers()) {
    for (const std::string& profile : list_profiles()) {
      EXPECT_EQ(error_of(std::string(info.name), profile), "no error") << info.name << " " << profile;
    }
  }
}

TEST(Profiles, OfThePaperHasItsGainsInTheStableOrderAndItsRouting) {
  const ObserverConfig config = load_observer("momentum", "paper");
  EXPECT_EQ(config.observer, "momentum");
  EXPECT_EQ(config.profile, "paper");
  EXPECT_THAT(gains_of(config).K, ElementsAre(2.25, 6.28, 17.5));
  EXPECT_NEAR(bandwidth(gains_of(config)) / (2.0 * kPi), 0.573, 0.0005);  // the figure its comment states
  EXPECT_TRUE(config.routing.wrench_17);
  EXPECT_FALSE(config.routing.dynamics_18);
  EXPECT_TRUE(config.routing.torque_36);
  EXPECT_EQ(config.routing.swing_31, Routing::Swing::kProjected);
  EXPECT_EQ(config.routing.wrench_source, Routing::WrenchSource::kStanceLegs);
}

TEST(Profiles, MatchedHasTwentyTimesTheBandwidth) {
  const ObserverConfig config = load_observer("momentum", "matched");
  EXPECT_EQ(config.profile, "matched");
  EXPECT_NEAR(bandwidth(gains_of(config)) / (2.0 * kPi), 11.5, 0.05);
  EXPECT_TRUE(config.routing.torque_36);
}

TEST(Profiles, OfThePaperHasTheGainsOfTheComWrenchBaselineAndItsRouting) {
  const ObserverConfig config = load_observer("com_wrench", "paper");
  const ComWrenchOptions options = read_com_wrench_options(config.options);
  EXPECT_EQ(options.linear_gain, 25.0);
  EXPECT_EQ(options.angular_gain, 10.0);
  EXPECT_TRUE(config.routing.wrench_17);
  EXPECT_FALSE(config.routing.dynamics_18);
  EXPECT_EQ(config.routing.swing_31, Routing::Swing::kOff);
}

// Size of the estimate's wave, over that of the disturbance: a sine of the given frequency, long after its start.
Estimate gain_at(const ObserverConfig& config, double omega, const Estimate& amplitude) {
  constexpr double kDt = 1e-3;
  const auto observer = make_observer(config.observer, config.options, kDt);
  test::IdealPlant plant;
  plant.lever.setIdentity();
  plant.stance = {};
  observer->reset(plant.terms());
  Estimate cosine;
  Estimate sine;
  const int period = static_cast<int>(std::lround(2.0 * kPi / (omega * kDt)));
  for (int k = 0; k < 60 * period; ++k) {
    const double mean = (std::cos(omega * k * kDt) - std::cos(omega * (k + 1) * kDt)) / (omega * kDt);
    plant.disturbance = mean * amplitude.leg_torque;
    plant.com_disturbance = mean * amplitude.com_wrench;
    const Estimate estimate = observer->update(plant.advance(kDt));
    if (k < 20 * period) continue;
    const double t = omega * (k + 1) * kDt;
    const double share = 2.0 / (40.0 * period);
    cosine.leg_torque += share * std::cos(t) * estimate.leg_torque;
    sine.leg_torque += share * std::sin(t) * estimate.leg_torque;
    cosine.com_wrench += share * std::cos(t) * estimate.com_wrench;
    sine.com_wrench += share * std::sin(t) * estimate.com_wrench;
  }
  Estimate gain;
  gain.leg_torque = (cosine.leg_torque.cwiseAbs2() + sine.leg_torque.cwiseAbs2()).cwiseSqrt();
  gain.leg_torque = gain.leg_torque.cwiseQuotient(amplitude.leg_torque);
  gain.com_wrench = (cosine.com_wrench.cwiseAbs2() + sine.com_wrench.cwiseAbs2()).cwiseSqrt();
  gain.com_wrench = gain.com_wrench.cwiseQuotient(amplitude.com_wrench);
  return gain;
}

// Measured on the ideal plant at the amplitudes of the profile, which only the observers that are not linear depend on.
TEST(Profiles, GiveEveryEstimateTheBandwidthTheyState) {
  Estimate amplitude;
  amplitude.leg_torque.setConstant(5.0);
  amplitude.com_wrench << 20.0, 20.0, 20.0, 5.0, 5.0, 5.0;
  const double down = std::sqrt(0.5);
  for (const ObserverInfo& info : built_in_observers()) {
    if (info.oracle || !(info.estimates_legs || info.estimates_com)) continue;
    const std::string name(info.name);
    const Estimate matched = gain_at(load_observer(name, "matched"), 2.0 * kPi * 11.5, amplitude);
    const auto is_down = [&](const auto& gain) { return (gain.array() - down).abs().maxCoeff() < 0.015; };
    if (name == "momentum" || name == "momentum_com") {
      // Matched as the continuous filter (MatchedHasTwentyTimesTheBandwidth); with K_3 dt = 0.35 the update itself is
      // 0.43 dB further down there.
      EXPECT_NEAR(matched.leg_torque.mean(), 0.673, 0.001) << name;
      continue;
    }
    EXPECT_EQ(is_down(matched.leg_torque), info.estimates_legs) << name << ' ' << matched.leg_torque.transpose();
    EXPECT_EQ(is_down(matched.com_wrench), info.estimates_com) << name << ' ' << matched.com_wrench.transpose();

    // What has no figure of its own in its source is as fast as the paper's first-order baseline.
    if (name == "com_wrench" || name == "nonlinear_dob") continue;
    const Estimate force = gain_at(load_observer(name, "paper"), 25.0, amplitude);
    const Estimate moment =
        gain_at(load_observer(name, "paper"), name == "contact_consistent" ? 25.0 : 10.0, amplitude);
    EXPECT_EQ(is_down(force.leg_torque), info.estimates_legs) << name << ' ' << force.leg_torque.transpose();
    EXPECT_EQ(is_down(force.com_wrench.head<3>()), info.estimates_com) << name;
    EXPECT_EQ(is_down(moment.com_wrench.tail<3>()), info.estimates_com) << name;
  }
}

// A first-order observer's gain is its -3 dB bandwidth.
TEST(Profiles, MatchedHasOneBandwidthForEveryEstimate) {
  const double width = bandwidth(gains_of(load_observer("momentum", "matched")));
  const ComWrenchOptions com = read_com_wrench_options(load_observer("com_wrench", "matched").options);
  EXPECT_NEAR(com.linear_gain / width, 1.0, 0.005);
  EXPECT_EQ(com.angular_gain, com.linear_gain);
  const ObserverConfig pair = load_observer("momentum_com", "matched");
  EXPECT_EQ(std::get<double>(pair.options.at("com.linear_gain_rad_s")), com.linear_gain);
  EXPECT_EQ(std::get<double>(pair.options.at("com.angular_gain_rad_s")), com.linear_gain);
  EXPECT_EQ(std::get<double>(pair.options.at("legs.gain_scale")), 20.0);
}

TEST(Profiles, UseTheComEstimateOfThePairInBothWrenchAndDynamics) {
  for (const std::string& profile : list_profiles()) {
    const Routing routing = load_observer("momentum_com", profile).routing;
    EXPECT_TRUE(routing.wrench_17 && routing.dynamics_18 && routing.torque_36) << profile;
    EXPECT_NE(routing.swing_31, Routing::Swing::kOff) << profile;
  }
}

TEST(Profiles, SayNothingAboutNoObserver) {
  const ObserverConfig config = load_observer("none", "paper");
  EXPECT_EQ(config.profile, "-");
  EXPECT_TRUE(config.options.empty());
}

TEST(LoadObserver, LaysTheSpecificationOverTheProfile) {
  const ObserverConfig config = load_observer(
      "momentum:gains=1.0;2.5,coriolis=neglected,routing.torque_36=false,routing.swing_31=direct,"
      "routing.wrench_source=all_legs",
      "matched");
  const MomentumOptions options = read_momentum_options(config.options);
  EXPECT_THAT(options.gains.K, ElementsAre(1.0, 2.5));
  EXPECT_EQ(options.gain_scale, 20.0);  // still the profile's
  EXPECT_EQ(options.coriolis, Coriolis::kNeglected);
  EXPECT_FALSE(config.routing.torque_36);
  EXPECT_TRUE(config.routing.wrench_17);
  EXPECT_EQ(config.routing.swing_31, Routing::Swing::kDirect);
  EXPECT_EQ(config.routing.wrench_source, Routing::WrenchSource::kAllLegs);
}

TEST(LoadObserver, GainsGivenInAnotherWayReplaceThoseOfTheProfile) {
  const std::string family = "family=bessel,order=2,bandwidth_rad_s=30";
  EXPECT_NEAR(bandwidth(gains_of(load_observer("momentum:" + family, "matched"))), 30.0, 1e-9);  // not 20 times that
  const ObserverConfig pair =
      load_observer("momentum_com:legs.family=binomial,legs.order=1,legs.bandwidth_rad_s=7", "matched");
  EXPECT_EQ(pair.options.count("legs.gains"), 0u);
  EXPECT_EQ(pair.options.count("com.linear_gain_rad_s"), 1u);
  EXPECT_THAT(gains_of(load_observer("momentum:coefficients=6;5", "paper")).K, ElementsAre(6.0 / 5.0, 5.0));
  EXPECT_THAT(error_of("momentum:gains=1;2," + family), HasSubstr("gains is given as well"));
}

TEST(LoadObserver, LaysOptionsOfThePartsOfAPairOverTheProfile) {
  const ObserverConfig config =
      load_observer("momentum_com:legs.gain_scale=10,com.linear_gain_rad_s=50,routing.torque_36=false", "matched");
  EXPECT_EQ(std::get<double>(config.options.at("legs.gain_scale")), 10.0);
  EXPECT_EQ(std::get<std::vector<double>>(config.options.at("legs.gains")).size(), 3u);  // still the profile's
  EXPECT_EQ(std::get<double>(config.options.at("com.linear_gain_rad_s")), 50.0);
  EXPECT_EQ(std::get<double>(config.options.at("com.angular_gain_rad_s")), 72.26);
  EXPECT_EQ(config.options.size(), 4u);
  EXPECT_FALSE(config.routing.torque_36);
}

TEST(LoadObserver, MakesAPairOfAnyLegsAndAnyComEstimatorFromTheProfileOfTheParts) {
  for (const std::string& profile : list_profiles()) {
    for (const ObserverInfo& legs : built_in_observers()) {
      for (const ObserverInfo& com : built_in_observers()) {
        if (!legs.estimates_legs || !com.estimates_com || legs.oracle || com.oracle) continue;
        const std::string name = "legs=" + std::string(legs.name) + ",com=" + std::string(com.name);
        const ObserverConfig config = load_observer(name, profile);
        EXPECT_EQ(config.observer, name);
        EXPECT_EQ(config.profile, profile);
        EXPECT_TRUE(config.routing.wrench_17 && config.routing.dynamics_18 && config.routing.torque_36) << name;
        const auto of_legs = load_observer(legs.name, profile).options;
        const auto of_com = load_observer(com.name, profile).options;
        EXPECT_EQ(config.options.size(), of_legs.size() + of_com.size());
        for (const auto& [key, value] : of_legs) EXPECT_EQ(config.options.at("legs." + key), value) << name;
        for (const auto& [key, value] : of_com) EXPECT_EQ(config.options.at("com." + key), value) << name;
      }
    }
  }
}

TEST(LoadObserver, KnowsMomentumComByTheNamesOfItsParts) {
  const ObserverConfig named = load_observer("momentum_com", "matched");
  const ObserverConfig pair = load_observer("legs=momentum,com=com_wrench", "matched");
  EXPECT_EQ(pair.options, named.options);
  EXPECT_EQ(pair.routing.swing_31, named.routing.swing_31);
}

TEST(LoadObserver, LaysOptionsOverAPair) {
  const ObserverConfig config = load_observer(
      "legs=kalman,com=com_wrench,legs.walk=0.5,com.linear_gain_rad_s=9,routing.swing_31=direct", "matched");
  EXPECT_EQ(config.observer, "legs=kalman,com=com_wrench");
  EXPECT_EQ(std::get<double>(config.options.at("legs.walk")), 0.5);
  EXPECT_EQ(std::get<double>(config.options.at("legs.noise")), 1e-3);  // still the profile's
  EXPECT_EQ(std::get<double>(config.options.at("com.linear_gain_rad_s")), 9.0);
  EXPECT_EQ(config.routing.swing_31, Routing::Swing::kDirect);
}

TEST(LoadObserver, RefusesPairsThatAreNone) {
  EXPECT_THAT(error_of("legs=kalman,com=eso"),
              AllOf(StartsWith("--observer legs=kalman,com=eso: observer legs=kalman,com=eso: eso cannot be com; there "
                               "are: com_wrench, momentum_com, "),
                    Not(HasSubstr("oracle"))));
  EXPECT_THAT(error_of("legs=com_eso,com=com_eso"), HasSubstr("com_eso cannot be legs; there are: momentum, "));
  EXPECT_THAT(error_of("legs=oracle_legs,com=com_eso"), HasSubstr("oracle_legs cannot be legs"));
  EXPECT_THAT(error_of("legs=none,com=com_eso"), HasSubstr("none cannot be legs"));
  EXPECT_THAT(error_of("legs=magic,com=com_eso"), HasSubstr("there is no observer 'magic'"));
  EXPECT_THAT(error_of("legs=kalman"), HasSubstr("there is no observer 'legs=kalman'"));
  EXPECT_THAT(error_of("legs=kalman,com=com_eso,walk=1"), HasSubstr("there are: legs.KEY and com.KEY"));
  EXPECT_THAT(error_of("legs=kalman,com=com_eso,legs.wlak=1"), AllOf(HasSubstr("part legs"), HasSubstr("wlak = 1")));
}

TEST(LoadObserver, RefusesOptionsOfAPairWithTheNameOfThePart) {
  EXPECT_THAT(error_of("momentum_com:legs.gian=1"), AllOf(HasSubstr("momentum_com, part legs"), HasSubstr("gian = 1")));
  EXPECT_THAT(error_of("momentum_com:gain_scale=1"), HasSubstr("there are: legs.KEY and com.KEY"));
  EXPECT_THAT(error_of("momentum_com:legs=1"), HasSubstr("legs"));
  EXPECT_THAT(error_of("momentum:legs.gain_scale=1"), HasSubstr("no such option"));
}

TEST(LoadObserver, RefusesThePrintedOrderOfTheGainsWithTheReason) {
  EXPECT_THAT(error_of("momentum:gains=17.5;6.28;2.25"), AllOf(StartsWith("--observer momentum:gains=17.5;6.28;2.25: "),
                                                               HasSubstr("gains"), HasSubstr("unstable")));
  EXPECT_EQ(error_of("momentum:gains=17.5;6.28;2.25,allow_unstable=true"), "no error");
}

TEST(LoadObserver, RefusesGainsThatAreUnstableAtTheTick) {
  EXPECT_EQ(error_of("momentum", "matched", 1e-3), "no error");
  EXPECT_THAT(error_of("momentum", "matched", 1e-2), HasSubstr("unstable"));
  EXPECT_THAT(error_of("momentum:gain_scale=200"), HasSubstr("unstable"));
}

TEST(LoadObserver, RefusesWhatItDoesNotKnow) {
  const std::string names = "; there are: none, momentum, com_wrench, momentum_com, ";
  EXPECT_THAT(error_of("magic"), StartsWith("--observer magic: there is no observer 'magic'" + names));
  EXPECT_THAT(error_of(""), StartsWith("--observer : there is no observer ''" + names));
  EXPECT_EQ(error_of("momentum", "mine"), "--profile: there is no 'mine'; there are: matched, paper, tuned");
  EXPECT_THAT(error_of("momentum:gian_scale=2"), AllOf(StartsWith("--observer momentum:gian_scale=2: "),
                                                       HasSubstr("gian_scale"), HasSubstr("no such option")));
  EXPECT_THAT(error_of("momentum:order"), HasSubstr("'order'; allowed: KEY=VALUE"));
  EXPECT_THAT(error_of("momentum:gain_scale=fast"), HasSubstr("allowed is a number"));
  EXPECT_THAT(error_of("none:gains=1"), HasSubstr("no such option"));
}

TEST(LoadObserver, RefusesRoutingThatDoesNotExist) {
  EXPECT_EQ(error_of("momentum:routing.torque_63=true"),
            "--observer momentum:routing.torque_63=true momentum.routing.torque_63: "
            "unknown key 'torque_63'; did you mean 'torque_36'?");
  EXPECT_THAT(error_of("momentum:routing.torque_36=1"),
              HasSubstr("momentum.routing.torque_36: 1; allowed: true or false"));
  EXPECT_THAT(error_of("momentum:routing.swing_31=some"),
              HasSubstr("\"some\"; allowed: one of off, projected, direct"));
  EXPECT_THAT(error_of("momentum:routing.wrench_source=legs"),
              HasSubstr("\"legs\"; allowed: one of com, stance_legs, all_legs"));
  EXPECT_THAT(error_of("none:routing.torque_36=true"),
              HasSubstr("none.routing: this observer estimates nothing that could be routed"));
}

class OwnProfile : public testing::Test {
 protected:
  void SetUp() override { setenv("DOBBENCH_SCENARIOS", files_.directory().c_str(), 1); }
  void TearDown() override { unsetenv("DOBBENCH_SCENARIOS"); }

  std::string error_in(const std::string& text, const std::string& specification = "momentum") {
    files_.write("config/profiles/own.toml", text);
    return error_of(specification, "own");
  }

  ScratchFiles files_;
  const std::string path_ = (files_.directory() / "config/profiles/own.toml").string();
};

TEST_F(OwnProfile, ThatDoesNotMentionAnObserverLeavesItItsDefaults) {
  EXPECT_EQ(error_in(""), "no error");
  const ObserverConfig config = load_observer("momentum:gain_scale=2", "own");
  EXPECT_EQ(config.profile, "-");
  EXPECT_THAT(gains_of(config).K, ElementsAre(4.5, 12.56, 35.0));
  EXPECT_EQ(config.routing.dynamics_18, Routing{}.dynamics_18);
}

TEST_F(OwnProfile, MayHaveTablesForPluginsThatOnlyTheyLookAt) {
  EXPECT_EQ(error_in("[plugin.mine]\ngain_rad_s = 20\n"), "no error");
  EXPECT_EQ(load_observer("momentum", "own").profile, "-");
}

TEST_F(OwnProfile, GivesItsRoutingToAKindOfEstimateAndThenToAnObserver) {
  EXPECT_EQ(error_in("[legs.routing]\ntorque_36 = false\nwrench_17 = false\n[eso.routing]\ntorque_36 = true\n"),
            "no error");
  const ObserverConfig momentum = load_observer("momentum", "own");
  EXPECT_EQ(momentum.profile, "own");
  EXPECT_FALSE(momentum.routing.torque_36 || momentum.routing.wrench_17);
  const Routing eso = load_observer("eso", "own").routing;
  EXPECT_TRUE(eso.torque_36);
  EXPECT_FALSE(eso.wrench_17);
  EXPECT_EQ(load_observer("com_wrench", "own").profile, "-");
  EXPECT_EQ(error_in("[com]\ngain = 1\n"), path_ + ":2:1: com.gain: allowed: routing only");
  EXPECT_THAT(error_in("[pair.routing]\ntorque = 1\n", "legs=eso,com=com_eso"), HasSubstr("unknown key 'torque'"));
}

TEST_F(OwnProfile, IsRefusedAtItsLine) {
  EXPECT_THAT(error_in("\n[momentun]\n"),
              StartsWith(path_ + ":2:2: there is no observer 'momentun'; there are: none, momentum, com_wrench, "));
  EXPECT_EQ(error_in("[none]\n"),
            path_ + ":1:2: none: this observer estimates nothing; a profile has nothing to say about it");
  EXPECT_EQ(error_in("momentum = 1\n"), path_ + ":1:1: momentum: 1; allowed: a table");
  EXPECT_EQ(error_in("[momentum]\ngains = [1, \"x\"]\n"),
            path_ + ":2:1: momentum.gains: [1, \"x\"]; allowed: true, false, a number, a text, a list of numbers");
  EXPECT_EQ(error_in("[momentum.legs]\n"),
            path_ + ":1:11: momentum.legs: a table; allowed: true, false, a number, a text, a list of numbers");
  EXPECT_THAT(error_in("[momentum]\ngain = 1\n"), AllOf(StartsWith(path_ + ":2:1: "), HasSubstr("option gain")));
  EXPECT_EQ(error_in("[momentum.routing]\ntorque_36 = \"yes\"\n"),
            path_ + ":2:1: momentum.routing.torque_36: \"yes\"; allowed: true or false");
  EXPECT_THAT(error_in("[momentum\n"), StartsWith(path_ + ":1:10: "));
}

// Found by fuzzing: the place was that of the profile's key which the value speaks of.
TEST(LoadObserver, AValueThatSpeaksOfAnotherOptionIsRefusedAtItsOwnPlace) {
  try {
    load_observer("momentum:gains=1: option wrench_source = 1", "tuned");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("--observer ")) << error.what();
  }
}

}  // namespace
}  // namespace dob::load_observer_test
