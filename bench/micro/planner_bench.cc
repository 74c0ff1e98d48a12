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

  explicit RecordedPlanning(const std::string& name)
      : scenario(load_scenarios({.name = name, .gains = "", .planner = "", .overrides = {}}).front()) {
    Trial trial(scenario, load_observer("momentum", "matched"), 1);
    while (trial.time() < scenario.duration) {
      const double t = trial.time();
      const ModelTerms m = trial.model_terms();
      if (!trial.tick()) break;
      if (trial.controller().gait().footstep_begins) footsteps.push_back({t, trial.controller().gait(), m});
    }
  }
};

// Every instance by itself: reset, then the footstep, so that no plan depends on the one before it in the benchmark.
void planner_footstep(benchmark::State& state, const std::string& name, PlannerKind kind) {
  const RecordedPlanning run(name);
  PlannerOptions options = run.scenario.planner;
  options.kind = kind;
  MotionPlanner planner(options, run.scenario.gait, ReferencePath(run.scenario.path));
  int active = 0;
  int most_active = 0;
  for (const auto& tick : run.footsteps) {
    planner.reset(tick.m);
    planner.update(tick.t, tick.gait, tick.m);
    active += planner.zmp_report().active_rows;
    most_active = std::max(most_active, planner.zmp_report().active_rows);
  }
  measure_instances(
      state, run.footsteps.size(), [&](std::size_t i) { planner.reset(run.footsteps[i].m); },
      [&](std::size_t i) {
        const auto& tick = run.footsteps[i];
        benchmark::DoNotOptimize(planner.update(tick.t, tick.gait, tick.m));
      });
  state.counters["active_zmp_rows_mean"] = static_cast<double>(active) / static_cast<double>(run.footsteps.size());
  state.counters["active_zmp_rows_max"] = most_active;
}

}  // namespace

void add_planner_benchmarks() {
  const auto add = [](const std::string& name, const std::string& scenario, PlannerKind kind) {
    benchmark::RegisterBenchmark(name.c_str(), [scenario, kind](benchmark::State& s) {
      planner_footstep(s, scenario, kind);
    })->Unit(benchmark::kMicrosecond);
  };
  // Random pushes with the legs' estimate only: what it does not see throws the CoM about, and ZMP rows become active.
  add("planner_footstep", "case4", PlannerKind::kZmp);
  add("planner_footstep/spline", "case4", PlannerKind::kSpline);
  add("planner_footstep/crawl", "crawl/knee_lateral", PlannerKind::kZmp);
}

}  // namespace dob::micro
