#include "bench/micro/samples.h"
#include "observers/factory.h"
#include "scenarios/loader.h"
#include "test/support/wbc_instances.h"

namespace dob::micro {
namespace {

void observer_update(benchmark::State& state, const std::string& name) {
  std::mt19937_64 random(1);
  const std::vector<test::WbcInstance> run = test::recorded_instances(0.6, random);
  const ObserverConfig config = load_observer(name, "matched");
  const auto observer = make_observer(config.observer, config.options, SimOptions{}.dt);
  observer->reset(run.front().m);
  const Vec12 torque = Vec12::Constant(1.0);
  const Vec12 force = Vec12::Constant(2.0);
  measure(state, [&](long i) {
    const auto k = static_cast<std::size_t>(i) % (run.size() - 1);
    benchmark::DoNotOptimize(observer->update({run[k].m, run[k + 1].m, torque, force, run[k].stance, SimOptions{}.dt}));
  });
}

}  // namespace

void add_observer_benchmarks() {
  for (const ObserverInfo& info : built_in_observers()) {
    const std::string name(info.name);
    benchmark::RegisterBenchmark(("observer_update/" + name).c_str(), [name](benchmark::State& state) {
      observer_update(state, name);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace dob::micro
