// The whole-body quadratic problem: reduction from the model terms and solve, as in a tick with a due QP and an
// estimate to compensate. Instances are recorded from trots or drawn, untimed.
#include <algorithm>
#include <functional>
#include <memory>

#include "bench/micro/samples.h"
#include "controller/wbc_solver.h"
#include "controller/whole_body_qp.h"
#include "test/controller/full_wbc_problem.h"
#include "test/oracles/alglib_qp.h"
#include "test/support/wbc_instances.h"

namespace dob::micro {
namespace {

using test::WbcInstance;
using Instances = std::vector<WbcInstance>;

constexpr std::size_t kInstances = 1000;

Instances with_standing(const Instances& all, int feet) {
  Instances chosen;
  for (const WbcInstance& in : all) {
    const bool wanted = std::count(in.stance.begin(), in.stance.end(), true) == feet;
    if (wanted && chosen.size() < kInstances) chosen.push_back(in);
  }
  return chosen;
}

// In the order of the run, with the estimates of the observer.
Instances trot(int feet) {
  return with_standing(test::recorded_instances(8.0), feet);
}
Instances crawl() {
  return with_standing(test::recorded_instances(10.0, "crawl/tip_lateral"), 3);
}

struct Phase {
  const char* name;
  std::function<Instances()> instances;
};

const std::vector<Phase>& phases() {
  static const std::vector<Phase> all{
      {"stance", [] { return trot(4); }},
      {"trot_swing", [] { return trot(2); }},
      {"crawl_swing", crawl},
  };
  return all;
}

// The same instances for slippery ground and weak motors, so that friction and torque rows are active.
WbcOptions tight() {
  WbcOptions options;
  options.friction = 0.15;
  options.torque_limit = 25.0;
  options.min_normal_force = 5.0;
  return options;
}

class Pipeline {
 public:
  explicit Pipeline(const WbcOptions& options) : qp_(options) {}

  QpStatus solve(const WbcInstance& in, const WbcActiveSet& guess) {
    const PerLeg<LegPoint> points = task_points(in.m, in.stance);
    TaskJacobian J;
    if (!J.factorize(in.m, points)) return QpStatus::kSingular;
    const Compensation c = compensate(in.m, points, J, in.stance, in.estimate, Routing{}, true);
    qp_.assemble(in.m, in.stance, in.reference, c, points, J);
    solver_->solve(qp_.problem(), guess, solution_);
    benchmark::DoNotOptimize(solution_);
    return solution_.status;
  }
  const WbcQpSolution& solution() const { return solution_; }
  const WbcProblem& problem() const { return qp_.problem(); }

 private:
  WholeBodyQp qp_;
  std::unique_ptr<WbcQpSolver> solver_ = make_wbc_solver();
  WbcQpSolution solution_;
};

void cold(benchmark::State& state, const std::function<Instances()>& instances, const WbcOptions& options) {
  const Instances run = instances();
  Pipeline pipeline(options);
  double active = 0.0;
  for (const WbcInstance& in : run) {
    pipeline.solve(in, {});
    active += pipeline.solution().active.size / static_cast<double>(run.size());
  }
  WbcInstance now;
  measure_instances(
      state, run.size(), [&](std::size_t i) { now = run[i]; }, [&](std::size_t) { pipeline.solve(now, {}); });
  state.counters["instances"] = static_cast<double>(run.size());
  state.counters["active_rows"] = active;
}

// Each instance starts from the rows active in the one before, as along a run.
void warm(benchmark::State& state, const Phase& phase) {
  const Instances run = phase.instances();
  Pipeline pipeline{WbcOptions{}};
  WbcInstance now;
  WbcActiveSet guess;
  measure_instances(
      state, run.size(),
      [&](std::size_t i) {
        if (run[i].stance != now.stance) guess.size = 0;
        now = run[i];
      },
      [&](std::size_t) {
        pipeline.solve(now, guess);
        guess = pipeline.solution().active;
      });
  state.counters["instances"] = static_cast<double>(run.size());
}

using AlglibProblems = std::vector<std::unique_ptr<test::AlglibQp>>;

// ALGLIB solving problems that are already loaded; its allocations are its own.
void alglib(benchmark::State& state, const Phase& phase, const test::AlglibAul& settings,
            const std::function<test::DenseQp(const WbcInstance&)>& load) {
  const Instances run = phase.instances();
  AlglibProblems problems;
  for (std::size_t i = 0; i < run.size() && problems.size() < 32; i += 5) {
    problems.push_back(std::make_unique<test::AlglibQp>(load(run[i])));
  }
  measure_instances(
      state, problems.size(), [](std::size_t) {},
      [&](std::size_t i) { benchmark::DoNotOptimize(problems[i]->solve_aul(settings)); });
  state.counters["instances"] = static_cast<double>(problems.size());
}

// The paper's formulation, 30 variables.
test::DenseQp printed(const WbcInstance& in) {
  return test::full_problem(in, WbcOptions{}, Routing{}).as_dense();
}

// The reduced one, 12 variables.
test::DenseQp reduced(const WbcInstance& in) {
  Pipeline pipeline{WbcOptions{}};
  pipeline.solve(in, {});
  return test::dense(pipeline.problem());
}

}  // namespace

void add_qp_benchmarks() {
  const auto add = [](const std::string& name, auto function) {
    benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMicrosecond);
  };
  for (const Phase& phase : phases()) {
    const std::string prefix = std::string("qp/") + phase.name;
    add(prefix + "/cold", [&phase](benchmark::State& s) { cold(s, phase.instances, WbcOptions{}); });
    add(prefix + "/warm", [&phase](benchmark::State& s) { warm(s, phase); });
    add(prefix + "/cold_active", [&phase](benchmark::State& s) { cold(s, phase.instances, tight()); });
    add(prefix + "/alglib_paper", [&phase](benchmark::State& s) { alglib(s, phase, test::kAlglibPaper, printed); });
    add(prefix + "/alglib_accurate",
        [&phase](benchmark::State& s) { alglib(s, phase, test::kAlglibAccurate, printed); });
    add(prefix + "/alglib_reduced", [&phase](benchmark::State& s) { alglib(s, phase, test::kAlglibPaper, reduced); });
  }
}

}  // namespace dob::micro
