#include "results/code_path.h"

#include <algorithm>
#include <filesystem>
#include <link.h>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/fingerprint.h"
#include "robot/lanes.h"

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif
#if defined(__GLIBC__) && defined(__x86_64__) && __has_include(<sys/platform/x86.h>)
#if defined(__clang__)
#define _Bool bool  // NOLINT: the header's own name for it, which clang does not know in C++ without extensions
#endif
#include <sys/platform/x86.h>
#define DOB_GLIBC_CPU_FEATURES
#endif

namespace dob {
namespace {

std::string c_library() {
#if defined(__GLIBC__)
  return std::string("glibc ") + gnu_get_libc_version();
#else
  return "unknown C library";
#endif
}

// Those that compute: another build of them is another program.
bool computes(std::string_view name) {
  return name.starts_with("libm.so") || name.starts_with("libode.so") || name.starts_with("libccd.so");
}

int add_library(dl_phdr_info* info, std::size_t /*size*/, void* list) {
  const std::filesystem::path file = info->dlpi_name;
  const std::string name = file.filename().string();
  if (!computes(name)) return 0;
  std::string held = "unknown";
  try {
    held = file_fingerprint(file);
  } catch (const std::exception&) {  // it is loaded, and cannot be read again
  }
  static_cast<std::vector<std::string>*>(list)->push_back(name + " " + held);
  return 0;
}

std::string libraries() {
  std::vector<std::string> list{
      c_library(), fmt::format("Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)};
  ::dl_iterate_phdr(add_library, &list);
  std::sort(list.begin() + 2, list.end());  // the order in which they were loaded means nothing
  return fmt::format("{}", fmt::join(list, ", "));
}

// sysdeps/x86_64/fpu/multiarch/ of glibc: its functions exist for FMA with AVX2, FMA4, AVX, SSE4.1 and any x86-64.
std::string cpu_flags() {
#if defined(DOB_GLIBC_CPU_FEATURES)
  std::vector<std::string_view> flags;
  if (CPU_FEATURE_ACTIVE(SSE4_1)) flags.emplace_back("sse4.1");
  if (CPU_FEATURE_ACTIVE(AVX)) flags.emplace_back("avx");
  if (CPU_FEATURE_ACTIVE(FMA4)) flags.emplace_back("fma4");
  if (CPU_FEATURE_ACTIVE(AVX2)) flags.emplace_back("avx2");
  if (CPU_FEATURE_ACTIVE(FMA)) flags.emplace_back("fma");
  return flags.empty() ? "none" : fmt::format("{}", fmt::join(flags, " "));
#else
  return "unknown";
#endif
}

}  // namespace

CodePath this_code_path() {
  return {kLanes == 4 ? "AVX2+FMA" : "portable", libraries(), cpu_flags()};
}

std::string differences(const Provenance& there, const Provenance& here) {
  std::vector<std::string> different;
  const auto quoted = [](const std::string& text) { return text.empty() ? "not kept" : fmt::format("'{}'", text); };
  const auto compare = [&](std::string_view what, const std::string& a, const std::string& b) {
    if (a != b) different.push_back(fmt::format("{}: {} there, {} here", what, quoted(a), quoted(b)));
  };
  compare("version", there.version, here.version);
  compare("commit", there.commit, here.commit);
  compare("build", there.build, here.build);
  compare("compiler", there.compiler, here.compiler);
  compare("flags", there.flags, here.flags);
  compare("model path", there.path.model, here.path.model);
  compare("libraries", there.path.libraries, here.path.libraries);
  compare("CPU flags", there.path.cpu_flags, here.path.cpu_flags);
  return fmt::format("{}", fmt::join(different, "; "));
}

}  // namespace dob
