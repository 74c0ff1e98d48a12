#include "sim/sensing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::sensing_test {
namespace {

constexpr PerLeg<bool> kAllTouch{true, true, true, true};

// A tick that can be told from every other by each of its numbers.
RobotState state_of(long tick) {
  RobotState s;
  const auto t = static_cast<double>(tick);
  s.p_WB.setConstant(t);
  s.v_WB.setConstant(10.0 * t);
  s.omega_WB.setConstant(20.0 * t);
  s.q.setConstant(0.1 * t);
  s.qd.setConstant(0.2 * t);
  return s;
}

SensorReading reading_of(long tick) {
  SensorReading r;
  r.joint_torque.setConstant(static_cast<double>(tick));
  for (Vec3& force : r.foot_force_W) force.setConstant(2.0 * static_cast<double>(tick));
  return r;
}

void expect_tick(const Measurement& m, long tick) {
  EXPECT_EQ(m.tick, tick);
  const RobotState s = state_of(tick);
  EXPECT_EQ(m.state.p_WB, s.p_WB);
  EXPECT_EQ(m.state.v_WB, s.v_WB);
  EXPECT_EQ(m.state.omega_WB, s.omega_WB);
  EXPECT_EQ(m.state.q, s.q);
  EXPECT_EQ(m.state.qd, s.qd);
  EXPECT_EQ(m.reading.joint_torque, reading_of(tick).joint_torque);
  EXPECT_EQ(m.reading.foot_force_W, reading_of(tick).foot_force_W);
}

TEST(Sensing, TellsTheTruthOfTheTickThatIsTheDelayAgoAndTheStartBeforeThat) {
  for (int delay = 0; delay <= kMaxDelayTicks; ++delay) {
    Sensing sensing({.delay_ticks = delay}, 1);
    for (int again = 0; again < 2; ++again) {  // the second time after a reset in the middle of a run
      sensing.reset(state_of(0));
      for (long k = 1; k <= 50; ++k) {
        expect_tick(sensing.measure(state_of(k), reading_of(k), kAllTouch), std::max(k - delay, 0L));
      }
    }
  }
}

// Moments of the normalised errors of 3 x 40000 numbers: standard errors 0.0029, 0.0041 and 0.014.
TEST(Sensing, NoiseOfBaseVelocitiesIsGaussianWhiteAndOfTheStatedSize) {
  Sensing sensing({.base_velocity_noise = 0.05, .base_angular_velocity_noise = 0.01}, 3);
  sensing.reset({});
  const int n = 40000;
  Eigen::Matrix<double, 5, 1> linear = Eigen::Matrix<double, 5, 1>::Zero();
  Eigen::Matrix<double, 5, 1> angular = linear;
  Vec3 last_linear = Vec3::Zero(), last_angular = Vec3::Zero();
  const auto add = [](Eigen::Matrix<double, 5, 1>& sum, const Vec3& z, Vec3& last) {
    for (int i = 0; i < 3; ++i) {
      const double x = z[i];
      sum += (Eigen::Matrix<double, 5, 1>() << x, x * x, x * x * x * x, x * last[i], x * z[(i + 1) % 3]).finished();
    }
    last = z;
  };
  for (long k = 1; k <= n; ++k) {
    const Measurement& m = sensing.measure(state_of(k), {}, kAllTouch);
    add(linear, (m.state.v_WB - state_of(k).v_WB) / 0.05, last_linear);
    add(angular, (m.state.omega_WB - state_of(k).omega_WB) / 0.01, last_angular);
    ASSERT_EQ(m.state.qd, state_of(k).qd);
    ASSERT_EQ(m.state.p_WB, state_of(k).p_WB);
  }
  for (const auto& sum : {linear, angular}) {
    EXPECT_NEAR(sum[0] / (3 * n), 0.0, 0.012);
    EXPECT_NEAR(sum[1] / (3 * n), 1.0, 0.017);
    EXPECT_NEAR(sum[2] / (3 * n), 3.0, 0.12);
    EXPECT_NEAR(sum[3] / (3 * n), 0.0, 0.012);  // with the tick before
    EXPECT_NEAR(sum[4] / (3 * n), 0.0, 0.012);  // between the axes
  }
}

TEST(Sensing, TorqueBiasIsConstantOfTheStatedSizeWithTheSeedsSigns) {
  int positive = 0;
  const int seeds = 200;
  for (int seed = 1; seed <= seeds; ++seed) {
    Sensing sensing({.torque_bias = 0.6}, static_cast<std::uint64_t>(seed));
    sensing.reset({});
    const Vec12 bias = sensing.measure({}, {}, kAllTouch).reading.joint_torque;
    EXPECT_EQ(bias.cwiseAbs(), Vec12::Constant(0.6));
    EXPECT_EQ(sensing.measure({}, {}, kAllTouch).reading.joint_torque, bias);
    positive += static_cast<int>((bias.array() > 0.0).count());
  }
  EXPECT_NEAR(positive, 6 * seeds, 5.0 * std::sqrt(3.0 * seeds));
}

TEST(Sensing, ForceBiasIsVerticalAndOnlyOnFeetThatTouch) {
  Sensing sensing({.foot_force_bias = -5.0}, 1);
  sensing.reset({});
  const SensorReading told = sensing.measure({}, reading_of(1), {true, false, false, true}).reading;
  EXPECT_EQ(told.foot_force_W[0], Vec3(2.0, 2.0, -3.0));
  EXPECT_EQ(told.foot_force_W[1], Vec3(2.0, 2.0, 2.0));
  EXPECT_EQ(told.foot_force_W[2], Vec3(2.0, 2.0, 2.0));
  EXPECT_EQ(told.foot_force_W[3], Vec3(2.0, 2.0, -3.0));
}

// The noise of a tick is the same whatever else is wrong, late, or was measured before.
TEST(Sensing, NoiseDependsOnSeedAndTickOnly) {
  Sensing plain({.base_velocity_noise = 1.0}, 5);
  Sensing other({.base_velocity_noise = 2.0,
                 .base_angular_velocity_noise = 0.3,
                 .torque_bias = 1.0,
                 .foot_force_bias = 4.0,
                 .delay_ticks = 3},
                5);
  Sensing seed({.base_velocity_noise = 1.0}, 6);
  plain.reset({});
  other.reset({});
  seed.reset({});
  std::vector<Vec3> noise{Vec3::Zero()};
  for (long k = 1; k <= 100; ++k) {
    noise.push_back(plain.measure({}, {}, kAllTouch).state.v_WB);
    EXPECT_NE(seed.measure({}, {}, kAllTouch).state.v_WB, noise.back());
    const Measurement& late = other.measure({}, reading_of(k), {});
    if (late.tick > 0) {
      EXPECT_EQ(late.state.v_WB, 2.0 * noise[static_cast<std::size_t>(late.tick)]);
    }
  }
}

TEST(Sensing, NamesTheErrorThatIsNotPossible) {
  const auto with = [](const SensingErrors& errors) { return [errors] { Sensing(errors, 1); }; };
  const auto message = [](const char* text) {
    return testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(text));
  };
  EXPECT_THAT(with({.base_velocity_noise = -0.1}), message("base_velocity_noise = -0.1, must be finite and >= 0"));
  EXPECT_THAT(with({.torque_bias = NAN}), message("torque_bias = nan"));
  EXPECT_THAT(with({.foot_force_bias = INFINITY}), message("foot_force_bias = inf, must be finite"));
  EXPECT_THAT(with({.delay_ticks = 11}), message("delay_ticks = 11, must be from 0 to 10"));
}

}  // namespace
}  // namespace dob::sensing_test
