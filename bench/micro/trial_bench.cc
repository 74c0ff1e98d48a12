#include "bench/micro/samples.h"
#include "bench/trial.h"
#include "scenarios/loader.h"

namespace dob::micro {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Scenario scenario(const std::string& name) {
  return load_scenarios({.name = name, .gains = "", .planner = "", .overrides = {}}).front();
}

// What the simulator was told in a trial: enough to step ODE through it again with nothing around it.
struct Recording {
  RobotState initial, last;
  std::vector<Vec12> torques;        // [N m] applied, one per tick
  std::vector<AppliedForce> forces;  // of all ticks
  std::vector<std::size_t> end;      // of each tick's forces

  std::size_t ticks() const { return torques.size(); }
  std::span<const AppliedForce> forces_of(std::size_t tick) const {
    const std::size_t begin = tick == 0 ? 0 : end[tick - 1];
    return std::span(forces).subspan(begin, end[tick] - begin);
  }
};

Recording record(const Scenario& s, const ObserverConfig& observer) {
  Trial trial(s, observer, 1);
  Recording r;
  r.initial = trial.model_terms().state;
  trial.run([&](const TickRecord& tick) {
    r.torques.push_back(tick.joint_torque);
    const auto forces = trial.forces();
    r.forces.insert(r.forces.end(), forces.begin(), forces.end());
    r.end.push_back(r.forces.size());
  });
  r.last = trial.model_terms().state;
  return r;
}

Simulator simulator_of(const Scenario& s) {
  return Simulator(load_robot(s.robot.urdf, s.robot.forward), s.terrain, s.sim);
}

// The scenario's first two seconds.
Scenario beginning(const std::string& name) {
  Scenario s = scenario(name);
  s.duration = 2.0;
  return s;
}

// ODE alone: the torques of a recorded trot, replayed in the same world from the same state.
void ode_step(benchmark::State& state) {
  const Scenario s = beginning("undisturbed");
  const Recording recording = record(s, load_observer("none", "paper"));
  Simulator simulator = simulator_of(s);
  measure(
      state,
      [&](long i) {
        const auto k = static_cast<std::size_t>(i) % recording.ticks();
        if (k == 0) simulator.reset(recording.initial);
        benchmark::DoNotOptimize(simulator.step(recording.torques[k]));
      },
      1);
}

// Median of single steps of the recording, three times through [us].
double ode_step_p50_us(const Scenario& s, const Recording& recording) {
  Simulator simulator = simulator_of(s);
  std::vector<double> samples;
  for (std::size_t i = 0; i < 3 * recording.ticks(); ++i) {
    const std::size_t k = i % recording.ticks();
    if (k == 0) simulator.reset(recording.initial);
    const auto start = Clock::now();
    benchmark::DoNotOptimize(simulator.step(recording.torques[k], recording.forces_of(k)));
    samples.push_back(1e6 * seconds_since(start));
  }
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::nth_element(samples.begin(), middle, samples.end());
  return *middle;
}

// Gait, planner, QP when due, compensation and torques of a recorded trot under case 1's force at the foot tip:
// everything of a tick but model, observer and simulator.
// Beside it, a step of ODE in the same run.
void control_tick(benchmark::State& state) {
  const Scenario s = beginning("case1/tip_lateral");
  const ObserverConfig observer = load_observer("momentum_com", "matched");
  Trial trial(s, observer, 1);
  std::vector<ModelTerms> terms;
  std::vector<Vec12> forces;
  std::vector<DisturbanceEstimate> estimates;
  Vec12 force = Vec12::Zero();
  while (trial.time() < s.duration) {
    terms.push_back(trial.model_terms());
    forces.push_back(force);
    const Estimate& e = trial.estimate();
    estimates.push_back({e.has_legs, e.leg_torque, e.has_com, e.com_wrench});
    if (!trial.tick()) break;
    force = trial.record().foot_force;
  }
  LocomotionController controller({s.gait, s.planner, s.controller, observer.routing}, ReferencePath(s.path), s.sim.dt);
  measure(
      state,
      [&](long i) {
        const auto k = static_cast<std::size_t>(i) % terms.size();
        if (k == 0) controller.reset(terms[0]);
        benchmark::DoNotOptimize(controller.update(terms[k], forces[k], estimates[k]));
      },
      1);
  state.counters["ode_step_p50_us"] = ode_step_p50_us(s, record(s, observer));
}

// A whole trial, and ODE alone through the same torques and forces: how much is spent on anything but physics. The two
// take turns in slices, so that both meet the same machine: apart, its other load made the ratio 1.17 or 1.47.
void trial_case(benchmark::State& state, const std::string& name) {
  constexpr std::size_t kSlice = 200;  // [ticks]
  const Scenario s = scenario(name);
  const ObserverConfig observer = load_observer("momentum_com", "matched", s.sim.dt);
  const Recording recording = record(s, observer);
  double trial_s = 0.0;
  double ode_s = 0.0;
  for (auto _ : state) {
    Trial trial(s, observer, 1);
    Simulator simulator = simulator_of(s);
    simulator.reset(recording.initial);
    std::size_t replayed = 0;
    double replay_s = 0.0;
    const auto replay_to = [&](std::size_t end) {
      const auto start = Clock::now();
      for (; replayed < end; ++replayed) {
        benchmark::DoNotOptimize(simulator.step(recording.torques[replayed], recording.forces_of(replayed)));
      }
      replay_s += seconds_since(start);
    };
    std::size_t ticks = 0;
    const auto start = Clock::now();
    trial.run([&](const TickRecord&) {
      if (++ticks % kSlice == 0) replay_to(ticks);
    });
    const double both_s = seconds_since(start);
    state.SetIterationTime(both_s - replay_s);
    trial_s += both_s - replay_s;
    replay_to(ticks);
    ode_s += replay_s;
    if (ticks != recording.ticks() || simulator.state().q != recording.last.q ||
        simulator.state().p_WB != recording.last.p_WB) {
      state.SkipWithError("the replay of the trial's torques and forces ended elsewhere");
      break;
    }
  }
  state.counters["ode_share"] = ode_s / trial_s;
  state.counters["ratio_to_ode"] = trial_s / ode_s;
  state.counters["real_time_factor"] =
      static_cast<double>(state.iterations()) * static_cast<double>(recording.ticks()) * s.sim.dt / trial_s;
}

}  // namespace

void add_trial_benchmarks() {
  benchmark::RegisterBenchmark("control_tick", control_tick)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("ode_step", ode_step)->Unit(benchmark::kMicrosecond);
  for (const auto& [name, full_name] :
       {std::pair{"undisturbed", "undisturbed"}, {"case1", "case1/knee_lateral"}, {"case4", "case4"}}) {
    const std::string scenario_name = full_name;
    benchmark::RegisterBenchmark((std::string("trial/") + name).c_str(),
                                 [scenario_name](benchmark::State& s) { trial_case(s, scenario_name); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->UseManualTime();
  }
}

}  // namespace dob::micro
