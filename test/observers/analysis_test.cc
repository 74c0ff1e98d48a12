#include "observers/analysis.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "observers/factory.h"
#include "observers/filter_family.h"
#include "observers/momentum.h"
#include "test/support/standing_dogbot.h"

namespace dob::analysis_test {
namespace {

constexpr double kTick = 1e-3;

// The same observer without its transfer function, so that everything has to be measured.
class Opaque final : public DisturbanceObserver {
 public:
  explicit Opaque(std::unique_ptr<DisturbanceObserver> inner) : inner_(std::move(inner)) {}
  std::string_view name() const noexcept override { return inner_->name(); }
  void reset(const ModelTerms& now) noexcept override { inner_->reset(now); }
  Estimate update(const ObserverInput& input) noexcept override { return inner_->update(input); }

 private:
  std::unique_ptr<DisturbanceObserver> inner_;
};

class AnalysisTest : public ::testing::Test {
 protected:
  const ModelTerms pose = test::standing_dogbot(test::dogbot_model());

  std::vector<ChannelAnalysis> open(const char* name, const ObserverOptions& options, double dt = kTick) const {
    return analyse([&](double tick) { return make_observer(name, options, tick); }, pose, dt);
  }
  std::vector<ChannelAnalysis> opaque(const char* name, const ObserverOptions& options, double dt = kTick) const {
    const auto make = [&](double tick) { return std::make_unique<Opaque>(make_observer(name, options, tick)); };
    return analyse(make, pose, dt);
  }
};

ObserverOptions family(const char* name, double order, double bandwidth) {
  return {{"family", std::string(name)}, {"order", order}, {"bandwidth_rad_s", bandwidth}};
}

TEST_F(AnalysisTest, OfFirstOrderIsTheClosedForm) {
  for (const auto& all : {open("momentum", {{"gains", 20.0}}), opaque("momentum", {{"gains", 20.0}})}) {
    ASSERT_EQ(all.size(), 1u);
    const ChannelAnalysis& a = all[0];
    EXPECT_EQ(a.channel, Channel::kLegTorque);
    EXPECT_TRUE(a.stable && a.discrete_stable);
    EXPECT_NEAR(*a.static_gain, 1.0, 1e-5);
    EXPECT_NEAR(*a.bandwidth, 20.0, 0.3);  // measured: of forward Euler at K dt = 0.02
    EXPECT_NEAR(*a.delay, 0.05, 6e-4);
    EXPECT_NEAR(*a.overshoot, 0.0, 1e-5);
    EXPECT_NEAR(*a.settling_time, std::log(50.0) / 20.0, 4e-3);
    EXPECT_NEAR(*a.noise_gain, std::sqrt(0.02 / (2.0 - 0.02)), 0.005);  // sqrt(K dt / (2 - K dt))
    EXPECT_NEAR(*a.max_stable_dt, 0.1, 1e-3);
  }
}

TEST_F(AnalysisTest, MeasuresWhatTheTransferFunctionSays) {
  for (const char* name : {"bessel", "butterworth", "binomial"}) {
    for (int order = 1; order <= 5; ++order) {
      const ObserverOptions options = family(name, order, 30.0);
      const ChannelAnalysis closed = open("momentum", options).at(0);
      const ChannelAnalysis measured = opaque("momentum", options).at(0);
      ASSERT_TRUE(closed.linear && !measured.linear);
      EXPECT_NEAR(*closed.bandwidth, 30.0, 1e-9);
      EXPECT_NEAR(*measured.bandwidth / *closed.bandwidth, 1.0, 0.05) << name << order;
      EXPECT_NEAR(*measured.delay, *closed.delay, 1.5 * kTick) << name << order;
      EXPECT_NEAR(*measured.noise_gain / *closed.noise_gain, 1.0, 0.1) << name << order;
      EXPECT_NEAR(*measured.max_stable_dt / *closed.max_stable_dt, 1.0, 0.02) << name << order;
      EXPECT_EQ(*measured.overshoot, *closed.overshoot);
      EXPECT_EQ(*measured.settling_time, *closed.settling_time);
    }
  }
}

// Overshoot of a second-order Butterworth filter: exp(-pi).
TEST_F(AnalysisTest, FindsTheOvershootOfAButterworthFilter) {
  EXPECT_NEAR(*open("momentum", family("butterworth", 2, 6.0), 1e-4).at(0).overshoot, std::exp(-std::numbers::pi),
              1e-4);
}

TEST_F(AnalysisTest, OfThePaperAsPrintedIsUnstableAndWithoutAnyBandwidth) {
  const ObserverOptions printed{{"gains", std::vector<double>{17.5, 6.28, 2.25}}, {"allow_unstable", true}};
  for (const auto& all : {open("momentum", printed), opaque("momentum", printed)}) {
    const ChannelAnalysis& a = all.at(0);
    EXPECT_FALSE(a.stable || a.discrete_stable);
    EXPECT_EQ(a.max_stable_dt, 0.0);
    EXPECT_FALSE(a.bandwidth || a.delay || a.overshoot || a.settling_time || a.noise_gain);
  }
  const ObserverOptions reversed{{"gains", std::vector<double>{2.25, 6.28, 17.5}}};
  EXPECT_NEAR(*open("momentum", reversed).at(0).bandwidth / (2.0 * std::numbers::pi), 0.573, 5e-4);
  EXPECT_NEAR(*open("momentum", reversed).at(0).delay, 1.0 / 2.25, 1e-12);
}

TEST_F(AnalysisTest, OfAStableFilterThatTheTickCannotHoldSaysSo) {
  const ObserverOptions fast{{"gains", 30.0}, {"allow_unstable", true}};
  const ChannelAnalysis a = open("momentum", fast, 0.1).at(0);
  EXPECT_TRUE(a.stable);
  EXPECT_FALSE(a.discrete_stable);
  EXPECT_NEAR(*a.max_stable_dt, 2.0 / 30.0, 1e-12);
}

TEST_F(AnalysisTest, LooksAtEveryChannelWithItsOwnGain) {
  for (const auto& all : {open("com_wrench", {}), opaque("com_wrench", {})}) {
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].channel, Channel::kComForce);
    EXPECT_NEAR(*all[0].bandwidth, 25.0, 0.4);
    EXPECT_EQ(all[1].channel, Channel::kComMoment);
    EXPECT_NEAR(*all[1].bandwidth, 10.0, 0.1);
  }
  EXPECT_EQ(open("momentum_com", {}).size(), 3u);
  EXPECT_TRUE(open("none", {}).empty());
}

// A momentum observer whose estimate is altered tick by tick.
class Altered final : public DisturbanceObserver {
 public:
  using Alter = double (*)(double estimate, long tick);
  explicit Altered(Alter alter) : alter_(alter), inner_(make_observer("momentum", {{"gains", 20.0}}, kTick)) {}
  std::string_view name() const noexcept override { return "altered"; }
  void reset(const ModelTerms& now) noexcept override { inner_->reset(now); }
  Estimate update(const ObserverInput& input) noexcept override {
    Estimate estimate = inner_->update(input);
    ++tick_;
    for (double& torque : estimate.leg_torque) torque = alter_(torque, tick_);
    return estimate;
  }

 private:
  Alter alter_;
  std::unique_ptr<DisturbanceObserver> inner_;
  long tick_ = 0;
};

TEST_F(AnalysisTest, OfAnObserverThatNeverAnswersHasNoFiguresButItsGainOfZero) {
  const auto make = [](double) { return std::make_unique<Altered>([](double, long) { return 0.0; }); };
  const ChannelAnalysis a = analyse(make, pose, kTick).at(0);
  EXPECT_EQ(a.static_gain, 0.0);
  EXPECT_FALSE(a.bandwidth || a.delay || a.overshoot || a.settling_time || a.noise_gain);
}

TEST_F(AnalysisTest, OfAnObserverThatChattersByAPercentIsThatOfItsMean) {
  const auto chatter = [](double y, long k) { return y + (k % 2 == 0 ? 0.05 : -0.05); };  // of 5 N m
  const ChannelAnalysis a = analyse([&](double) { return std::make_unique<Altered>(chatter); }, pose, kTick).at(0);
  EXPECT_TRUE(a.stable);
  EXPECT_NEAR(*a.static_gain, 1.0, 1e-3);
  EXPECT_NEAR(*a.bandwidth, 20.0, 0.4);
  EXPECT_NEAR(*a.delay, 0.05, 2e-3);
}

TEST_F(AnalysisTest, OfAnObserverWithAStaticGainOtherThanOneIsRelativeToIt) {
  const auto make = [](double) { return std::make_unique<Altered>([](double y, long) { return 0.8 * y; }); };
  const ChannelAnalysis a = analyse(make, pose, kTick).at(0);
  EXPECT_NEAR(*a.static_gain, 0.8, 1e-5);
  EXPECT_NEAR(*a.bandwidth, 20.0, 0.4);
  EXPECT_NEAR(*a.delay, 0.05, 1e-3);
  EXPECT_NEAR(*a.overshoot, 0.0, 1e-5);
}

TEST_F(AnalysisTest, OfAnObserverThatRefusesItsInputIsUnstable) {
  const auto make = [](double) { return std::make_unique<Altered>([](double y, long k) { return k > 20 ? NAN : y; }); };
  const ChannelAnalysis a = analyse(make, pose, kTick).at(0);
  EXPECT_FALSE(a.stable || a.discrete_stable || a.bandwidth);
}

TEST_F(AnalysisTest, WorksForEveryObserver) {
  for (const ObserverInfo& info : built_in_observers()) {
    if (info.oracle) continue;  // nothing to analyse: the trial tells it the truth
    for (const ChannelAnalysis& a : analyse([&](double dt) { return info.make({}, dt); }, pose, kTick)) {
      EXPECT_TRUE(a.stable && a.discrete_stable) << info.name;
      EXPECT_GT(a.bandwidth.value_or(0.0), 0.0) << info.name;
      EXPECT_GT(a.amplitude, 0.0) << info.name;
    }
  }
}

}  // namespace
}  // namespace dob::analysis_test
