// The control tick (model, observer, gait, planner, QP, torques) stays off the heap. The simulator is not part of it.
#include <cmath>

#include <gtest/gtest.h>

#include "bench/trial.h"
#include "observers/factory.h"
#include "scenarios/loader.h"
#include "sim/sensing.h"
#include "test/support/allocation_counter.h"

namespace dob::tick_allocation_test {
namespace {

struct Walk {
  const char* name;
  const char* scenario;
  const char* planner;
  double duration;  // [s]
};

class ControlTick : public ::testing::TestWithParam<Walk> {};

TEST_P(ControlTick, AllocatesNothingAfterReset) {
  const Scenario scenario = load_scenarios({.name = GetParam().scenario, .planner = GetParam().planner}).front();
  const ObserverConfig config = load_observer("momentum_com", "matched");
  const Model model(load_robot(scenario.robot.urdf, scenario.robot.forward));
  const auto observer = make_observer(config.observer, config.options, scenario.sim.dt);
  LocomotionController controller({scenario.gait, scenario.planner, scenario.controller, config.routing},
                                  ReferencePath(scenario.path), scenario.sim.dt);
  Trial trial(scenario, config, 1);  // supplies states, torques and forces of a real trot
  auto start = std::make_unique<ModelTerms>(trial.model_terms());
  auto now = std::make_unique<ModelTerms>();
  observer->reset(*start);
  controller.reset(*start);
  DisturbanceEstimate estimate;
  Vec12 force = Vec12::Zero();
  int solved = 0;
  const long ticks = std::lround(GetParam().duration / scenario.sim.dt);
  for (long k = 0; k < ticks; ++k) {
    const RobotState before = trial.model_terms().state;
    ASSERT_TRUE(trial.tick());
    const test::AllocationCounter counter;
    model.compute(before, *start);
    const WbcTick& tick = controller.update(*start, force, estimate);
    force = trial.record().foot_force;
    model.compute(trial.model_terms().state, *now);
    const Estimate e = observer->update({*start, *now, trial.record().joint_torque, force, controller.stance(), 1e-3});
    estimate = {e.has_legs, e.leg_torque, e.has_com, e.com_wrench};
    solved += tick.event == QpEvent::kSolved ? 1 : 0;
    ASSERT_EQ(counter.count(), 0) << "tick " << k;
  }
  EXPECT_GE(solved, 0.4 * static_cast<double>(ticks));  // 400 Hz of 1 kHz, and more at changes of the stance set
}

// Shadows are part of the trial's tick; the simulator, which is too, is not counted.
TEST(ShadowTick, AllocatesNothing) {
  const Scenario scenario = load_scenarios({.name = "case1/tip_lateral"}).front();
  const ObserverConfig config = load_observer("momentum_com", "matched");
  Trial trial(scenario, config, 1);  // supplies states, torques and forces
  Recorder recorder(load_robot(scenario.robot.urdf, scenario.robot.forward), scenario);
  Shadows shadows({config, load_observer("com_wrench", "matched"), load_observer("oracle_full", "matched")},
                  scenario.sim.dt);
  auto start = std::make_unique<ModelTerms>(trial.model_terms());
  shadows.reset(*start);
  for (int k = 0; k < 500; ++k) {
    *start = trial.model_terms();
    ASSERT_TRUE(trial.tick());
    const TickRecord& r = trial.record();
    const ObserverInput input{*start, trial.model_terms(), r.joint_torque, r.foot_force, r.stance, scenario.sim.dt};
    const test::AllocationCounter counter;
    shadows.judge(recorder);
    shadows.update(input, recorder);
    shadows.count();
    ASSERT_EQ(counter.count(), 0) << "tick " << k;
  }
}

TEST(ImperfectSensing, AllocatesNothing) {
  Sensing sensing({.base_velocity_noise = 0.1,
                   .base_angular_velocity_noise = 0.1,
                   .torque_bias = 0.5,
                   .foot_force_bias = 5.0,
                   .delay_ticks = 3},
                  1);
  const test::AllocationCounter counter;
  sensing.reset({});
  long told = 0;
  for (int k = 0; k < 100; ++k) told = sensing.measure({}, {}, {true, true, false, true}).tick;
  EXPECT_EQ(counter.count(), 0);
  EXPECT_EQ(told, 97);
}

// Once a whole trial of case 1, then the other planners and the crawl.
INSTANTIATE_TEST_SUITE_P(Walks, ControlTick,
                         ::testing::Values(Walk{"WholeTrial", "case1/tip_lateral", "zmp", 45.8},
                                           Walk{"Spline", "case1/tip_lateral", "spline", 3.0},
                                           Walk{"PaperSplit", "case1/tip_lateral", "paper_split", 3.0},
                                           Walk{"Crawl", "crawl/tip_lateral", "zmp", 5.0}),
                         [](const auto& walk) { return walk.param.name; });

}  // namespace
}  // namespace dob::tick_allocation_test
