// What this program was built from and how.
#pragma once

#include <string>

namespace dob {

struct BuildInfo {
  std::string version, commit, build_type, compiler, flags;
};

BuildInfo build_info();

}  // namespace dob
