// The CoM-wrench observer on the ideal plant, where every answer is a closed form.
#include "observers/com_wrench.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/observers/ideal_plant.h"

namespace dob::com_wrench_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using test::IdealPlant;

constexpr double kTick = 1e-3;
const ComWrenchOptions kPaper;
const Vec6 kPush = (Vec6() << 20.0, -12.0, 8.0, 3.0, -5.0, 2.0).finished();

double gain(const ComWrenchOptions& options, int axis) {
  return axis < 3 ? options.linear_gain : options.angular_gain;
}

// Ground reaction forces that move the plant about: they are known, so that the estimate must not see them.
void drive(IdealPlant& plant, int tick) {
  plant.com = Vec3(0.3, -0.2, 0.4) + 1e-3 * tick * Vec3(0.1, 0.02, -0.01);
  for (int l = 0; l < kLegs; ++l) {
    plant.contact[l] = Vec3(l < 2 ? 0.6 : 0.0, l % 2 == 0 ? 0.1 : -0.4, 0.01 * l);
    for (int i = 0; i < 3; ++i)
      plant.foot_force[3 * l + i] = (i == 2 ? 50.0 : 0.0) + 30.0 * std::sin(0.02 * tick + l + i);
  }
}

TEST(ComWrenchObserver, AnswersAStepOnEveryAxisAsItsRecursionSaysAndNoOtherAxis) {
  for (int axis = 0; axis < 6; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      ComWrenchObserver observer(kPaper, kTick);
      IdealPlant plant;
      plant.com_disturbance[axis] = 4.0 * sign;
      for (int k = 1; k <= 400; ++k) {
        drive(plant, k);
        const Vec6 w = observer.update(plant.advance(kTick)).com_wrench;
        Vec6 expected = Vec6::Zero();
        expected[axis] = 4.0 * sign * (1.0 - std::pow(1.0 - gain(kPaper, axis) * kTick, k));
        ASSERT_LT((w - expected).cwiseAbs().maxCoeff(), 1e-9) << "axis " << axis << " tick " << k;
      }
    }
  }
}

// Largest distance from G / (s + G) applied to f(t), in units of the amplitude.
double worst_error(double dt, const std::function<double(double)>& mean_force,
                   const std::function<double(double t, double G)>& response) {
  ComWrenchObserver observer(kPaper, dt);
  IdealPlant plant;
  double worst = 0.0;
  for (int k = 0; k * dt < 1.0; ++k) {
    plant.com_disturbance.setConstant(mean_force(k * dt));
    drive(plant, k);
    const Vec6 w = observer.update(plant.advance(dt)).com_wrench;
    for (int axis = 0; axis < 6; ++axis) {
      worst = std::max(worst, std::abs(w[axis] - response((k + 1) * dt, gain(kPaper, axis))));
    }
  }
  return worst;
}

TEST(ComWrenchObserver, StepResponseConvergesToTheClosedFormAtFirstOrder) {
  const auto error = [](double dt) {
    return worst_error(
        dt, [](double) { return 1.0; }, [](double t, double G) { return 1.0 - std::exp(-G * t); });
  };
  EXPECT_LT(error(1e-3), 0.005);
  EXPECT_NEAR(error(1e-3) / error(0.5e-3), 2.0, 0.03);
  EXPECT_NEAR(error(0.5e-3) / error(0.25e-3), 2.0, 0.015);
}

TEST(ComWrenchObserver, SineResponseConvergesToTheClosedFormAtFirstOrder) {
  constexpr double kOmega = 12.0;  // [rad/s]
  const auto error = [](double dt) {
    // The plant holds its disturbance over a tick: the mean of the sine, so that the momentum is exact.
    const auto mean = [dt](double t) { return (std::cos(kOmega * t) - std::cos(kOmega * (t + dt))) / (kOmega * dt); };
    const auto response = [](double t, double G) {
      const double d = G * G + kOmega * kOmega;
      return G / d * (G * std::sin(kOmega * t) - kOmega * std::cos(kOmega * t) + kOmega * std::exp(-G * t));
    };
    return worst_error(dt, mean, response);
  };
  EXPECT_LT(error(1e-3), 0.01);
  EXPECT_NEAR(error(1e-3) / error(0.5e-3), 2.0, 0.05);
  EXPECT_NEAR(error(0.5e-3) / error(0.25e-3), 2.0, 0.03);
}

TEST(ComWrenchObserver, TakesTheLengthOfEveryIntervalAsItComes) {
  ComWrenchObserver observer(kPaper, kTick);
  IdealPlant plant;
  plant.com_disturbance = kPush;
  Vec6 left = Vec6::Ones();  // share of the step that is not yet seen
  for (int k = 0; k < 300; ++k) {
    drive(plant, k);
    const double dt = k % 3 == 0 ? 0.4e-3 : 1.7e-3;
    for (int axis = 0; axis < 6; ++axis) left[axis] *= 1.0 - gain(kPaper, axis) * dt;
    const Vec6 expected = kPush.cwiseProduct(Vec6::Ones() - left);
    ASSERT_LT((observer.update(plant.advance(dt)).com_wrench - expected).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
}

TEST(ComWrenchObserver, TakesNothingButTheMomentumFromTheEndOfTheInterval) {
  ComWrenchObserver observer(kPaper, kTick);
  ComWrenchObserver twin(kPaper, kTick);
  IdealPlant plant;
  plant.com_disturbance = kPush;
  for (int k = 0; k < 20; ++k) {
    drive(plant, k);
    const ObserverInput input = plant.advance(kTick);
    ModelTerms now = input.now;
    now.p_com.setConstant(1e3);
    now.I_c.setConstant(1e3);
    for (LegPoint& point : now.contact) point.p.setConstant(1e3);
    const ObserverInput altered{input.start, now, input.joint_torque, input.foot_force, input.stance, input.dt};
    EXPECT_EQ(observer.update(altered).com_wrench, twin.update(input).com_wrench);
  }
}

TEST(ComWrenchObserver, StartsInMotionWithoutATransient) {
  ComWrenchObserver observer(kPaper, kTick);
  IdealPlant plant;
  plant.com_momentum << 40.0, -30.0, 5.0, 2.0, -3.0, 6.0;
  observer.reset(plant.terms());
  for (int k = 0; k < 1000; ++k) {
    drive(plant, k);
    // Rounding only: a momentum of 40 read as a disturbance would give 40 * 25 = 1000 N.
    ASSERT_LT(observer.update(plant.advance(kTick)).com_wrench.cwiseAbs().maxCoeff(), 1e-9) << "tick " << k;
  }
}

// A mass m (1 + e) in the model of a robot that stands: the measured forces carry m g only.
TEST(ComWrenchObserver, ReadsAMassErrorAsAnUpwardForceOfThatShareOfTheWeight) {
  for (const double e : {-0.3, 0.3}) {
    ComWrenchObserver observer(kPaper, kTick);
    IdealPlant plant;
    for (int l = 0; l < kLegs; ++l) {
      plant.foot_force[3 * l + 2] = 0.25 * plant.mass * kGravity;
      plant.contact[l] = Vec3(l < 2 ? 0.3 : -0.3, l % 2 == 0 ? 0.2 : -0.2, -0.4);
    }
    Vec6 w;
    for (int k = 0; k < 3000; ++k) {
      const ObserverInput input = plant.advance(kTick);
      ModelTerms start = input.start;
      ModelTerms now = input.now;
      start.mass *= 1.0 + e;
      now.mass *= 1.0 + e;
      w = observer.update({start, now, input.joint_torque, input.foot_force, input.stance, input.dt}).com_wrench;
    }
    const Vec6 expected = e * plant.mass * kGravity * Vec6::Unit(2);
    EXPECT_LT((w - expected).cwiseAbs().maxCoeff(), 1e-9) << "e = " << e << ": " << w.transpose();
  }
}

// While the CoM accelerates, the whole of the wrong part's inertia force is read: e m (c_dd + g e_z).
TEST(ComWrenchObserver, ReadsAMassErrorOfAnAcceleratedRobotWithItsInertiaForce) {
  constexpr double kError = 0.3;
  ComWrenchObserver observer(kPaper, kTick);
  IdealPlant plant;
  const Vec3 acceleration(0.5, -0.8, 0.2);
  plant.foot_force.head<3>() = plant.mass * (acceleration + kGravity * Vec3::UnitZ());
  Vec6 w;
  for (int k = 0; k < 3000; ++k) {
    const ObserverInput input = plant.advance(kTick);
    ModelTerms start = input.start;
    ModelTerms now = input.now;
    start.mass *= 1.0 + kError;
    now.mass *= 1.0 + kError;
    w = observer.update({start, now, input.joint_torque, input.foot_force, input.stance, input.dt}).com_wrench;
  }
  EXPECT_LT((w.head<3>() - kError * plant.foot_force.head<3>()).norm(), 1e-8) << w.transpose();
}

std::vector<Vec6> record(ComWrenchObserver& observer, int ticks) {
  IdealPlant plant;
  plant.com_disturbance = kPush;
  observer.reset(plant.terms());
  std::vector<Vec6> estimates;
  for (int k = 0; k < ticks; ++k) {
    drive(plant, k);
    estimates.push_back(observer.update(plant.advance(kTick)).com_wrench);
  }
  return estimates;
}

TEST(ComWrenchObserver, GivesTheSameBitsTwiceAndAfterReset) {
  ComWrenchObserver first(kPaper, kTick);
  ComWrenchObserver second(kPaper, kTick);
  const std::vector<Vec6> estimates = record(first, 300);
  EXPECT_EQ(record(second, 300), estimates);
  EXPECT_EQ(record(first, 300), estimates) << "after reset";
}

// A way to make one thing of an input wrong.
struct Spoilt {
  const char* what;
  std::function<void(ModelTerms& start, ModelTerms& now, Vec12& force, double& dt)> spoil;
};

std::vector<Spoilt> ways_to_spoil() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {{"foot force", [](auto&, auto&, Vec12& f, auto&) { f[11] = kNan; }},
          {"infinite foot force", [](auto&, auto&, Vec12& f, auto&) { f[2] = -kInf; }},
          {"velocity now", [](auto&, ModelTerms& now, auto&, auto&) { now.v_c[1] = kNan; }},
          {"velocity before", [](ModelTerms& start, auto&, auto&, auto&) { start.v_c[0] = kInf; }},
          {"angular momentum", [](auto&, ModelTerms& now, auto&, auto&) { now.L[2] = kNan; }},
          {"contact point", [](ModelTerms& start, auto&, auto&, auto&) { start.contact[2].p.x() = kNan; }},
          {"centre of mass", [](ModelTerms& start, auto&, auto&, auto&) { start.p_com.z() = kInf; }},
          {"mass", [](ModelTerms& start, auto&, auto&, auto&) { start.mass = kNan; }},
          {"nan tick", [](auto&, auto&, auto&, double& dt) { dt = kNan; }},
          {"infinite tick", [](auto&, auto&, auto&, double& dt) { dt = kInf; }},
          {"zero tick", [](auto&, auto&, auto&, double& dt) { dt = 0.0; }},
          {"overflow", [](auto&, ModelTerms& now, auto&, auto&) { now.L[1] = 1.7e308; }}};
}

TEST(ComWrenchObserver, IgnoresInvalidInputAndGoesOnAsIfTheIntervalHadNotBeen) {
  for (const auto& [what, spoil] : ways_to_spoil()) {
    ComWrenchObserver observer(kPaper, kTick);
    ComWrenchObserver twin(kPaper, kTick);
    IdealPlant plant;
    plant.com_disturbance = kPush;
    Vec6 last = Vec6::Zero();
    for (int k = 0; k < 1600; ++k) {
      drive(plant, k);
      const ObserverInput good = plant.advance(kTick);
      if (k < 200 || k >= 300) {  // 100 lost ticks, in which the momentum changes by 2 kg m/s and more
        const Estimate estimate = observer.update(good);
        EXPECT_EQ(estimate.status, EstimateStatus::kOk) << what;
        last = twin.update(good).com_wrench;
        ASSERT_EQ(estimate.com_wrench, last) << what << " at tick " << k;
        continue;
      }
      ModelTerms start = good.start;
      ModelTerms now = good.now;
      ObserverInput bad{start, now, good.joint_torque, good.foot_force, good.stance, good.dt};
      spoil(start, now, bad.foot_force, bad.dt);
      const Estimate estimate = observer.update(bad);
      EXPECT_EQ(estimate.status, EstimateStatus::kInvalidInput) << what;
      EXPECT_TRUE(estimate.has_com);
      EXPECT_EQ(estimate.com_wrench, last) << what;
    }
    EXPECT_LT((last - kPush).cwiseAbs().maxCoeff(), 1e-4) << what;
  }
}

TEST(ComWrenchObserver, DoesNotAskForJointTorques) {
  ComWrenchObserver observer(kPaper, kTick);
  IdealPlant plant;
  plant.torque.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(observer.update(plant.advance(kTick)).status, EstimateStatus::kOk);
}

double size_after_a_kick(const ComWrenchOptions& options, double dt) {
  ComWrenchObserver observer(options, dt);
  IdealPlant plant;
  plant.com_disturbance.setOnes();
  observer.update(plant.advance(dt));
  plant.com_disturbance.setZero();
  double size = 0.0;
  for (int k = 0; k < 4000; ++k) size = observer.update(plant.advance(dt)).com_wrench.cwiseAbs().maxCoeff();
  return size;
}

TEST(ComWrenchObserver, HoldsForGainsUpToTwoPerTickAndRefusesMore) {
  EXPECT_LT(size_after_a_kick({.linear_gain = 1980.0, .angular_gain = 1980.0}, 1e-3), 1e-9);
  const auto make = [](const char* key, double gain, double dt) {
    return [=] { ComWrenchObserver(read_com_wrench_options({{key, gain}}), dt); };
  };
  EXPECT_THAT(make("linear_gain_rad_s", 2000.0, 1e-3),
              ThrowsMessage<OptionError>("observer com_wrench: option linear_gain_rad_s = 2000 is refused: unstable at "
                                         "the tick of 1 ms: spectral radius 1; largest stable tick 1 ms"));
  EXPECT_THAT(make("angular_gain_rad_s", 1000.0, 2.5e-3),
              ThrowsMessage<OptionError>(AllOf(HasSubstr("option angular_gain_rad_s = 1000"),
                                               HasSubstr("tick of 2.5 ms: spectral radius 1.5"),
                                               HasSubstr("largest stable tick 2 ms"))));
}

TEST(ComWrenchObserver, RefusesNonsense) {
  const auto read = [](const char* key, const OptionValue& value) {
    return [=] { read_com_wrench_options({{key, value}}); };
  };
  EXPECT_THAT(read("linear_gain_rad_s", 0.0), ThrowsMessage<OptionError>(HasSubstr("linear_gain_rad_s = 0")));
  EXPECT_THAT(read("angular_gain_rad_s", -1.0), ThrowsMessage<OptionError>(HasSubstr("allowed is a number in (0, ")));
  EXPECT_THAT(read("linear_gain_rad_s", std::string("fast")), ThrowsMessage<OptionError>(HasSubstr("\"fast\"")));
  EXPECT_THAT(read("linear_gain", 25.0),
              ThrowsMessage<OptionError>(HasSubstr("there are: angular_gain_rad_s, linear_gain_rad_s")));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ComWrenchObserver({.linear_gain = nan}, kTick), OptionError);
  EXPECT_THROW(ComWrenchObserver({.angular_gain = 0.0}, kTick), OptionError);
  for (const double dt : {0.0, -1e-3, nan}) EXPECT_THROW(ComWrenchObserver(kPaper, dt), OptionError);
}

TEST(ComWrenchObserver, HasTheGainsOfThePaperUnlessToldOtherwise) {
  EXPECT_EQ(read_com_wrench_options({}).linear_gain, 25.0);
  EXPECT_EQ(read_com_wrench_options({}).angular_gain, 10.0);
  EXPECT_EQ(read_com_wrench_options({{"angular_gain_rad_s", 30.0}}).angular_gain, 30.0);
}

}  // namespace
}  // namespace dob::com_wrench_test
