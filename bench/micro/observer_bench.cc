#include "bench/micro/samples.h"
#include "observers/factory.h"
#include "observers/momentum_gains.h"
#include "scenarios/loader.h"
#include "test/support/wbc_instances.h"

namespace dob::micro {
namespace {

void observer_update(benchmark::State& state, const std::string& name, const ObserverOptions& options) {
  std::mt19937_64 random(1);
  const std::vector<test::WbcInstance> run = test::recorded_instances(0.6, random);
  const auto observer = make_observer(name, options, SimOptions{}.dt);
  observer->reset(run.front().m);
  const Vec12 torque = Vec12::Constant(1.0);
  const Vec12 force = Vec12::Constant(2.0);
  measure(state, [&](long i) {
    const auto k = static_cast<std::size_t>(i) % (run.size() - 1);
    benchmark::DoNotOptimize(observer->update({run[k].m, run[k + 1].m, torque, force, run[k].stance, SimOptions{}.dt}));
  });
}

void add(const std::string& label, const std::string& name, const ObserverOptions& options) {
  benchmark::RegisterBenchmark(("observer_update/" + label).c_str(), [=](benchmark::State& state) {
    observer_update(state, name, options);
  })->Unit(benchmark::kMicrosecond);
}

// All r poles at -w.
ObserverOptions momentum_of_order(int r) {
  constexpr double w = 30.0;   // [rad/s]
  std::vector<double> c{1.0};  // (s + w)^i in ascending powers
  for (int i = 0; i < r; ++i) {
    c.push_back(0.0);
    for (std::size_t j = c.size() - 1; j > 0; --j) c[j] = c[j - 1] + w * c[j];
    c[0] *= w;
  }
  c.pop_back();
  return {{"gains", gains_from_coefficients(c).K}};
}

}  // namespace

// Each at the gains of the profile "matched"; and momentum at the orders that the paper compares.
void add_observer_benchmarks() {
  for (const ObserverInfo& info : built_in_observers()) {
    const std::string name(info.name);
    add(name, name, load_observer(name, "matched").options);
  }
  for (int r = 1; r <= 5; ++r) add("momentum/r" + std::to_string(r), "momentum", momentum_of_order(r));
}

}  // namespace dob::micro
