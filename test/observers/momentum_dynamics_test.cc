// The momentum observer against the true full-space dynamics of the robot in free flight.
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "observers/momentum.h"
#include "test/observers/flight_test.h"

namespace dob::momentum_dynamics_test {
namespace {

using test::FreeFlight;

constexpr double kTick = 1e-3;
const MomentumGains kGains{{22.5, 62.8, 175.0}};  // the paper's in the stable order, times 10

class MomentumDynamicsTest : public test::FlightTest {
 protected:
  // Runs observer and robot side by side for a time T with damped joints; `check` sees every estimate.
  void fly(FreeFlight& flight, MomentumObserver& observer, double dt, double T, const auto& check) {
    ModelTerms now = flight.terms();
    observer.reset(now);
    for (int k = 0; k < std::lround(T / dt); ++k) {
      const ModelTerms start = now;
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
      check(estimate.leg_torque, start, now);
    }
  }

  // Worst distance between the estimate and the continuous observer's.
  double worst_error(const FreeFlight& prepared, const MomentumGains& gains, double dt, double T) {
    FreeFlight flight = prepared;
    MomentumObserver observer({.gains = gains}, dt);
    double worst = 0.0;
    fly(flight, observer, dt, T, [&](const Vec12& F_hat, const ModelTerms&, const ModelTerms&) {
      worst = std::max(worst, (F_hat - flight.filtered_disturbance()).cwiseAbs().maxCoeff());
    });
    return worst;
  }

  Vec12 hold = Vec12::LinSpaced(-0.6, 0.6);  // [N m]
};

TEST_F(MomentumDynamicsTest, FindsAPushOnTheLowerLegAtFirstOrderInTheTick) {
  for (int l = 0; l < kLegs; ++l) {
    FreeFlight flight(model, moving_state(), kGains);
    flight.push = {static_cast<Leg>(l), LegLink::kLower, Vec3(0.01, -0.02, -0.15), Vec3(5.0, -8.0, 4.0)};
    const double coarse = worst_error(flight, kGains, 1e-3, 0.25);
    const double fine = worst_error(flight, kGains, 0.5e-3, 0.25);
    EXPECT_LT(coarse, 0.1) << "leg " << l;  // [N m] of up to 3
    EXPECT_NEAR(coarse / fine, 2.0, 0.02) << "leg " << l << ": " << coarse << ' ' << fine;
  }
}

TEST_F(MomentumDynamicsTest, MapsBackToTheForceAtTheTipAlongWorldAxes) {
  RobotState state;
  state.R_WB = Eigen::AngleAxisd(0.9, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  for (int l = 0; l < kLegs; ++l) state.q.segment<3>(3 * l) = Vec3(0.1, 0.8, -1.5);
  hold.setZero();
  for (int l = 0; l < kLegs; ++l) {
    const test::Push push{static_cast<Leg>(l), LegLink::kLower, robot.legs[l].foot_center, Vec3(2.0, -3.0, 1.0)};
    Vec12 f = Vec12::Zero();
    f.segment<3>(3 * l) = push.force;
    // A first-order observer lags by dF/dt / K: with twice the gain at half the tick half the error must be left.
    const auto error_with = [&](double gain, double dt) {
      FreeFlight flight(model, state, {{gain}});
      flight.push = push;
      MomentumObserver observer({.gains = {{gain}}}, dt);
      Vec12 f_hat;
      fly(flight, observer, dt, 0.04, [&](const Vec12& F_hat, const ModelTerms&, const ModelTerms& now) {
        f_hat = jacobian_joints(now, now.foot).transpose().partialPivLu().solve(F_hat);
      });
      return (f_hat - f).norm();
    };
    const double coarse = error_with(400.0, 0.5e-3);
    const double fine = error_with(800.0, 0.25e-3);
    EXPECT_LT(fine, 0.02 * f.norm()) << "leg " << l;
    EXPECT_NEAR(coarse / fine, 2.0, 0.06) << "leg " << l << ": " << coarse << ' ' << fine;
  }
}

TEST_F(MomentumDynamicsTest, KnowsTheForcesOfFeetThatAreNotScheduledToStand) {
  FreeFlight flight(model, moving_state(), kGains);
  flight.contact_force << 3.0, -4.0, 20.0, 0.0, 5.0, 10.0, -6.0, 0.0, 15.0, 2.0, 2.0, 8.0;
  const double coarse = worst_error(flight, kGains, 1e-3, 0.25);
  const double fine = worst_error(flight, kGains, 0.5e-3, 0.25);
  EXPECT_LT(coarse, 0.05);  // [N m] of up to 6
  EXPECT_NEAR(coarse / fine, 2.0, 0.02) << coarse << ' ' << fine;
}

// Without disturbance each interval leaves the quadrature error of alpha, at most dt^2 / 2 max|d(alpha)/dt|,
// and a first-order filter with K dt <= 1 passes on no more than that divided by dt.
TEST_F(MomentumDynamicsTest, EstimatesNothingButTheQuadratureErrorWithoutADisturbance) {
  const MomentumGains gains{{100.0}};
  for (int trial = 0; trial < 5; ++trial) {
    FreeFlight flight(model, moving_state(), gains);
    MomentumObserver observer({.gains = gains}, kTick);
    double worst = 0.0;
    double fastest = 0.0;  // [N m/s] mean rates of C_q^T qd over the ticks; the torques are held
    fly(flight, observer, kTick, 0.25, [&](const Vec12& F_hat, const ModelTerms& start, const ModelTerms& now) {
      worst = std::max(worst, F_hat.cwiseAbs().maxCoeff());
      fastest = std::max(fastest, (now.CqT_qd - start.CqT_qd).cwiseAbs().maxCoeff() / kTick);
    });
    EXPECT_LE(worst, 0.5 * kTick * fastest);
    EXPECT_GT(fastest, 0.1);
  }
}

}  // namespace
}  // namespace dob::momentum_dynamics_test
