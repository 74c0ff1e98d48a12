// What the last bits of a result depend on beside the program's source, compiler and flags: which version of the model
// was compiled in, and which of its functions the C library takes on this processor.
#pragma once

#include <string>
#include <string_view>

namespace dob {

struct CodePath {
  std::string model;      // of robot/lanes.h: "portable", or "AVX2+FMA" where the compiler was allowed to use them
  std::string libraries;  // the C library's and Eigen's version, fingerprints of libm and ODE as they are loaded
  std::string cpu_flags;  // by which libm chooses among its versions, as far as the C library may use them: "avx fma"

  friend bool operator==(const CodePath&, const CodePath&) = default;
};

// Of this program, here and now. GLIBC_TUNABLES (glibc.cpu.hwcaps) counts. What cannot be found out is "unknown".
CodePath this_code_path();

// The program, as far as the bits of a row depend on it, and what it ran on.
struct Provenance {
  std::string version, commit, build, compiler, flags;
  CodePath path;

  friend bool operator==(const Provenance&, const Provenance&) = default;
};

// "commit: 'a' there, 'b' here; flags: ...", for what differs ("not kept" for what is empty); "" when nothing does.
std::string differences(const Provenance& there, const Provenance& here);

}  // namespace dob
