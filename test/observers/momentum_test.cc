// The momentum observer on the ideal plant, where every answer is a closed form.
#include "observers/momentum.h"

#include <complex>
#include <functional>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/observers/ideal_plant.h"

namespace dob::momentum_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Complex = std::complex<double>;
using Poles = std::vector<Complex>;
using test::IdealPlant;

constexpr double kTick = 1e-3;
const MomentumGains kReversed{{2.25, 6.28, 17.5}};

// Distinct poles [rad/s] of a stable filter of order 1 ... 5.
Poles poles_of_order(int order) {
  const Poles all[] = {{-12.0},
                       {{-8.0, 5.0}, {-8.0, -5.0}},
                       {{-8.0, 9.0}, {-8.0, -9.0}, -10.0},
                       {{-9.0, 3.0}, {-9.0, -3.0}, {-7.0, 10.0}, {-7.0, -10.0}},
                       {{-10.0, 6.0}, {-10.0, -6.0}, {-7.0, 13.0}, {-7.0, -13.0}, -11.0}};
  return all[order - 1];
}

MomentumGains gains_of(const Poles& poles) {
  Poles p{1.0};
  for (const Complex pole : poles) {
    p.emplace_back(0.0);
    for (std::size_t j = p.size() - 1; j > 0; --j) p[j] = p[j - 1] - pole * p[j];
    p[0] *= -pole;
  }
  std::vector<double> c;
  for (std::size_t j = 0; j + 1 < p.size(); ++j) c.push_back(p[j].real());
  return gains_from_coefficients(c);
}

// Step response of c_0 / prod (s - p_k) by partial fractions.
double step_response(const Poles& poles, double t) {
  Complex c0 = 1.0;
  for (const Complex p : poles) c0 *= -p;
  Complex y = 1.0;
  for (std::size_t k = 0; k < poles.size(); ++k) {
    Complex residue = c0 / poles[k];
    for (std::size_t j = 0; j < poles.size(); ++j) {
      if (j != k) residue /= poles[k] - poles[j];
    }
    y += residue * std::exp(poles[k] * t);
  }
  return y.real();
}

MomentumObserver observer_with(const MomentumGains& gains, double dt = kTick) {
  return MomentumObserver({.gains = gains, .allow_unstable = true}, dt);
}

// Torques that move the plant's momentum about while the disturbance is constant.
void drive(IdealPlant& plant, int tick) {
  for (int i = 0; i < kJoints; ++i) {
    plant.torque[i] = 30.0 * std::sin(0.02 * tick + i);
    plant.coriolis[i] = 3.0 * std::cos(0.05 * tick - i);
  }
}

double worst_step_error(const Poles& poles, double dt) {
  MomentumObserver observer = observer_with(gains_of(poles), dt);
  IdealPlant plant;
  plant.disturbance.setConstant(1.0);
  double worst = 0.0;
  for (int k = 1; k * dt < 1.5; ++k) {
    drive(plant, k);
    const double y = step_response(poles, k * dt);
    worst = std::max(worst, (observer.update(plant.advance(dt)).leg_torque.array() - y).abs().maxCoeff());
  }
  return worst;
}

TEST(MomentumObserver, StepResponseConvergesToTheClosedFormAtFirstOrder) {
  for (int order = 1; order <= 5; ++order) {
    const Poles poles = poles_of_order(order);
    const double coarse = worst_step_error(poles, 1e-3);
    const double middle = worst_step_error(poles, 0.5e-3);
    const double fine = worst_step_error(poles, 0.25e-3);
    EXPECT_LT(coarse, 0.02) << "order " << order;
    EXPECT_NEAR(coarse / middle, 2.0, 0.05) << "order " << order << ": " << coarse << ' ' << middle;
    EXPECT_NEAR(middle / fine, 2.0, 0.025) << "order " << order << ": " << middle << ' ' << fine;
  }
}

TEST(MomentumObserver, UpdatesInTheOrderThatTheStateMatrixDescribes) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> gain(5.0, 60.0);
  for (int order = 1; order <= kMaxMomentumOrder; ++order) {
    MomentumGains gains;
    for (int i = 0; i < order; ++i) gains.K.push_back(gain(random));
    MomentumObserver observer = observer_with(gains);
    IdealPlant plant;
    plant.disturbance.setConstant(2.0);
    const MomentumMatrix A = state_matrix(gains, kTick);
    MomentumVector gamma = MomentumVector::Zero(order);
    for (int k = 0; k < 200; ++k) {
      gamma = A * gamma + 2.0 * input_vector(gains, kTick);
      const double scale = std::max(1.0, gamma.cwiseAbs().maxCoeff());
      ASSERT_NEAR(observer.update(plant.advance(kTick)).leg_torque[5], gamma[order - 1], 1e-11 * scale) << order;
    }
  }
}

// Size of the estimate long after a kick of one tick.
double after_a_kick(double gain_scale, double dt) {
  MomentumObserver observer = observer_with(scale(kReversed, gain_scale), dt);
  IdealPlant plant;
  plant.disturbance[0] = 1.0;
  observer.update(plant.advance(dt));
  plant.disturbance[0] = 0.0;
  double size = 0.0;
  for (int k = 0; k < 4000; ++k) size = std::abs(observer.update(plant.advance(dt)).leg_torque[0]);
  return size;
}

TEST(MomentumObserver, HoldsAtTheTickExactlyAsFarAsTheSpectralRadiusSays) {
  for (const auto& [dt, prototype] : {std::pair{0.5e-3, 175.0}, {1e-3, 87.0}, {2.5e-3, 35.0}}) {
    const double largest = largest_stable_dt(kReversed) / dt;  // stability depends on K dt only
    EXPECT_NEAR(largest, prototype, 1.0);
    EXPECT_LT(spectral_radius(scale(kReversed, 0.99 * largest), dt), 1.0);
    EXPECT_GT(spectral_radius(scale(kReversed, 1.01 * largest), dt), 1.0);
    EXPECT_LT(after_a_kick(0.99 * largest, dt), 1e-9);
    EXPECT_GT(after_a_kick(1.01 * largest, dt), 1e9);
  }
}

TEST(MomentumObserver, EstimatesEachJointWithItsSignAndNoOther) {
  for (int i = 0; i < kJoints; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      MomentumObserver observer = observer_with(scale(kReversed, 20.0));
      IdealPlant plant;
      plant.disturbance[i] = 4.0 * sign;
      Vec12 estimate;
      for (int k = 0; k < 2000; ++k) estimate = observer.update(plant.advance(kTick)).leg_torque;
      EXPECT_TRUE(estimate.isApprox(plant.disturbance, 1e-9)) << "joint " << i << ": " << estimate.transpose();
    }
  }
}

TEST(MomentumObserver, TakesNothingButTheMomentumFromTheEndOfTheInterval) {
  MomentumObserver observer = observer_with(kReversed);
  MomentumObserver twin = observer_with(kReversed);
  IdealPlant plant;
  plant.disturbance.setConstant(1.0);
  for (int k = 0; k < 20; ++k) {
    drive(plant, k);
    const ObserverInput input = plant.advance(kTick);
    ModelTerms now = input.now;
    now.CqT_qd.setConstant(1e3);
    now.A_c.setConstant(1e3);
    for (LegPoint& point : now.contact) point.J_q.setConstant(1e3);
    const ObserverInput altered{input.start, now, input.joint_torque, input.foot_force, input.stance, input.dt};
    EXPECT_EQ(observer.update(altered).leg_torque, twin.update(input).leg_torque);
  }
}

TEST(MomentumObserver, CountsCoriolisTermsAsDisturbanceOnlyWhenToldToNeglectThem) {
  for (const Coriolis coriolis : {Coriolis::kExact, Coriolis::kNeglected}) {
    MomentumObserver observer({.gains = scale(kReversed, 20.0), .coriolis = coriolis}, kTick);
    IdealPlant plant;
    plant.coriolis.setConstant(0.5);
    Vec12 estimate;
    for (int k = 0; k < 2000; ++k) estimate = observer.update(plant.advance(kTick)).leg_torque;
    EXPECT_NEAR(estimate[3], coriolis == Coriolis::kExact ? 0.0 : 0.5, 1e-9);
  }
}

TEST(MomentumObserver, StartsInMotionWithoutATransient) {
  MomentumObserver observer = observer_with(scale(kReversed, 20.0));
  IdealPlant plant;
  plant.momentum.setLinSpaced(-40.0, 55.0);
  observer.reset(plant.terms());
  for (int k = 0; k < 1000; ++k) {
    drive(plant, k);
    // Rounding only: a momentum of 55 read as a disturbance would give 55 K_1 = 2475 N m.
    ASSERT_LT(observer.update(plant.advance(kTick)).leg_torque.cwiseAbs().maxCoeff(), 1e-9) << "tick " << k;
  }
}

std::vector<Vec12> record(MomentumObserver& observer, int ticks) {
  IdealPlant plant;
  plant.disturbance.setLinSpaced(-3.0, 3.0);
  observer.reset(plant.terms());
  std::vector<Vec12> estimates;
  for (int k = 0; k < ticks; ++k) {
    drive(plant, k);
    estimates.push_back(observer.update(plant.advance(kTick)).leg_torque);
  }
  return estimates;
}

TEST(MomentumObserver, GivesTheSameBitsTwiceAndAfterReset) {
  MomentumObserver first = observer_with(scale(kReversed, 20.0));
  MomentumObserver second = observer_with(scale(kReversed, 20.0));
  const std::vector<Vec12> estimates = record(first, 300);
  EXPECT_EQ(record(second, 300), estimates);
  EXPECT_EQ(record(first, 300), estimates) << "after reset";
}

// A way to make one thing of an input wrong.
struct Spoilt {
  const char* what;
  std::function<void(ModelTerms& start, ModelTerms& now, Vec12& torque, Vec12& force, double& dt)> spoil;
};

std::vector<Spoilt> ways_to_spoil() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {{"torque", [](auto&, auto&, Vec12& tau, auto&, auto&) { tau[7] = kNan; }},
          {"infinite torque", [](auto&, auto&, Vec12& tau, auto&, auto&) { tau[0] = -kInf; }},
          {"foot force", [](auto&, auto&, auto&, Vec12& f, auto&) { f[11] = kNan; }},
          {"momentum now", [](auto&, ModelTerms& now, auto&, auto&, auto&) { now.rho[3] = kNan; }},
          {"momentum before", [](ModelTerms& start, auto&, auto&, auto&, auto&) { start.rho[3] = kInf; }},
          {"contact point", [](ModelTerms& start, auto&, auto&, auto&, auto&) { start.contact[2].p.x() = kNan; }},
          {"Coriolis term", [](ModelTerms& start, auto&, auto&, auto&, auto&) { start.CqT_qd[4] = kNan; }},
          {"nan tick", [](auto&, auto&, auto&, auto&, double& dt) { dt = kNan; }},
          {"zero tick", [](auto&, auto&, auto&, auto&, double& dt) { dt = 0.0; }},
          {"overflow", [](auto&, ModelTerms& now, auto&, auto&, auto&) { now.rho[1] = 1.7e308; }}};
}

TEST(MomentumObserver, IgnoresInvalidInputAndGoesOnAsIfTheIntervalHadNotBeen) {
  for (const auto& [what, spoil] : ways_to_spoil()) {
    MomentumObserver observer = observer_with(scale(kReversed, 20.0));
    MomentumObserver twin = observer_with(scale(kReversed, 20.0));
    IdealPlant plant;
    plant.disturbance.setLinSpaced(-3.0, 3.0);
    Vec12 last = Vec12::Zero();
    for (int k = 0; k < 400; ++k) {
      drive(plant, k);
      const ObserverInput good = plant.advance(kTick);
      if (k < 200 || k >= 300) {  // 100 lost ticks, in which the torques change the momentum by 3 kg m^2/s and more
        const Estimate estimate = observer.update(good);
        EXPECT_EQ(estimate.status, EstimateStatus::kOk) << what;
        last = twin.update(good).leg_torque;
        ASSERT_EQ(estimate.leg_torque, last) << what << " at tick " << k;
        continue;
      }
      ModelTerms start = good.start;
      ModelTerms now = good.now;
      ObserverInput bad{start, now, good.joint_torque, good.foot_force, good.stance, good.dt};
      spoil(start, now, bad.joint_torque, bad.foot_force, bad.dt);
      const Estimate estimate = observer.update(bad);
      EXPECT_EQ(estimate.status, EstimateStatus::kInvalidInput) << what;
      EXPECT_TRUE(estimate.has_legs);
      EXPECT_EQ(estimate.leg_torque, last) << what;
    }
    EXPECT_LT((last - plant.disturbance).cwiseAbs().maxCoeff(), 0.02) << what;
  }
}

TEST(MomentumObserver, RefusesThePrintedGainsUnlessTheUserInsists) {
  ObserverOptions options{{"gains", std::vector<double>{17.5, 6.28, 2.25}}};
  EXPECT_THAT([&] { MomentumObserver(read_momentum_options(options), kTick); },
              ThrowsMessage<OptionError>(AllOf(HasSubstr("gains = 17.5;6.28;2.25"), HasSubstr("+2.01 +- 5.95j"),
                                               HasSubstr("allow_unstable"))));
  options["allow_unstable"] = true;
  EXPECT_NO_THROW(MomentumObserver(read_momentum_options(options), kTick));
  options = {{"gains", std::vector<double>{2.25, 6.28, 17.5}}};
  EXPECT_NO_THROW(MomentumObserver(read_momentum_options(options), kTick));
}

TEST(MomentumObserver, RefusesAGainScaleThatTheTickCannotHold) {
  const ObserverOptions options{{"gain_scale", 40.0}};
  EXPECT_NO_THROW(MomentumObserver(read_momentum_options(options), 1e-3));
  EXPECT_THAT([&] { MomentumObserver(read_momentum_options(options), 2.5e-3); },
              ThrowsMessage<OptionError>(AllOf(HasSubstr("gain_scale = 40"), HasSubstr("tick of 2.5 ms"),
                                               HasSubstr("largest stable tick 2.1"))));
}

TEST(MomentumObserver, AllowUnstableDoesNotAllowNonsense) {
  EXPECT_THROW(observer_with({}), OptionError);
  EXPECT_THROW(observer_with({{1.0, -1.0}}), OptionError);
  EXPECT_THROW(observer_with({std::vector<double>(9, 1.0)}), OptionError);
  for (const double dt : {0.0, -1e-3, std::nan("")}) EXPECT_THROW(observer_with(kReversed, dt), OptionError);
}

TEST(MomentumOptions, OrderAndGainsHaveToAgree) {
  EXPECT_EQ(read_momentum_options({}).gains.K, kReversed.K);
  EXPECT_EQ(read_momentum_options({{"order", 1.0}, {"gains", 25.0}}).gains.K, std::vector<double>{25.0});
  EXPECT_THAT(
      [] {
        read_momentum_options({{"order", 2.0}});
      },
      ThrowsMessage<OptionError>(AllOf(HasSubstr("order = 2"), HasSubstr("K_2, there are 3"))));
  EXPECT_THROW(read_momentum_options({{"order", 0.0}}), OptionError);
  EXPECT_THROW(read_momentum_options({{"gains", std::vector<double>(9, 1.0)}}), OptionError);
}

TEST(MomentumOptions, ReadsTheCoriolisChoice) {
  EXPECT_EQ(read_momentum_options({}).coriolis, Coriolis::kExact);
  EXPECT_EQ(read_momentum_options({{"coriolis", std::string("neglected")}}).coriolis, Coriolis::kNeglected);
  EXPECT_THROW(read_momentum_options({{"coriolis", std::string("no")}}), OptionError);
}

}  // namespace
}  // namespace dob::momentum_test
