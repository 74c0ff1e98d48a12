// Trials whose controller and observer have a wrong model, are told wrong or late states, or do not know of a load.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/trial.h"
#include "scenarios/loader.h"

namespace dob::imperfect_trial_test {
namespace {

Scenario load(const std::string& name, double duration) {
  Scenario s = load_scenarios({.name = name, .gains = "paper"}).front();
  s.duration = duration;
  return s;
}

TEST(ModelErrorInATrial, ScalesTheMassOfTheControllersModelAndLeavesTheRecordsAndTheSimulatorTrue) {
  Scenario scenario = load("undisturbed", 1.0);
  Trial exact(scenario, load_observer("none", "paper"), 1);
  scenario.model_error.mass_scale = 1.3;
  Trial wrong(scenario, load_observer("none", "paper"), 1);
  EXPECT_NEAR(wrong.model_terms().mass, 1.3 * exact.model_terms().mass, 1e-12);
  EXPECT_LT((wrong.model_terms().M_q - 1.3 * exact.model_terms().M_q).norm(), 1e-12);
  double force = 0.0, exact_force = 0.0;
  for (int k = 0; k < 500; ++k) {
    ASSERT_TRUE(exact.tick());
    ASSERT_TRUE(wrong.tick());
    if (k == 0) {
      EXPECT_EQ(wrong.record().com, exact.record().com);
    }
    if (k < 200) continue;
    for (int l = 0; l < kLegs; ++l) {
      force += wrong.record().foot_force[3 * l + 2] / 300.0;
      exact_force += exact.record().foot_force[3 * l + 2] / 300.0;
    }
  }
  EXPECT_NEAR(exact_force / (exact.model_terms().mass * kGravity), 1.0, 0.05);  // the ground carries the true weight
  EXPECT_NEAR(force / exact_force, 1.0, 0.1);
}

TEST(ModelErrorInATrial, ChangesTheCentreOfMassOfTheModelWithTheTrunkAndNotThatOfTheRecord) {
  Scenario scenario = load("undisturbed", 1.0);
  scenario.model_error.trunk_mass_scale = 1.3;
  Trial trial(scenario, load_observer("none", "paper"), 1);
  const double com_z = trial.model_terms().p_com.z();
  EXPECT_NEAR(trial.model_terms().mass, 21.256 + 0.3 * 9.3, 1e-9);
  ASSERT_TRUE(trial.tick());
  EXPECT_NEAR(trial.record().com.z(), scenario.planner.com_height, 1e-9);  // the true one stands at its height
  EXPECT_GT(com_z, trial.record().com.z() + 0.001);                        // the trunk is above the legs
}

TEST(ModelErrorInATrial, ScalesRotationalInertiaAndLeavesMassesAndTheirCentre) {
  Scenario scenario = load("undisturbed", 1.0);
  const Trial exact(scenario, load_observer("none", "paper"), 1);
  scenario.model_error.rotational_inertia_scale = 2.0;
  const Trial twice(scenario, load_observer("none", "paper"), 1);
  scenario.model_error.rotational_inertia_scale = 4.0;
  const Trial four_times(scenario, load_observer("none", "paper"), 1);
  EXPECT_EQ(twice.model_terms().mass, exact.model_terms().mass);
  EXPECT_EQ(twice.model_terms().p_com, exact.model_terms().p_com);
  const auto added = (twice.model_terms().I_c - exact.model_terms().I_c).eval();
  EXPECT_GT(added.norm(), 1e-3);
  EXPECT_LT((four_times.model_terms().I_c - exact.model_terms().I_c - 3.0 * added).norm(), 1e-12);
}

// A force on the CoM of -e m g: the observer explains the ground's forces, which carry m g, with (1 + e) m g.
TEST(ModelErrorInATrial, IsAConstantWeightToAnObserverOfTheCentreOfMassAndNothingToTheLegs) {
  Scenario scenario = load("undisturbed", 3.0);
  scenario.gait.pattern.gait = Gait::kStand;
  scenario.path = {{3.0, 0.0, 0.0}};
  scenario.model_error.mass_scale = 1.3;
  Trial trial(scenario, load_observer("momentum_com", "matched"), 1);
  for (int k = 0; k < 3000; ++k) ASSERT_TRUE(trial.tick());
  ASSERT_TRUE(trial.estimate().has_com);
  EXPECT_NEAR(trial.estimate().com_wrench[2], 0.3 * 21.256 * kGravity, 0.5);
  EXPECT_LT(trial.estimate().leg_torque.norm(), 0.1);
}

TEST(SensingInATrial, DelayShowsTheControllerTheStateOfTheTickThatIsTheDelayAgo) {
  Scenario scenario = load("case1/tip_lateral", 1.0);
  scenario.sensing.delay_ticks = 2;
  Trial trial(scenario, load_observer("momentum_com", "matched"), 1);
  std::vector<Vec3> com{trial.model_terms().p_com};  // true ones, of the records
  for (int k = 0; k < 600; ++k) {
    const Vec3 told = trial.model_terms().p_com;
    ASSERT_TRUE(trial.tick());
    if (k == 0) com.clear();
    com.push_back(trial.record().com);
    ASSERT_EQ(told, com[static_cast<std::size_t>(std::max(k - 2, 0))]) << k;
    // Until the first interval has come through there is no estimate.
    ASSERT_EQ(trial.estimate().has_com, k + 1 > 2) << k;
  }
}

TEST(SensingInATrial, NoiseGoesToTheControllerAndNotIntoTheRecord) {
  Scenario scenario = load("undisturbed", 1.0);
  scenario.sensing.base_velocity_noise = 0.05;
  Trial trial(scenario, load_observer("none", "paper"), 1);
  double told = 0.0, recorded = 0.0;
  Vec3 last_velocity = Vec3::Zero(), last_com = Vec3::Zero();
  for (int k = 0; k < 500; ++k) {
    ASSERT_TRUE(trial.tick());
    if (k > 1) {
      told += (trial.model_terms().state.v_WB - last_velocity).squaredNorm() / 498.0;
      recorded += ((trial.record().com - last_com) * 1e3).squaredNorm() / 498.0;
    }
    last_velocity = trial.model_terms().state.v_WB;
    last_com = trial.record().com;
  }
  EXPECT_NEAR(told, 6.0 * 0.05 * 0.05, 0.003);  // differences of white noise on three axes: 2 sigma^2 each
  EXPECT_LT(recorded, 0.1);                     // the true CoM's velocity, below 0.3 m/s: no 50 mm/s per ms
}

TEST(SensingInATrial, ATrialWithoutErrorsIsTheSameToTheBit) {
  Scenario scenario = load("case4_noise", 1.5);
  const ObserverConfig observer = load_observer("momentum_com", "matched");
  const CellResult plain = Trial(scenario, observer, 2).run();
  scenario.model_error.mass_scale = 1.0;
  scenario.sensing.delay_ticks = 0;
  EXPECT_EQ(Trial(scenario, observer, 2).run().state_hash, plain.state_hash);
  scenario.sensing.torque_bias = 1e-9;
  EXPECT_NE(Trial(scenario, observer, 2).run().state_hash, plain.state_hash);
}

TEST(OracleInATrial, KnowsTheForcesAndNotTheErrorOfTheModel) {
  Scenario scenario = load("case1/tip_lateral", 1.0);
  scenario.model_error.trunk_mass_scale = 1.3;
  const CellResult result = Trial(scenario, load_observer("oracle_full", "matched"), 1).run();
  EXPECT_EQ(*result.metrics.joint_estimate_rmse_Nm, 0.0);
}

TEST(PayloadInATrial, IsAnOnsetAndATrueForceOnTheTrunkShiftedByTheSeed) {
  for (const int seed : {1, 2}) {
    Scenario scenario = load("payload/front_left", 1.5);
    scenario.payloads.at(0).start_s = 1.0;
    Trial trial(scenario, load_observer("oracle_full", "matched"), seed);
    double onset = -1.0, latest_change = -1.0;
    while (trial.time() < 1.5) {
      ASSERT_TRUE(trial.tick());
      if (trial.record().disturbance_onset) onset = trial.record().t;
      if (onset < 0.0) {
        ASSERT_EQ(trial.estimate().com_wrench, Vec6::Zero());
      } else {
        ASSERT_NEAR(trial.estimate().com_wrench[2], -3.0 * kGravity, 1e-9);
        ASSERT_TRUE(trial.record().disturbance_active);
        latest_change = trial.record().t;
      }
    }
    EXPECT_GT(latest_change, onset);
    if (seed == 1) {
      EXPECT_NEAR(onset, 1.0, 1e-9);
    }
    if (seed == 2) {
      EXPECT_GT(onset, 1.001);
    }
  }
}

}  // namespace
}  // namespace dob::imperfect_trial_test
