// The legs' observers beside the momentum observer, against the true full-space dynamics of the robot in free flight.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "observers/factory.h"
#include "test/observers/flight_test.h"
#include "test/observers/ideal_plant.h"

namespace dob::leg_methods_test {
namespace {

using test::FreeFlight;

constexpr double kGain = 60.0;  // [rad/s]

class LegMethodsTest : public test::FlightTest {
 protected:
  RobotState bent_state() {
    RobotState state = moving_state();
    for (int l = 0; l < kLegs; ++l) state.q[3 * l + 2] = l % 2 == 0 ? -1.2 : 1.2;  // no stretched knee
    return state;
  }

  // Runs observer and robot side by side; `check` sees every estimate. Foot forces are known only as `measured` of
  // them.
  void fly(FreeFlight flight, DisturbanceObserver& observer, double dt, double T, const PerLeg<bool>& stance,
           double measured, const auto& check) {
    ModelTerms now = flight.terms();
    observer.reset(now);
    for (int k = 0; k < std::lround(T / dt); ++k) {
      const ModelTerms start = now;
      flight.torque = Vec12::LinSpaced(-0.6, 0.6) - 0.2 * flight.state.qd;
      flight.advance(dt);
      now = flight.terms();
      const Estimate estimate =
          observer.update({start, now, flight.torque, measured * flight.contact_force, stance, dt});
      ASSERT_EQ(estimate.status, EstimateStatus::kOk);
      check(flight, estimate, start, now);
    }
  }

  double worst_error(const FreeFlight& prepared, std::string_view name, const ObserverOptions& options, double dt) {
    const auto observer = make_observer(name, options, dt);
    double worst = 0.0;
    fly(prepared, *observer, dt, 0.2, {}, 1.0,
        [&](const FreeFlight& flight, const Estimate& estimate, const ModelTerms&, const ModelTerms&) {
          worst = std::max(worst, (estimate.leg_torque - flight.filtered_disturbance()).cwiseAbs().maxCoeff());
        });
    return worst;
  }
};

TEST_F(LegMethodsTest, AreTheContinuousFirstOrderFilterAtFirstOrderInTheTick) {
  const std::pair<const char*, ObserverOptions> methods[] = {{"momentum_exact", {{"gain_rad_s", kGain}}},
                                                             {"nonlinear_dob", {{"X", kGain}}}};
  for (const auto& [name, options] : methods) {
    FreeFlight flight(model, bent_state(), {{kGain}});
    flight.push = {Leg::kRF, LegLink::kLower, Vec3(0.01, -0.02, -0.15), Vec3(5.0, -8.0, 4.0)};
    flight.contact_force << 3.0, -4.0, 20.0, 0.0, 5.0, 10.0, -6.0, 0.0, 15.0, 2.0, 2.0, 8.0;
    const double coarse = worst_error(flight, name, options, 1e-3);
    const double fine = worst_error(flight, name, options, 0.5e-3);
    EXPECT_LT(coarse, 0.3) << name;  // [N m] of up to 3, and of 6 from the known forces
    EXPECT_NEAR(coarse / fine, 2.0, 0.06) << name << ' ' << coarse << ' ' << fine;
  }
}

TEST(NonlinearDob, ReadLiterallyHasTheInertiaInItsBandwidth) {
  const auto observer = make_observer("nonlinear_dob", {{"reading", std::string("literal")}}, 1e-3);
  test::IdealPlant plant;  // M_q = I
  plant.disturbance.setLinSpaced(-3.0, 3.0);
  for (int k = 1; k < 500; ++k) {
    const Vec12 expected = (1.0 - std::pow(1.0 + 10.0 * 1e-3, -k)) * plant.disturbance;
    ASSERT_LT((observer->update(plant.advance(1e-3)).leg_torque - expected).cwiseAbs().maxCoeff(), 1e-11) << k;
  }
}

// Why the literal reading is integrated implicitly, and what the header says of its speed.
TEST_F(LegMethodsTest, LiteralReadingIsTooFastForExplicitEulerAtTheKneesButStaysBounded) {
  RobotState state;
  for (int l = 0; l < kLegs; ++l) state.q.segment<3>(3 * l) = Vec3(0.0, 0.886, 1.604) * (l % 2 == 0 ? -1.0 : 1.0);
  FreeFlight flight(model, state, {{1.0}});
  const Vec12 inertia = Eigen::SelfAdjointEigenSolver<Mat12>(flight.terms().M_q).eigenvalues();
  EXPECT_GT(10.0 / inertia.minCoeff(), 1000.0);  // [rad/s]
  EXPECT_LT(10.0 / inertia.maxCoeff(), 150.0);
  EXPECT_GT(1e-3 * 60.0 / inertia.minCoeff(), 2.0) << "explicit Euler would not hold at 1 ms with X = 60";

  flight.push = {Leg::kRF, LegLink::kLower, Vec3(0.01, -0.02, -0.15), Vec3(3.0, -4.0, 2.0)};
  const auto observer = make_observer("nonlinear_dob", {{"reading", std::string("literal")}, {"X", 60.0}}, 1e-3);
  Vec12 last = Vec12::Zero();
  fly(flight, *observer, 1e-3, 0.1, {}, 1.0,
      [&](const FreeFlight& f, const Estimate& estimate, const ModelTerms& start, const ModelTerms&) {
        const double step = (estimate.leg_torque - last).cwiseAbs().maxCoeff();
        last = estimate.leg_torque;
        EXPECT_LT(step, 1.5);
        EXPECT_LT((last - f.disturbance(start)).cwiseAbs().maxCoeff(), 1.5);
      });
  EXPECT_GT(last.norm(), 0.5);
}

class ContactConsistentTest : public LegMethodsTest {
 protected:
  static constexpr PerLeg<bool> kStance{true, false, false, true};  // LF, RH
  static constexpr double kFast = 400.0;                            // [rad/s]

  FreeFlight standing() {
    FreeFlight flight(model, bent_state(), {{kGain}});
    flight.contact_force << 3.0, -4.0, 20.0, Vec3::Zero(), Vec3::Zero(), 2.0, 2.0, 18.0;
    return flight;
  }

  // The estimate after 0.05 s at 400 rad/s, by which a transient is gone.
  Estimate settled(const FreeFlight& flight, double dt) {
    const auto observer = make_observer("contact_consistent", {{"gain_rad_s", kFast}}, dt);
    Estimate last;
    fly(flight, *observer, dt, 0.05, kStance, std::nan(""),
        [&](const FreeFlight& f, const Estimate& estimate, const ModelTerms&, const ModelTerms& now) {
          last = estimate;
          terms = now;
          disturbance = f.disturbance(now);
        });
    return last;
  }

  ModelTerms terms;
  Vec12 disturbance;
};

TEST_F(ContactConsistentTest, DoesNotSeeStanceForcesAndNeedsNoSensorForThem) {
  for (int trial = 0; trial < 5; ++trial) {
    const FreeFlight flight = standing();
    const Estimate coarse = settled(flight, 1e-3);
    const Estimate fine = settled(flight, 0.25e-3);
    const double leg_error = coarse.leg_torque.cwiseAbs().maxCoeff();
    const double com_error = coarse.com_wrench.cwiseAbs().maxCoeff();
    EXPECT_LT(leg_error, 0.1);  // [N m] of up to 6
    EXPECT_LT(com_error, 0.5);  // [N] of 38
    EXPECT_LT(fine.leg_torque.cwiseAbs().maxCoeff(), 0.3 * leg_error + 1e-6) << "first order in the tick";
    EXPECT_LT(fine.com_wrench.cwiseAbs().maxCoeff(), 0.3 * com_error + 1e-6);
  }
}

TEST_F(ContactConsistentTest, DoesNotSeeAPushOnAStandingFoot) {
  FreeFlight flight = standing();
  const Estimate without = settled(flight, 0.25e-3);
  flight.contact_force.head<3>() += Vec3(4.0, -3.0, 5.0);  // disturbance or ground: nobody can tell
  const Estimate with = settled(flight, 0.25e-3);
  EXPECT_LT((with.leg_torque - without.leg_torque).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_LT((with.com_wrench - without.com_wrench).cwiseAbs().maxCoeff(), 0.2);
}

TEST_F(ContactConsistentTest, FindsAPushOnASwingingFootAtTheJointsAndOnTheCom) {
  FreeFlight flight = standing();
  const ModelTerms start = flight.terms();
  const LinkKinematics& shank = start.link[1][2];
  flight.push = {Leg::kRF, LegLink::kLower, shank.R_WL.transpose() * (start.contact[1].p - shank.p_WL),
                 Vec3(3.0, -4.0, 2.0)};
  const Estimate estimate = settled(flight, 0.25e-3);
  const Vec3 arm = leg_point(terms, Leg::kRF, LegLink::kLower, flight.push.p_L).p - terms.p_com;
  EXPECT_LT((estimate.com_wrench.head<3>() - flight.push.force).norm(), 0.05 * flight.push.force.norm());
  EXPECT_LT((estimate.com_wrench.tail<3>() - arm.cross(flight.push.force)).norm(), 0.1);
  EXPECT_LT((estimate.leg_torque - disturbance).norm(), 0.1 * disturbance.norm());
}

// What is left of a push on the knee of a standing leg: its wrench, less that of the foot force with the same torques
// at the joints of the leg. `push` is along W.
Vec6 left_of_a_push_on_the_knee(const ModelTerms& m, Leg leg, const Vec3& push) {
  const LegPoint knee = leg_point(m, leg, LegLink::kLower, Vec3::Zero());
  const LegPoint& foot = m.contact[static_cast<std::size_t>(leg)];
  const Vec3 at_foot = foot.J_q.transpose().partialPivLu().solve(knee.J_q.transpose() * push);
  Vec6 wrench;
  wrench << push - at_foot, (knee.p - m.p_com).cross(push) - (foot.p - m.p_com).cross(at_foot);
  return wrench;
}

TEST_F(ContactConsistentTest, SeesAPushOnAStandingLegAsTheWrenchThatMovesTheRobotAlike) {
  FreeFlight pushed = standing();
  pushed.push = {Leg::kLF, LegLink::kLower, Vec3::Zero(), Vec3(3.0, -4.0, 2.0)};
  double size = 0.0;                    // of the wrench [N, N m]
  const auto errors = [&](double dt) {  // of the wrench [N, N m], at the legs [N m]
    const auto observer = make_observer("contact_consistent", {{"gain_rad_s", kFast}}, dt);
    Vec6 expected = Vec6::Zero();
    Eigen::Vector2d last;
    fly(pushed, *observer, dt, 0.05, kStance, std::nan(""),
        [&](const FreeFlight& flight, const Estimate& estimate, const ModelTerms& start, const ModelTerms&) {
          const Vec6 wrench = left_of_a_push_on_the_knee(start, Leg::kLF, flight.push.force);
          expected += (1.0 - std::exp(-kFast * dt)) * (wrench - expected);
          last << (estimate.com_wrench - expected).norm(), estimate.leg_torque.norm();
          size = expected.norm();
        });
    return last;
  };
  const Eigen::Vector2d coarse = errors(1e-3);
  const Eigen::Vector2d fine = errors(0.25e-3);
  EXPECT_LT(coarse[0], 0.1 * size);
  EXPECT_LT(coarse[1], 2e-3);
  const Eigen::Vector2d without_tick = (4.0 * fine - coarse) / 3.0;  // the errors are of first order in it
  EXPECT_LT(without_tick.cwiseAbs().maxCoeff(), 1e-3 * size);
}

TEST(ContactConsistent, RefusesAStretchedLeg) {
  const auto observer = make_observer("contact_consistent", {}, 1e-3);
  test::IdealPlant plant;
  plant.disturbance.setConstant(1.0);
  EXPECT_EQ(observer->update(plant.advance(1e-3)).status, EstimateStatus::kInvalidInput);
  plant.lever.setIdentity();
  EXPECT_EQ(observer->update(plant.advance(1e-3)).status, EstimateStatus::kOk);
}

}  // namespace
}  // namespace dob::leg_methods_test
