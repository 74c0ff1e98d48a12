// The machine a run was made on, for its record.
#pragma once

#include <string>

namespace dob {

struct Machine {
  std::string cpu;  // model name
  int cores = 0;    // logical, usable by this process
  std::string os;   // distribution, kernel
};

// What cannot be found out is "unknown".
Machine this_machine();

// Now, UTC, as 2021-08-27T12:34:56Z.
std::string utc_now();

}  // namespace dob
