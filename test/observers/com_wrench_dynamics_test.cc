// The CoM-wrench observer against the true full-space dynamics of the robot in free flight.
#include <gtest/gtest.h>

#include "observers/com_wrench.h"
#include "test/observers/flight_test.h"

namespace dob::com_wrench_dynamics_test {
namespace {

using test::FreeFlight;

class ComWrenchDynamicsTest : public test::FlightTest {
 protected:
  ComWrenchDynamicsTest() : FlightTest(11) {}

  ComWrenchOptions gains{.linear_gain = 40.0, .angular_gain = 25.0};

  FreeFlight flight_from(const RobotState& state) { return FreeFlight(model, state, {{1.0}}); }

  // The push's wrench about the CoM, from positions alone.
  static Vec6 wrench(const FreeFlight& flight, const ModelTerms& t) {
    const Vec3 p = leg_point(t, flight.push.leg, flight.push.link, flight.push.p_L).p;
    Vec6 w;
    w << flight.push.force, (p - t.p_com).cross(flight.push.force);
    return w;
  }

  // Runs observer and robot side by side for a time T with damped joints; `push(t)` is the force over the tick that
  // starts at t, `check` sees every estimate.
  void fly(FreeFlight flight, double dt, double T, const auto& push, const auto& check) {
    ComWrenchObserver observer(gains, dt);
    ModelTerms now = flight.terms();
    observer.reset(now);
    for (int k = 0; k < std::lround(T / dt); ++k) {
      const ModelTerms start = now;
      flight.push.force = push(k * dt);
      flight.torque = hold - 0.2 * flight.state.qd;
      flight.advance(dt);
      now = flight.terms();
      const Estimate estimate = observer.update({.start = start,
                                                 .now = now,
                                                 .joint_torque = flight.torque,
                                                 .foot_force = flight.contact_force,
                                                 .stance = {},
                                                 .dt = dt});
      ASSERT_EQ(estimate.status, EstimateStatus::kOk);
      check(flight, estimate.com_wrench, start, now, (k + 1) * dt);
    }
  }

  Vec12 hold = Vec12::LinSpaced(-0.6, 0.6);  // [N m]
};

// Gravity and the disturbance are all that change m c_dot, whatever the legs do meanwhile.
TEST_F(ComWrenchDynamicsTest, AnswersAForceStepAlongEveryAxisInClosedForm) {
  constexpr double kDt = 1e-3;
  for (int axis = 0; axis < 3; ++axis) {
    FreeFlight flight = flight_from(moving_state());
    flight.push = {Leg::kRH, LegLink::kUpper, Vec3(0.01, -0.02, -0.15), Vec3::Zero()};
    const Vec3 force = 9.0 * Vec3::Unit(axis);
    int k = 0;
    fly(
        flight, kDt, 0.3, [&](double) { return force; },
        [&](const FreeFlight&, const Vec6& w, const ModelTerms&, const ModelTerms&, double) {
          ++k;
          const Vec3 expected = (1.0 - std::pow(1.0 - gains.linear_gain * kDt, k)) * force;
          ASSERT_LT((w.head<3>() - expected).cwiseAbs().maxCoeff(), 1e-6) << "axis " << axis << " tick " << k;
        });
  }
}

TEST_F(ComWrenchDynamicsTest, FollowsAForceSineAtFirstOrderInTheTick) {
  constexpr double kOmega = 15.0;  // [rad/s]
  FreeFlight flight = flight_from(moving_state());
  flight.push = {Leg::kLF, LegLink::kLower, Vec3::Zero(), Vec3::Zero()};
  const Vec3 amplitude(6.0, -4.0, 5.0);
  const double G = gains.linear_gain;
  const auto worst = [&](double dt) {
    double error = 0.0;
    const auto mean = [&](double t) {
      return Vec3((std::cos(kOmega * t) - std::cos(kOmega * (t + dt))) / (kOmega * dt) * amplitude);
    };
    fly(flight, dt, 0.5, mean, [&](const FreeFlight&, const Vec6& w, const ModelTerms&, const ModelTerms&, double t) {
      const double response = G / (G * G + kOmega * kOmega) *
                              (G * std::sin(kOmega * t) - kOmega * std::cos(kOmega * t) + kOmega * std::exp(-G * t));
      error = std::max(error, (w.head<3>() - response * amplitude).cwiseAbs().maxCoeff());
    });
    return error;
  };
  const double coarse = worst(1e-3);
  const double fine = worst(0.5e-3);
  EXPECT_LT(coarse, 0.1);  // [N] of 6
  EXPECT_NEAR(coarse / fine, 2.0, 0.05) << coarse << ' ' << fine;
}

// The moment changes as the robot turns under a constant force: the continuous filter is integrated beside it with the
// trapezoidal rule, whose error is of second order.
TEST_F(ComWrenchDynamicsTest, FindsTheMomentOfAPushAtFirstOrderInTheTick) {
  for (int l = 0; l < kLegs; ++l) {
    FreeFlight flight = flight_from(moving_state());
    flight.push = {static_cast<Leg>(l), LegLink::kLower, robot.legs[l].foot_center, Vec3(5.0, -8.0, 4.0)};
    const Vec3 force = flight.push.force;
    const auto worst = [&](double dt) {
      Vec6 filtered = Vec6::Zero();
      Vec6 G;
      G << Vec3::Constant(gains.linear_gain), Vec3::Constant(gains.angular_gain);
      const Vec6 h = 0.5 * dt * G;
      double error = 0.0;
      fly(
          flight, dt, 0.3, [&](double) { return force; },
          [&](const FreeFlight& f, const Vec6& w, const ModelTerms& start, const ModelTerms& now, double) {
            const Vec6 both = wrench(f, start) + wrench(f, now);
            filtered = (filtered - h.cwiseProduct(filtered) + h.cwiseProduct(both)).cwiseQuotient(Vec6::Ones() + h);
            error = std::max(error, (w - filtered).tail<3>().cwiseAbs().maxCoeff());
          });
      return error;
    };
    const double coarse = worst(1e-3);
    const double fine = worst(0.5e-3);
    EXPECT_LT(coarse, 0.1) << "leg " << l;  // [N m] of up to 5
    EXPECT_NEAR(coarse / fine, 2.0, 0.05) << "leg " << l << ": " << coarse << ' ' << fine;
  }
}

// Known forces of all feet leave only the quadrature error of the known moment: each interval at most
// dt^2 / 2 max|d(known)/dt|, of which a first-order filter with G dt <= 1 passes on no more than that divided by dt.
TEST_F(ComWrenchDynamicsTest, EstimatesNothingButTheQuadratureErrorOfKnownForces) {
  constexpr double kDt = 1e-3;
  for (int trial = 0; trial < 5; ++trial) {
    FreeFlight flight = flight_from(moving_state());
    flight.contact_force << 3.0, -4.0, 20.0, 0.0, 5.0, 10.0, -6.0, 0.0, 15.0, 2.0, 2.0, 8.0;
    double force = 0.0;
    double moment = 0.0;
    double fastest = 0.0;  // [N m/s]
    fly(
        flight, kDt, 0.25, [](double) { return Vec3::Zero().eval(); },
        [&](const FreeFlight& f, const Vec6& w, const ModelTerms& start, const ModelTerms& now, double) {
          force = std::max(force, w.head<3>().cwiseAbs().maxCoeff());
          moment = std::max(moment, w.tail<3>().cwiseAbs().maxCoeff());
          const Vec6 change =
              com_wrench(now, now.contact, f.contact_force) - com_wrench(start, start.contact, f.contact_force);
          fastest = std::max(fastest, change.tail<3>().cwiseAbs().maxCoeff() / kDt);
        });
    EXPECT_LT(force, 1e-6);
    EXPECT_LE(moment, 0.5 * kDt * fastest);
    EXPECT_GT(fastest, 1.0);
  }
}

}  // namespace
}  // namespace dob::com_wrench_dynamics_test
