// How a command's work is shared among processes, and what one of them may take: --jobs, --timeout, --memory-limit.
#pragma once

#include <algorithm>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "bench/number_between.h"

namespace dob {

// `Options` has the members of WorkerOptions; `one` is what a process does, "cell".
template <typename Options>
void add_worker_options(CLI::App& command, Options& options, const std::string& one) {
  options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command.add_option("--jobs", options.jobs, one + "s at a time (default: the cores)")->check(CLI::Range(1, 1024));
  command.add_option("--timeout", options.timeout_s, "wall time for one " + one + " [s]; 0: none")
      ->check(number_between(0.0, 1e9));
  command
      .add_option("--memory-limit", options.memory_limit_MB,
                  "addresses for one " + one + " [MB] (default 4000); 0: no limit")
      ->check(CLI::Range(0L, 1'000'000'000L))
      ->type_name("MB");
}

}  // namespace dob
