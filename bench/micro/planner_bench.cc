#include "bench/micro/samples.h"
#include "bench/trial.h"
#include "scenarios/loader.h"

namespace dob::micro {
namespace {

// What the planner got at every tick of a run, and at which of them it planned a footstep.
struct RecordedPlanning {
  struct Tick {
    double t;
    GaitState gait;
    ModelTerms m;
  };
  Scenario scenario;
  std::vector<Tick> footsteps;

  // Pushed, so that ZMP rows become active.
  explicit RecordedPlanning(const std::string& name) {
    scenario = load_scenarios({.name = name, .gains = "", .planner = "", .overrides = {}}).front();
    Trial trial(scenario, load_observer("momentum", "matched"), 1);
    while (trial.time() < 12.0) {
      const double t = trial.time();
      const ModelTerms m = trial.model_terms();
      if (!trial.tick()) break;
      if (trial.controller().gait().footstep_begins) footsteps.push_back({t, trial.controller().gait(), m});
    }
  }
};

void planner_footstep(benchmark::State& state, const std::string& name, PlannerKind kind) {
  const RecordedPlanning run(name);
  PlannerOptions options = run.scenario.planner;
  options.kind = kind;
  MotionPlanner planner(options, run.scenario.gait, ReferencePath(run.scenario.path));
  planner.reset(run.footsteps.front().m);
  int active = 0;
  long calls = 0;
  measure(
      state,
      [&](long i) {
        const auto& tick = run.footsteps[static_cast<std::size_t>(i) % run.footsteps.size()];
        benchmark::DoNotOptimize(planner.update(tick.t, tick.gait, tick.m));
        active += planner.zmp_report().active_rows;
        ++calls;
      },
      1);
  state.counters["active_zmp_rows"] = static_cast<double>(active) / static_cast<double>(calls);
}

}  // namespace

void add_planner_benchmarks() {
  const auto add = [](const std::string& name, const std::string& scenario, PlannerKind kind) {
    benchmark::RegisterBenchmark(name.c_str(), [scenario, kind](benchmark::State& s) {
      planner_footstep(s, scenario, kind);
    })->Unit(benchmark::kMicrosecond);
  };
  add("planner_footstep", "case1/tip_lateral", PlannerKind::kZmp);
  add("planner_footstep/spline", "case1/tip_lateral", PlannerKind::kSpline);
  add("planner_footstep/crawl", "crawl/knee_lateral", PlannerKind::kZmp);
}

}  // namespace dob::micro
