#include "bench/micro/samples.h"
#include "robot/model.h"
#include "scenarios/loader.h"
#include "test/oracles/mujoco_robot.h"
#include "test/support/random_state.h"

namespace dob::micro {
namespace {

constexpr std::size_t kStates = 256;

struct ModelInputs {
  Scenario scenario = load_scenarios({.name = "undisturbed", .gains = "", .planner = "", .overrides = {}}).front();
  RobotDescription robot = load_robot(scenario.robot.urdf, scenario.robot.forward);
  std::vector<RobotState> states;

  ModelInputs() {
    std::mt19937_64 random(1);
    for (std::size_t i = 0; i < kStates; ++i) states.push_back(test::random_state(random));
  }
  const RobotState& state(long i) const { return states[static_cast<std::size_t>(i) % kStates]; }
};

void model_tick(benchmark::State& state) {
  const ModelInputs inputs;
  const Model model(inputs.robot);
  ModelTerms terms;
  measure(state, [&](long i) {
    model.compute(inputs.state(i), terms);
    benchmark::DoNotOptimize(terms);
  });
  state.counters["lanes"] = kLanes;  // 4: built with DOB_FAST_MODEL
}

void model_tick_mujoco(benchmark::State& state) {
  const ModelInputs inputs;
  oracle::MujocoRobot mujoco(inputs.scenario.robot.urdf, inputs.robot);
  measure(state, [&](long i) {
    mujoco.set_state(inputs.state(i));
    mujoco.compute_raw();
  });
}

}  // namespace

void add_model_benchmarks() {
  benchmark::RegisterBenchmark("model_tick", model_tick)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("model_tick/mujoco", model_tick_mujoco)->Unit(benchmark::kMicrosecond);
}

}  // namespace dob::micro
