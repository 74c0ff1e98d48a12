#include <cstdio>

#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/micro/samples.h"

int main(int argc, char** argv) {
  try {
    const dob::BuildInfo build = dob::build_info();
    benchmark::AddCustomContext("version", build.version + " " + build.commit);
    benchmark::AddCustomContext("compiler", build.compiler + " " + build.flags);
    dob::micro::add_model_benchmarks();
    dob::micro::add_observer_benchmarks();
    dob::micro::add_planner_benchmarks();
    dob::micro::add_qp_benchmarks();
    dob::micro::add_trial_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
  } catch (const std::exception& error) {
    fmt::print(stderr, "dobbench_micro: {}\n", error.what());
    return 2;
  }
}
