// The whole loop in a program of one's own: observer, controller and simulator for five seconds of a scenario.
//   usage: DOBBENCH_SCENARIOS=PREFIX/share/dobbench/scenarios one_trial OBSERVER
#include <bench/trial.h>
#include <cstdio>
#include <exception>
#include <scenarios/loader.h>

namespace {

void run(const char* observer) {
  const dob::Scenario scenario =
      dob::load_scenarios({.name = "push_trunk/constant_lateral", .overrides = {"duration_s=5"}}).at(0);
  dob::Trial trial(scenario, dob::load_observer(observer, "tuned"), 1);
  const dob::CellResult result = trial.run();
  std::printf("%s: %.1f s, CoM error at most %.2f mm\n", observer, trial.time(),
              1e3 * result.metrics.com_error_max_m.value());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: one_trial OBSERVER\n");
    return 2;
  }
  try {
    run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "one_trial: %s\n", error.what());
    return 2;
  }
}
