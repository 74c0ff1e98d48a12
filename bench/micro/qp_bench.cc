#include <memory>

#include "bench/micro/samples.h"
#include "controller/goldfarb_idnani.h"
#include "controller/whole_body_qp.h"
#include "test/oracles/alglib_qp.h"
#include "test/support/wbc_instances.h"

namespace dob::micro {
namespace {

using Solver = GoldfarbIdnani<kWbcVariables, kWbcMaxRows>;

// Instances of a real trot with the given number of standing feet.
std::vector<test::WbcInstance> phase(int standing) {
  std::mt19937_64 random(1);
  std::vector<test::WbcInstance> chosen;
  for (const test::WbcInstance& in : test::recorded_instances(3.0, random)) {
    if (std::count(in.stance.begin(), in.stance.end(), true) == standing) chosen.push_back(in);
  }
  return chosen;
}

// Reduction and solve from the model terms, as in a tick with a due QP and an estimate to compensate.
class Pipeline {
 public:
  const WbcProblem& assemble(const test::WbcInstance& in) {
    const PerLeg<LegPoint> points = task_points(in.m, in.stance);
    inverse_jacobian_joints(in.m, points, inverse_);
    const Compensation c = compensate(in.m, points, inverse_, in.stance, in.estimate, routing_, true);
    qp_.assemble(in.m, in.stance, in.reference, c, points, inverse_);
    return qp_.problem();
  }

 private:
  Routing routing_;
  WholeBodyQp qp_{WbcOptions{}};
  Mat12 inverse_;
};

void qp_cold(benchmark::State& state, int standing) {
  const std::vector<test::WbcInstance> run = phase(standing);
  Pipeline pipeline;
  Solver solver;
  WbcQpSolution solution;
  measure(state, [&](long i) {
    solver.solve(pipeline.assemble(run[static_cast<std::size_t>(i) % run.size()]), solution);
    benchmark::DoNotOptimize(solution);
  });
}

void qp_warm(benchmark::State& state, int standing) {
  const std::vector<test::WbcInstance> run = phase(standing);
  Pipeline pipeline;
  Solver solver;
  WbcQpSolution solution;
  QpActiveSet<kWbcVariables> active;
  measure(state, [&](long i) {
    solver.solve(pipeline.assemble(run[static_cast<std::size_t>(i) % run.size()]), active, solution);
    active = solution.active;
    benchmark::DoNotOptimize(solution);
  });
}

// ALGLIB on the same reduced problems, loading untimed; its allocations are its own.
void qp_alglib(benchmark::State& state, int standing, const test::AlglibAul& settings) {
  const std::vector<test::WbcInstance> run = phase(standing);
  Pipeline pipeline;
  std::vector<std::unique_ptr<test::AlglibQp>> problems;
  for (std::size_t i = 0; i < run.size() && problems.size() < 64; i += 5) {
    problems.push_back(std::make_unique<test::AlglibQp>(test::dense(pipeline.assemble(run[i]))));
  }
  measure(
      state,
      [&](long i) {
        benchmark::DoNotOptimize(problems[static_cast<std::size_t>(i) % problems.size()]->solve_aul(settings));
      },
      1);
}

}  // namespace

void add_qp_benchmarks() {
  const auto add = [](const std::string& name, auto function) {
    benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMicrosecond);
  };
  for (const auto& [name, standing] : {std::pair{"stance", 4}, std::pair{"trot_swing", 2}}) {
    const std::string prefix = std::string("qp/") + name;
    const int feet = standing;
    add(prefix + "/cold", [feet](benchmark::State& s) { qp_cold(s, feet); });
    add(prefix + "/warm", [feet](benchmark::State& s) { qp_warm(s, feet); });
    add(prefix + "/alglib_paper", [feet](benchmark::State& s) { qp_alglib(s, feet, test::kAlglibPaper); });
    add(prefix + "/alglib_accurate", [feet](benchmark::State& s) { qp_alglib(s, feet, test::kAlglibAccurate); });
  }
}

}  // namespace dob::micro
