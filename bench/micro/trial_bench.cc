#include "bench/micro/samples.h"
#include "bench/trial.h"
#include "scenarios/loader.h"
#include "test/support/wbc_instances.h"

namespace dob::micro {
namespace {

Scenario scenario(const std::string& name) {
  return load_scenarios({.name = name, .gains = "", .planner = "", .overrides = {}}).front();
}

// ODE alone: the torques of a recorded trot, replayed in the same world from the same state.
void ode_step(benchmark::State& state) {
  const Scenario s = scenario("undisturbed");
  const RobotDescription robot = load_robot(s.robot.urdf, s.robot.forward);
  Trial trial(s, load_observer("none", "paper"), 1);
  Simulator simulator(robot, s.terrain, s.sim);
  const RobotState initial = trial.model_terms().state;
  std::vector<Vec12> torques;
  while (trial.time() < 2.0 && trial.tick()) torques.push_back(trial.record().joint_torque);
  measure(
      state,
      [&](long i) {
        const auto k = static_cast<std::size_t>(i) % torques.size();
        if (k == 0) simulator.reset(initial);
        benchmark::DoNotOptimize(simulator.step(torques[k]));
      },
      1);
}

// Gait, planner, QP when due and torques of a recorded trot: everything of a tick but model, observer and simulator.
void control_tick(benchmark::State& state) {
  const Scenario s = scenario("undisturbed");
  const ObserverConfig observer = load_observer("momentum", "matched");
  Trial trial(s, observer, 1);
  std::vector<ModelTerms> terms;
  std::vector<Vec12> forces;
  Vec12 force = Vec12::Zero();
  while (trial.time() < 2.0) {
    terms.push_back(trial.model_terms());
    forces.push_back(force);
    if (!trial.tick()) break;
    force = trial.record().foot_force;
  }
  LocomotionController controller({s.gait, s.planner, s.controller, observer.routing}, ReferencePath(s.path), s.sim.dt);
  DisturbanceEstimate estimate;
  estimate.has_legs = true;
  measure(
      state,
      [&](long i) {
        const auto k = static_cast<std::size_t>(i) % terms.size();
        if (k == 0) controller.reset(terms[0]);
        benchmark::DoNotOptimize(controller.update(terms[k], forces[k], estimate));
      },
      1);
}

void trial_case(benchmark::State& state, const std::string& name) {
  const Scenario s = scenario(name);
  const ObserverConfig observer = load_observer("momentum", "matched", s.sim.dt);
  for (auto _ : state) {
    Trial trial(s, observer, 1);
    benchmark::DoNotOptimize(trial.run());
  }
}

}  // namespace

void add_trial_benchmarks() {
  benchmark::RegisterBenchmark("control_tick", control_tick)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("ode_step", ode_step)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("trial/case1", [](benchmark::State& s) { trial_case(s, "case1/knee_lateral"); })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

}  // namespace dob::micro
