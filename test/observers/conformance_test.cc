// What every observer has to do, whatever its method and wherever it comes from: one suite over the factory's list and
// over plugins. (That none allocates is seen in allocation_test.cc, which counts.)
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/factory.h"
#include "observers/plugin.h"
#include "test/observers/free_flight.h"
#include "test/observers/ideal_plant.h"

namespace dob::conformance_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using test::IdealPlant;

constexpr double kTicks[] = {0.5e-3, 1e-3, 2.5e-3};  // [s]
constexpr double kRounding = 1e-9;                   // [N m] or [N], of momenta up to 60 and torques up to 30

// The suite's members: every built-in observer, the example plugin and one more, and the plugins that its user names:
//     DOB_CONFORMANCE_PLUGINS=./mine.so:./other.so build/bin/observers_test --gtest_filter='*Conformance*'
std::vector<ObserverInfo> observers_under_test() {
  const auto built_in = built_in_observers();
  std::vector<ObserverInfo> all(built_in.begin(), built_in.end());
  for (const char* plugin : {"pi_momentum.so", "first_order.so"}) {
    all.push_back(load_plugin(std::filesystem::path(DOB_PLUGIN_DIR) / plugin));
  }
  if (const char* named = std::getenv("DOB_CONFORMANCE_PLUGINS")) {
    std::istringstream list(named);
    for (std::string file; std::getline(list, file, ':');) all.push_back(load_plugin(file));
  }
  return all;
}

// A robot with legs that bear on the ground or fly, in motion, with torques that change from tick to tick.
IdealPlant moving_plant(bool standing) {
  IdealPlant plant;
  plant.momentum.setLinSpaced(-40.0, 55.0);
  plant.com_momentum << 30.0, -12.0, 5.0, 1.0, -2.0, 3.0;
  plant.com = Vec3(0.1, -0.2, 0.4);
  plant.lever << 0.3, 0.0, 0.1, 0.0, 0.2, -0.1, 0.05, 0.0, 0.25;
  plant.stance.fill(standing);
  for (int l = 0; l < kLegs; ++l) plant.contact[l] = Vec3(0.3 * (l < 2 ? 1 : -1), 0.2 * (l % 2 == 0 ? 1 : -1), 0.0);
  return plant;
}

void drive(IdealPlant& plant, int tick) {
  for (int i = 0; i < kJoints; ++i) {
    plant.torque[i] = 30.0 * std::sin(0.02 * tick + i);
    plant.coriolis[i] = 3.0 * std::cos(0.05 * tick - i);
    plant.foot_force[i] = plant.stance[0] ? 20.0 * std::cos(0.03 * tick + 2 * i) : 0.0;
  }
}

void disturb(IdealPlant& plant, double size) {
  plant.disturbance.setLinSpaced(-3.0 * size, 2.5 * size);
  plant.com_disturbance << 4.0 * size, -3.0 * size, 2.0 * size, -1.0 * size, 0.5 * size, 1.5 * size;
}

double size_of(const Estimate& estimate) {
  return std::max(estimate.leg_torque.cwiseAbs().maxCoeff(), estimate.com_wrench.cwiseAbs().maxCoeff());
}

double distance(const Estimate& a, const Estimate& b) {
  return std::max((a.leg_torque - b.leg_torque).cwiseAbs().maxCoeff(),
                  (a.com_wrench - b.com_wrench).cwiseAbs().maxCoeff());
}

// From the force on the plant to the estimate, k ticks of dt after a unit step, at the default options; by default what
// the CoM's estimate does is what the legs' does.
struct StepResponse {
  std::string_view observer;
  std::function<double(double dt, int k)> legs;
  std::function<double(double dt, int k)> moment = {};
  double tolerance = 1e-11;
};

std::function<double(double, int)> first_order(double gain) {
  return [gain](double dt, int k) { return 1.0 - std::exp(-gain * dt * k); };
}

std::function<double(double, int)> first_order_euler(double gain) {
  return [gain](double dt, int k) { return 1.0 - std::pow(1.0 - gain * dt, k); };
}

double double_pole(double dt, int k) {
  const double b = std::exp(-50.0 * dt);
  return 1.0 - std::pow(b, k) * (1.0 + k * (1.0 - b));
}

double butterworth(double w, double t) {
  const double x = w / std::sqrt(2.0) * t;
  return 1.0 - std::exp(-x) * (std::cos(x) + std::sin(x));
}

// The Kalman filters' is that of continuous time, w from walk and noise: kalman_test.cc has the discrete one.
double kalman(double dt, int k) {
  return butterworth(std::sqrt(0.0625 / (1e-3 * std::sqrt(dt))), k * dt);
}

const std::vector<StepResponse>& step_responses() {
  static const std::vector<StepResponse> all{
      {.observer = "com_wrench", .legs = first_order_euler(25.0), .moment = first_order_euler(10.0)},
      {.observer = "nonlinear_dob", .legs = first_order(10.0)},
      {.observer = "momentum_exact", .legs = first_order(25.0)},
      {.observer = "com_momentum_exact", .legs = first_order(25.0)},
      {.observer = "contact_consistent", .legs = first_order(25.0)},
      {.observer = "first_order", .legs = first_order_euler(50.0)},  // the plugin's
      {.observer = "eso", .legs = double_pole},
      {.observer = "com_eso", .legs = double_pole},
      {.observer = "direct", .legs = [](double dt, int k) { return butterworth(25.0, k * dt); }},
      {.observer = "kalman", .legs = kalman, .tolerance = 0.04},
      {.observer = "com_kalman", .legs = kalman, .tolerance = 0.04}};
  return all;
}

class Conformance : public testing::TestWithParam<ObserverInfo> {
 protected:
  std::unique_ptr<DisturbanceObserver> make(double dt = 1e-3) const { return GetParam().make({}, dt); }

  // The disturbance of the plant, as far as the observer says that it estimates it.
  Estimate truth(const IdealPlant& plant) const {
    Estimate t;
    if (GetParam().estimates_legs && !GetParam().oracle) t.leg_torque = plant.disturbance;
    if (GetParam().estimates_com && !GetParam().oracle) t.com_wrench = plant.com_disturbance;
    return t;
  }

  // Closed form of this observer, if there is one.
  const StepResponse* closed_form() const {
    const auto& all = step_responses();
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const StepResponse& r) { return r.observer == GetParam().name; });
    return it == all.end() ? nullptr : &*it;
  }
};

TEST_P(Conformance, SaysWhatItEstimatesAndNothingElse) {
  const auto observer = make();
  IdealPlant plant = moving_plant(false);
  disturb(plant, 1.0);
  observer->reset(plant.terms());
  Estimate estimate;
  for (int k = 0; k < 100; ++k) estimate = observer->update(plant.advance(1e-3));
  EXPECT_EQ(observer->name(), GetParam().name);
  EXPECT_EQ(estimate.has_legs, GetParam().estimates_legs);
  EXPECT_EQ(estimate.has_com, GetParam().estimates_com);
  EXPECT_EQ(estimate.leg_torque.isZero(0.0), truth(plant).leg_torque.isZero(0.0));
  EXPECT_EQ(estimate.com_wrench.isZero(0.0), truth(plant).com_wrench.isZero(0.0));
}

// Started in motion, with every known term at work: a momentum of 55 read as a disturbance would be far beyond
// rounding.
TEST_P(Conformance, EstimatesNothingWithoutADisturbance) {
  for (const bool standing : {true, false}) {
    for (const double dt : kTicks) {
      const auto observer = make(dt);
      IdealPlant plant = moving_plant(standing);
      observer->reset(plant.terms());
      for (int k = 0; k < 1000; ++k) {
        drive(plant, k);
        const Estimate estimate = observer->update(plant.advance(dt));
        ASSERT_EQ(estimate.status, EstimateStatus::kOk);
        ASSERT_LT(size_of(estimate), kRounding) << "tick " << k << " of " << dt << " s, standing " << standing;
      }
    }
  }
}

TEST_P(Conformance, FindsAConstantDisturbanceOfEveryJointAndAxisWithItsSign) {
  for (const double dt : kTicks) {
    for (const double sign : {-1.0, 1.0}) {
      const auto observer = make(dt);
      IdealPlant plant = moving_plant(false);
      disturb(plant, sign);
      observer->reset(plant.terms());
      Estimate estimate;
      for (int k = 0; k * dt < 8.0; ++k) {
        drive(plant, k);
        estimate = observer->update(plant.advance(dt));
      }
      EXPECT_LT(distance(estimate, truth(plant)), 1e-8) << dt;
    }
  }
}

TEST_P(Conformance, AnswersAStepAndASineInClosedForm) {
  const StepResponse* response = closed_form();
  if (response == nullptr) return;  // no closed form at the default options: the observer's own test says more
  const auto& moment = response->moment ? response->moment : response->legs;
  for (const double dt : kTicks) {
    std::vector<double> wave;  // mean of the disturbance over each tick, in units of disturb(plant, 1)
    const auto observer = make(dt);
    IdealPlant plant = moving_plant(false);
    observer->reset(plant.terms());
    for (int k = 1; k * dt < 0.75; ++k) {
      wave.push_back(k * dt < 0.25 ? 1.0 : std::sin(20.0 * k * dt));
      disturb(plant, wave.back());
      drive(plant, k);
      const Estimate estimate = observer->update(plant.advance(dt));
      double legs = 0.0;
      double angular = 0.0;
      for (int j = 1; j <= k; ++j) {
        const double before = wave[k - j];
        legs += before * (response->legs(dt, j) - response->legs(dt, j - 1));
        angular += before * (moment(dt, j) - moment(dt, j - 1));
      }
      IdealPlant unit;
      disturb(unit, 1.0);
      Estimate expected = truth(unit);
      expected.leg_torque *= legs;
      expected.com_wrench.head<3>() *= legs;
      expected.com_wrench.tail<3>() *= angular;
      ASSERT_LT(distance(estimate, expected), 4.0 * response->tolerance) << "tick " << k << " of " << dt;
    }
  }
}

TEST_P(Conformance, TakesTicksThatChange) {
  const auto observer = make(2.5e-3);
  IdealPlant plant = moving_plant(false);
  observer->reset(plant.terms());
  Estimate estimate;
  for (int k = 0; k < 9000; ++k) {
    if (k == 500) {
      ASSERT_LT(size_of(estimate), kRounding);
      disturb(plant, 1.0);
    }
    drive(plant, k);
    estimate = observer->update(plant.advance(kTicks[(k / 7) % 3]));
  }
  EXPECT_LT(distance(estimate, truth(plant)), 1e-8);
}

TEST_P(Conformance, GivesTheSameBitsTwiceAndAfterReset) {
  const auto first = make();
  const auto second = make();
  const auto run = [](DisturbanceObserver& observer) {
    IdealPlant plant = moving_plant(false);
    disturb(plant, 1.0);
    observer.reset(plant.terms());
    std::vector<Estimate> estimates;
    for (int k = 0; k < 300; ++k) {
      drive(plant, k);
      estimates.push_back(observer.update(plant.advance(1e-3)));
    }
    return estimates;
  };
  const std::vector<Estimate> estimates = run(*first);
  for (const auto& again : {run(*second), run(*first)}) {
    for (std::size_t k = 0; k < estimates.size(); ++k) ASSERT_EQ(distance(again[k], estimates[k]), 0.0) << k;
  }
}

// Ways to make one thing of an input wrong. Not every observer looks at each of them.
struct Spoilt {
  const char* what;
  std::function<void(ModelTerms& start, ModelTerms& now, ObserverInput& input)> spoil;
};

std::vector<Spoilt> ways_to_spoil() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {{"torque", [](auto&, auto&, ObserverInput& in) { in.joint_torque[7] = kNan; }},
          {"infinite torque", [](auto&, auto&, ObserverInput& in) { in.joint_torque[0] = -kInf; }},
          {"foot force", [](auto&, auto&, ObserverInput& in) { in.foot_force[11] = kInf; }},
          {"legs' momentum", [](auto&, ModelTerms& now, auto&) { now.rho[3] = kNan; }},
          {"joint rate", [](auto&, ModelTerms& now, auto&) { now.state.qd[3] = kNan; }},
          {"CoM velocity", [](auto&, ModelTerms& now, auto&) { now.v_c[1] = kInf; }},
          {"angular momentum", [](ModelTerms& start, auto&, auto&) { start.L[1] = kNan; }},
          {"contact point", [](ModelTerms& start, auto&, auto&) { start.contact[2].p.x() = kNan; }},
          {"contact Jacobian", [](ModelTerms& start, auto&, auto&) { start.contact[1].J_q(2, 0) = kInf; }},
          {"mass matrix", [](ModelTerms& start, auto&, auto&) { start.M_q(4, 4) = kNan; }},
          {"bias", [](ModelTerms& start, auto&, auto&) { start.c_q[4] = start.CqT_qd[4] = kNan; }},
          {"mass", [](ModelTerms& start, auto&, auto&) { start.mass = kNan; }},
          {"huge momentum", [](auto&, ModelTerms& now, auto&) { now.rho[1] = now.state.qd[1] = now.L[0] = 1.7e308; }},
          {"nan tick", [](auto&, auto&, ObserverInput& in) { in.dt = kNan; }},
          {"infinite tick", [](auto&, auto&, ObserverInput& in) { in.dt = kInf; }},
          {"zero tick", [](auto&, auto&, ObserverInput& in) { in.dt = 0.0; }},
          {"negative tick", [](auto&, auto&, ObserverInput& in) { in.dt = -1e-3; }}};
}

TEST_P(Conformance, IsNeverPoisonedByInvalidInput) {
  int refused = 0;
  for (const auto& [what, spoil] : ways_to_spoil()) {
    const auto observer = make();
    IdealPlant plant = moving_plant(false);
    disturb(plant, 1.0);
    observer->reset(plant.terms());
    Estimate last;
    for (int k = 0; k < 9000; ++k) {
      drive(plant, k);
      const ObserverInput good = plant.advance(1e-3);
      if (k < 200 || k >= 250) {
        last = observer->update(good);
        ASSERT_EQ(last.status, EstimateStatus::kOk) << what << " at tick " << k;
        continue;
      }
      ModelTerms start = good.start;
      ModelTerms now = good.now;
      ObserverInput bad{start, now, good.joint_torque, good.foot_force, good.stance, good.dt};
      spoil(start, now, bad);
      const Estimate estimate = observer->update(bad);
      ASSERT_TRUE(std::isfinite(size_of(estimate))) << what;
      EXPECT_EQ(estimate.has_legs, GetParam().estimates_legs);
      EXPECT_EQ(estimate.has_com, GetParam().estimates_com);
      if (estimate.status != EstimateStatus::kOk) ++refused;
    }
    EXPECT_LT(distance(last, truth(plant)), 1e-8) << what;
  }
  const bool observes = (GetParam().estimates_legs || GetParam().estimates_com) && !GetParam().oracle;
  EXPECT_EQ(refused > 0, observes);
}

// Where an input is refused by all of the observer, the interval might as well not have been.
TEST_P(Conformance, HoldsItsEstimateThroughALostInterval) {
  const auto observer = make();
  const auto twin = make();
  IdealPlant plant = moving_plant(false);
  disturb(plant, 1.0);
  observer->reset(plant.terms());
  twin->reset(plant.terms());
  Estimate last;
  for (int k = 0; k < 400; ++k) {
    drive(plant, k);
    const ObserverInput good = plant.advance(1e-3);
    if (k < 200 || k >= 300) {
      last = twin->update(good);
      ASSERT_EQ(distance(observer->update(good), last), 0.0) << k;
      continue;
    }
    const ObserverInput bad{good.start, good.now, good.joint_torque, good.foot_force, good.stance, -1.0};
    EXPECT_EQ(distance(observer->update(bad), last), 0.0) << k;
  }
}

// On the robot itself: a push at each foot along each axis of W, seen at the joints and about the CoM as it acts.
TEST_P(Conformance, FindsThePushOnEachFootAlongEachAxis) {
  if (GetParam().oracle || (!GetParam().estimates_legs && !GetParam().estimates_com)) return;
  static const Model model(
      load_robot(std::filesystem::path(DOB_SOURCE_DIR) / "robot/dogbot/dogbot.urdf", Forward::kMinusY));
  constexpr double kDt = 1e-3;
  RobotState state;
  state.R_WB = Eigen::AngleAxisd(0.9, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  for (int l = 0; l < kLegs; ++l) state.q.segment<3>(3 * l) = Vec3(0.1, 0.8, -1.5);
  state.v_WB = Vec3(0.3, -0.2, 0.1);
  for (int l = 0; l < kLegs; ++l) {
    for (int axis = 0; axis < 3; ++axis) {
      test::FreeFlight flight(model, state, {{1.0}});
      const Vec3 force = 1.5 * Vec3::Unit(axis);
      flight.push = {static_cast<Leg>(l), LegLink::kLower, model.description().legs[l].foot_center, force};
      const auto observer = make(kDt);
      ModelTerms now = flight.terms();
      observer->reset(now);
      Estimate estimate;
      for (int k = 0; k < 120; ++k) {
        const ModelTerms start = now;
        flight.torque = -0.2 * flight.state.qd;
        flight.advance(kDt);
        now = flight.terms();
        estimate = observer->update({start, now, flight.torque, flight.contact_force, {}, kDt});
      }
      const auto agrees = [&](const auto& found, const auto& wanted, const char* part) {
        EXPECT_GT(found.dot(wanted), 0.95 * found.norm() * wanted.norm()) << part << " leg " << l << " axis " << axis;
        EXPECT_GT(found.norm(), 0.02 * wanted.norm()) << part << " leg " << l << " axis " << axis;
        EXPECT_LT(found.norm(), 1.1 * wanted.norm()) << part << " leg " << l << " axis " << axis;
      };
      const Vec3 arm = leg_point(now, flight.push.leg, flight.push.link, flight.push.p_L).p - now.p_com;
      if (GetParam().estimates_legs) agrees(estimate.leg_torque, flight.disturbance(now), "legs");
      if (GetParam().estimates_com) agrees(estimate.com_wrench.head<3>(), force, "force");
      if (GetParam().estimates_com) agrees(estimate.com_wrench.tail<3>(), arm.cross(force), "moment");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Observers, Conformance, testing::ValuesIn(observers_under_test()),
                         [](const auto& member) {  // two plugins may have one name
                           return std::string(member.param.name) + "_" + std::to_string(member.index);
                         });

// What a tick cannot hold is refused there, with the largest tick that could.
TEST(Gains, ThatATickCannotHoldAreRefusedThere) {
  struct Limit {
    const char* observer;
    const char* key;
    double value;
    std::string at_2_5_ms;
  };
  for (const Limit& limit : {Limit{"momentum", "gain_scale", 40.0, "largest stable tick 2.1"},
                             Limit{"com_wrench", "linear_gain_rad_s", 900.0, "largest stable tick 2.222 ms"},
                             Limit{"com_wrench", "angular_gain_rad_s", 900.0, "largest stable tick 2.222 ms"}}) {
    const ObserverOptions options{{limit.key, limit.value}};
    EXPECT_NO_THROW(make_observer(limit.observer, options, 0.5e-3));
    EXPECT_NO_THROW(make_observer(limit.observer, options, 1e-3));
    EXPECT_THAT([&] { make_observer(limit.observer, options, 2.5e-3); },
                ThrowsMessage<OptionError>(AllOf(HasSubstr(limit.observer), HasSubstr(limit.at_2_5_ms))));
  }
}

// The other methods are exact or implicit in time: no gain is too fast for any tick.
TEST(Gains, WithoutALimitAreHeldFarBeyondTheTick) {
  const std::pair<const char*, ObserverOptions> all[] = {
      {"momentum_exact", {{"gain_rad_s", 1e5}}},
      {"eso", {{"bandwidth_rad_s", 1e5}}},
      {"direct", {{"bandwidth_rad_s", 1e5}}},
      {"nonlinear_dob", {{"X", 1e5}}},
      {"nonlinear_dob", {{"X", 1e5}, {"reading", std::string("literal")}}},
      {"contact_consistent", {{"gain_rad_s", 1e5}}},
      {"kalman", {{"walk", 1e5}}},
      {"sliding_mode", {{"rate", 1e7}}},
      {"sliding_mode", {{"rate", 1e7}, {"linear_rad_s", 1e5}}}};
  for (const auto& [name, options] : all) {
    const auto observer = make_observer(name, options, 2.5e-3);
    IdealPlant plant = moving_plant(false);
    disturb(plant, 1.0);
    Estimate estimate;
    for (int k = 0; k < 20; ++k) {
      drive(plant, k);
      estimate = observer->update(plant.advance(2.5e-3));
      ASSERT_LT(size_of(estimate), 10.0) << name << " tick " << k;
    }
    EXPECT_LT((estimate.leg_torque - plant.disturbance).cwiseAbs().maxCoeff(), 1e-4) << name;
  }
}

TEST(Gains, NeedATick) {
  for (const ObserverInfo& info : built_in_observers()) {
    if (info.oracle || (!info.estimates_legs && !info.estimates_com)) continue;
    for (const double dt : {0.0, -1e-3, std::nan("")}) EXPECT_THROW(info.make({}, dt), OptionError) << info.name;
  }
}

}  // namespace
}  // namespace dob::conformance_test
