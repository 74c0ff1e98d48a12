// The control tick (model, observer, gait, planner, QP, torques) stays off the heap. The simulator is not part of it.
#include <gtest/gtest.h>

#include "bench/trial.h"
#include "observers/factory.h"
#include "scenarios/loader.h"
#include "test/support/allocation_counter.h"

namespace dob {
namespace {

TEST(ControlTick, AllocatesNothingAfterReset) {
  const Scenario scenario =
      load_scenarios({.name = "case1/tip_lateral", .gains = "paper", .planner = "", .overrides = {}}).front();
  const ObserverConfig config = load_observer("momentum", "matched");
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
  for (int k = 0; k < 3000; ++k) {
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
  EXPECT_GE(solved, 1200);  // 400 Hz over 3 s
}

}  // namespace
}  // namespace dob
