#include "results/machine.h"

#include <ctime>
#include <fstream>
#include <sched.h>
#include <sys/utsname.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace dob {
namespace {

// The rest of the first line of a file that starts with `key`, without blanks and quotes around it.
std::string value_of(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t first = line.find_first_not_of(" \t:=\"", key.size());
    const std::size_t last = line.find_last_not_of(" \t\"");
    if (first != std::string::npos) return line.substr(first, last - first + 1);
  }
  return "unknown";
}

int usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace

Machine this_machine() {
  utsname kernel{};
  const bool known = uname(&kernel) == 0;
  const std::string release = known ? fmt::format("{} {}", kernel.sysname, kernel.release) : "unknown";
  return {value_of("/proc/cpuinfo", "model name"), usable_cores(),
          value_of("/etc/os-release", "PRETTY_NAME") + ", " + release};
}

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace dob
